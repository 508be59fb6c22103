#include "analyzer/readers/vtk_series.hpp"

#include <algorithm>
#include <array>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "analyzer/readers/named_files.hpp"
#include "analyzer/readers/xml_tree.hpp"
#include "common/error.hpp"
#include "common/number.hpp"
#include "common/tables/text_cursor.hpp"

namespace recoat {
namespace {

/// The attribute `type` of <VTKFile>, or empty.
std::string_view file_type(std::string_view head) {
    const std::size_t tag = head.find("<VTKFile");
    if (tag == std::string_view::npos) return {};
    head = head.substr(tag, head.find('>', tag) - tag);
    const std::size_t attribute = head.find(" type=");
    if (attribute == std::string_view::npos || attribute + 6 >= head.size()) return {};
    head.remove_prefix(attribute + 6);
    const std::size_t end = head.find(head[0], 1);
    return end == std::string_view::npos ? std::string_view{} : head.substr(1, end - 1);
}

bool names_steps(const Content& content) { return is_vtk_collection(content) || is_vtk_series(content); }
bool holds_particles(const Content& content) { return !names_steps(content) && !is_vtk_pieces(content); }
bool holds_one_step(const Content& content) { return !names_steps(content); }

std::string place_of(const Content& content, const XmlElement& element) {
    return fmt::format("{}:{}", content.name(), element.line);
}

NamedFile file_of(const Content& content, const XmlElement& element, const std::string& attribute) {
    const std::string name = element.attribute(attribute), place = place_of(content, element);
    if (!name.empty()) return {name, place};
    throw InputError(fmt::format("{}: the element {} names no file ({}); copy the head again from where it was made",
                                 place, quotable(element.name), attribute));
}

/// Pieces name their source, blocks their file, which may be left out where a block is empty.
void collect_pieces(const Content& content, const XmlElement& element, NamedStep& step) {
    for (const XmlElement& child : element.children) {
        if (child.name == "Piece") {
            step.files.push_back(file_of(content, child, "Source"));
        } else if (child.name == "DataSet" && !child.attribute("file").empty()) {
            step.files.push_back(file_of(content, child, "file"));
        } else {
            collect_pieces(content, child, step);
        }
    }
}

/// Whether a data set of a collection is one more part of the step rather than the same part anew.
bool belongs_to(const std::vector<const XmlElement*>& parts, const XmlElement& next) {
    const auto key = [](const XmlElement& part) {
        return std::array{part.attribute("group"), part.attribute("part"), part.attribute("name")};
    };
    return std::ranges::none_of(parts, [&](const XmlElement* part) { return key(*part) == key(next); });
}

std::vector<NamedStep> steps_of_collection(const Content& content, const XmlElement& collection) {
    std::vector<NamedStep> steps;
    std::vector<const XmlElement*> parts;  // of the last step
    for (const XmlElement& set : collection.children) {
        if (set.name != "DataSet") continue;
        const auto time = parse_number(set.attribute("timestep", "0"));
        if (!time) {
            throw InputError(fmt::format("{}: the time step \"{}\" is no number; correct it", place_of(content, set),
                                         quotable(set.attribute("timestep"))));
        }
        if (steps.empty() || steps.back().time != *time || !belongs_to(parts, set)) {
            steps.push_back({{}, *time});
            parts.clear();
        }
        steps.back().files.push_back(file_of(content, set, "file"));
        parts.push_back(&set);
    }
    return steps;
}

std::vector<NamedStep> require_some(const Content& content, std::vector<NamedStep> steps) {
    if (!steps.empty()) return steps;
    throw InputError(fmt::format("{}: the file names no files of particles; give those themselves", content.name()));
}

/// Entries "name" and "time" of a list "files".
std::vector<NamedStep> steps_of_json(const Content& content) {
    const auto json = nlohmann::json::parse(content.bytes, nullptr, false);
    const auto fail = [&](const std::string& problem) {
        throw InputError(
            fmt::format("{}: {}; write {{\"file-series-version\": \"1.0\", \"files\": [{{\"name\": "
                        "\"layer.vtk\", \"time\": 0}}]}}",
                        content.name(), problem));
    };
    if (json.is_discarded()) fail("the file is no whole JSON");
    if (!json.is_object() || !json.contains("files") || !json["files"].is_array()) fail("there is no list \"files\"");
    std::vector<NamedStep> steps;
    for (const auto& file : json["files"]) {
        const bool good = file.is_object() && file.contains("name") && file["name"].is_string();
        if (!good) fail(fmt::format("the entry {} of \"files\" has no name", steps.size()));
        const bool has_time = file.contains("time") && file["time"].is_number();
        const double time = has_time ? file["time"].get<double>() : static_cast<double>(steps.size());
        steps.push_back({{{file["name"].get<std::string>(), content.name()}}, time});
    }
    return steps;
}

}  // namespace

bool is_vtk_pieces(const Content& content) {
    constexpr std::array<std::string_view, 5> types = {"PUnstructuredGrid", "PPolyData", "vtkMultiBlockDataSet",
                                                       "vtkPartitionedDataSet", "vtkPartitionedDataSetCollection"};
    return std::ranges::find(types, file_type(content.head())) != types.end();
}

bool is_vtk_collection(const Content& content) { return file_type(content.head()) == "Collection"; }

bool is_vtk_series(const Content& content) {
    return trimmed(content.head()).starts_with('{') &&
           content.head().find("\"file-series-version\"") != std::string_view::npos;
}

Series open_vtk_pieces(const Content& content, const ReadOptions& options) {
    NamedStep step;
    collect_pieces(content, parse_xml(content.bytes, content.name(), "AppendedData").root, step);
    std::vector<NamedStep> steps;
    if (!step.files.empty()) steps.push_back(std::move(step));
    return single_step([&content, &options, all = require_some(content, std::move(steps))] {
        Source source = read_named_files(content, all[0], options, holds_particles);
        source.facts.emplace_back("files", std::to_string(all[0].files.size()));
        return source;
    });
}

Series open_vtk_collection(const Content& content, const ReadOptions& options) {
    const XmlDocument document = parse_xml(content.bytes, content.name(), "AppendedData");
    const XmlElement* collection = document.root.child("Collection");
    std::vector<NamedStep> steps;
    if (collection != nullptr) steps = steps_of_collection(content, *collection);
    return named_series(content, require_some(content, std::move(steps)), options, holds_one_step);
}

Series open_vtk_series(const Content& content, const ReadOptions& options) {
    return named_series(content, require_some(content, steps_of_json(content)), options, holds_one_step);
}

}  // namespace recoat
