#include "analyzer/readers/legacy_vtk.hpp"

#include <array>

#include <fmt/format.h>

#include "analyzer/readers/legacy_vtk_scanner.hpp"
#include "analyzer/readers/vtk_points.hpp"
#include "common/tables/text_cursor.hpp"

namespace recoat {
namespace {

class LegacyReader {
public:
    LegacyReader(const Content& content, const ColumnNames& chosen)
        : scanner_(content.name(), content.bytes), chosen_(chosen) {}

    VtkPoints read() {
        scanner_.read_head();
        while (true) {
            const std::string word = scanner_.keyword();
            if (word.empty()) break;
            if (!read_structure(word) && !read_attribute(word)) {
                scanner_.fail(
                    fmt::format("\"{}\" is no keyword of a VTK file here; copy the file again from where it "
                                "was made",
                                quotable(word)));
            }
        }
        scanner_.need_line_end();
        if (!has_points_) scanner_.fail("the file ends without POINTS; give one with particles");
        return std::move(points_);
    }

private:
    bool read_structure(const std::string& word) {
        if (word == "DATASET") {
            const std::string kind = scanner_.word("kind of data set");
            if (kind != "POLYDATA" && kind != "UNSTRUCTURED_GRID") {
                scanner_.fail(
                    fmt::format("the data set is of the kind {}, which holds no particles; give POLYDATA or "
                                "UNSTRUCTURED_GRID",
                                quotable(kind)));
            }
        } else if (word == "POINTS") {
            read_points();
        } else if (word == "VERTICES" || word == "LINES" || word == "POLYGONS" || word == "TRIANGLE_STRIPS" ||
                   word == "CELLS") {
            skip_cells();
        } else if (word == "CELL_TYPES") {
            scanner_.skip(scanner_.count("number of cells"), "int");
        } else if (word == "METADATA") {
            scanner_.skip_metadata();
        } else if (word == "POINT_DATA" || word == "CELL_DATA") {
            of_points_ = word == "POINT_DATA";
            tuples_ = scanner_.count("number of tuples");
            if (of_points_ && tuples_ != points_.position.size()) {
                scanner_.fail(fmt::format("there are data for {} points, but the file has {}; make them agree", tuples_,
                                          points_.position.size()));
            }
        } else {
            return false;
        }
        return true;
    }

    void read_points() {
        if (has_points_) scanner_.fail("the file has POINTS twice; give one with a single data set");
        const std::size_t count = scanner_.count("number of points");
        const std::string type = scanner_.word("type");
        const std::vector<double> flat = scanner_.numbers(count, 3, type);
        points_.append_positions(flat);
        has_points_ = true;
    }

    /// Before version 5 one list of counts and indices, since then offsets and connectivity.
    void skip_cells() {
        const std::size_t first = scanner_.count("number of cells");
        const std::size_t second = scanner_.count("length of the cells");
        if (!scanner_.follows("OFFSETS")) return scanner_.skip(second, "int");
        (void)scanner_.keyword();
        scanner_.skip(first, scanner_.word("type"));
        if (scanner_.keyword() != "CONNECTIVITY") scanner_.fail("after OFFSETS must follow CONNECTIVITY");
        scanner_.skip(second, scanner_.word("type"));
    }

    bool read_attribute(const std::string& word) {
        struct Kind {
            std::string_view name;
            std::size_t components;
        };
        constexpr std::array<Kind, 3> fixed = {{{"VECTORS", 3}, {"NORMALS", 3}, {"TENSORS", 9}}};
        for (const Kind& kind : fixed) {
            if (word != kind.name) continue;
            const std::string name = scanner_.word("name");
            keep_or_skip(name, tuples_, kind.components, scanner_.word("type"), of_points_);
            return true;
        }
        if (word == "SCALARS") {
            read_scalars();
        } else if (word == "FIELD") {
            read_field();
        } else if (word == "TEXTURE_COORDINATES") {
            (void)scanner_.word("name");
            const std::size_t components = scanner_.count("number of components");
            scanner_.skip_tuples(tuples_, components, scanner_.word("type"));
        } else if (word == "COLOR_SCALARS") {
            (void)scanner_.word("name");
            scanner_.skip_tuples(tuples_, scanner_.count("number of components"), scanner_.colour_type());
        } else if (word == "LOOKUP_TABLE") {
            (void)scanner_.word("name");
            scanner_.skip_tuples(scanner_.count("size"), 4, scanner_.colour_type());
        } else {
            return false;
        }
        return true;
    }

    void read_scalars() {
        const std::string name = scanner_.word("name");
        const std::string type = scanner_.word("type");
        const std::size_t components = scanner_.rest_of_line().empty() ? 1 : scanner_.count("number of components");
        if (scanner_.follows("LOOKUP_TABLE")) {
            (void)scanner_.keyword();
            (void)scanner_.word("name");
        }
        keep_or_skip(name, tuples_, components, type, of_points_);
    }

    /// Arrays of any length under a common name.
    void read_field() {
        (void)scanner_.word("name");
        const std::size_t arrays = scanner_.count("number of arrays");
        for (std::size_t i = 0; i < arrays; ++i) {
            std::string name = scanner_.keyword();
            for (; name == "METADATA"; name = scanner_.keyword()) scanner_.skip_metadata();
            if (name.empty()) scanner_.fail(fmt::format("the file ends here, but {} arrays should follow", arrays - i));
            const std::size_t components = scanner_.count("number of components");
            const std::size_t tuples = scanner_.count("number of tuples");
            const std::string type = scanner_.word("type");
            keep_or_skip(name, tuples, components, type, of_points_ && tuples == points_.position.size());
        }
    }

    void keep_or_skip(const std::string& name, std::size_t tuples, std::size_t components, const std::string& type,
                      bool of_points) {
        if (of_points) points_.offer(name);
        if (!of_points || !VtkPoints::wanted(name, components, chosen_) || points_.find(name, components)) {
            return scanner_.skip_tuples(tuples, components, type);
        }
        if (VtkPoints::holds_identities(name, components)) {
            LegacyVtkScanner ahead = scanner_;
            points_.append_identities(ahead.whole_numbers(tuples, type));
        }
        points_.append(name, components, scanner_.numbers(tuples, components, type));
    }

    LegacyVtkScanner scanner_;
    const ColumnNames& chosen_;
    VtkPoints points_;
    bool has_points_ = false, of_points_ = false;
    std::size_t tuples_ = 0;
};

}  // namespace

bool is_legacy_vtk(const Content& content) { return content.bytes.starts_with("# vtk DataFile"); }

Series open_legacy_vtk(const Content& content, const ReadOptions& options) {
    return single_step(
        [&] { return particles_from(LegacyReader(content, options.columns).read(), options.columns, content.name()); });
}

}  // namespace recoat
