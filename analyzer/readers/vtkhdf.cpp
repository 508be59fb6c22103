#include "analyzer/readers/vtkhdf.hpp"

#include <algorithm>
#include <memory>
#include <numeric>

#include <fmt/format.h>

#include "analyzer/readers/vtk_points.hpp"
#include "analyzer/readers/vtk_types.hpp"
#include "common/error.hpp"
#include "common/hdf5.hpp"
#include "common/number.hpp"
#include "common/tables/text_cursor.hpp"

namespace recoat {
namespace {

constexpr const char* group_name = "VTKHDF";

/// Rows of an array.
struct Rows {
    std::size_t first = 0, count = 0;
};

bool holds_points(const std::string& type) { return type == "PolyData" || type == "UnstructuredGrid"; }

bool gives_sizes(const hdf5::Group& data_set, const ColumnNames& chosen) {
    if (!data_set.has("PointData")) return false;
    std::vector<std::string> names = data_set.group("PointData").names();
    std::ranges::transform(names, names.begin(), lower_case);
    for (const std::string* own : {&chosen.radius, &chosen.diameter}) {
        if (!own->empty()) return find_column(names, *own).has_value();
    }
    return find_usual_size(names).has_value();
}

/// The data set of the particles: the only one with points in a collection, or the only one that gives their sizes.
hdf5::Group data_set_of(hdf5::Group root, const ColumnNames& chosen, const std::string& file) {
    const std::string type = root.text_attribute("Type");
    if (type != "PartitionedDataSetCollection" && type != "MultiBlockDataSet") return root;
    std::vector<std::string> names, points, sized;
    for (const std::string& name : root.names()) {
        const hdf5::Group data_set = root.group(name);
        if (!data_set.has_attribute("Type")) continue;  // how the data sets belong together
        names.push_back(name);
        if (!holds_points(data_set.text_attribute("Type"))) continue;
        points.push_back(name);
        if (gives_sizes(data_set, chosen)) sized.push_back(name);
    }
    if (points.size() == 1) return root.group(points.front());
    if (sized.size() == 1) return root.group(sized.front());
    throw InputError(fmt::format(
        "{}: the file is a collection of data sets ({}), {} of them with particles; save the one to read as "
        "PolyData in a file of its own",
        file, quotable_list(names), sized.empty() ? "none" : "several"));
}

class VtkHdfReader {
public:
    VtkHdfReader(const Content& content, const ColumnNames& chosen)
        : file_(content.name()),
          chosen_(chosen),
          root_(data_set_of(hdf5::File::open(content.file).group(group_name), chosen, file_)) {
        const std::string type = root_.text_attribute("Type");
        if (!holds_points(type)) {
            fail(
                fmt::format("the data set is of the kind \"{}\", which holds no particles; give PolyData or "
                            "UnstructuredGrid",
                            quotable(type)));
        }
        const hdf5::Shape shape = root_.dataset("Points").shape();
        if (shape.size() != 2 || shape[1] != 3) fail("the array Points has not three columns; give points in space");
        rows_ = shape[0];
        if (root_.has("Steps")) read_times();
    }

    [[nodiscard]] std::vector<std::int64_t> steps() const {
        std::vector<std::int64_t> numbers(std::max<std::size_t>(1, times_.size()));
        std::iota(numbers.begin(), numbers.end(), std::int64_t{0});
        return numbers;
    }

    [[nodiscard]] const std::vector<double>& times() const { return times_; }

    [[nodiscard]] Source read(std::size_t step) const {
        const Rows rows = rows_of(step);
        VtkPoints points;
        points.append_positions(root_.dataset("Points").read_rows<double>(rows.first, rows.count));
        if (root_.has("PointData")) read_arrays(points, step, rows);
        Source source = particles_from(std::move(points), chosen_, file_);
        if (times_.empty()) return source;
        source.facts.emplace_back("steps", std::to_string(times_.size()));
        source.facts.emplace_back("time", shortest(times_[step]));
        return source;
    }

private:
    void read_times() {
        const auto steps = root_.group("Steps");
        const std::int64_t count = steps.integer_attribute("NSteps");
        if (count < 1) fail(fmt::format("the file says that it has {} time steps; give one with particles", count));
        times_ = steps.dataset("Values").read_rows<double>(0, static_cast<std::size_t>(count));
    }

    /// Where the points of a step lie: its parts follow each other.
    [[nodiscard]] Rows rows_of(std::size_t step) const {
        if (times_.empty() && !root_.has("NumberOfPoints")) return {0, rows_};
        const auto numbers = root_.dataset("NumberOfPoints");
        if (times_.empty()) return {0, sum(numbers.read<std::int64_t>())};
        const auto steps = root_.group("Steps");
        const std::size_t part = steps.has("PartOffsets") ? natural(steps, "PartOffsets", step) : step;
        const std::size_t parts = steps.has("NumberOfParts") ? natural(steps, "NumberOfParts", step) : 1;
        return {natural(steps, "PointOffsets", step), sum(numbers.read_rows<std::int64_t>(part, parts))};
    }

    void read_arrays(VtkPoints& points, std::size_t step, Rows rows) const {
        const auto arrays = root_.group("PointData");
        for (const std::string& name : arrays.names()) {
            points.offer(name);
            if (!VtkPoints::wanted(name, 1, chosen_) && !VtkPoints::wanted(name, 3, chosen_)) continue;
            const auto array = arrays.dataset(name);
            const hdf5::Shape shape = array.shape();
            const std::size_t components = shape.size() == 1 ? 1 : shape.size() == 2 ? shape[1] : 0;
            if (!VtkPoints::wanted(name, components, chosen_) || points.find(name, components)) continue;
            const std::size_t first = first_row(name, step, rows);
            points.append(name, components, array.read_rows<double>(first, rows.count));
            if (VtkPoints::holds_identities(name, components)) {
                points.append_identities(whole_numbers(array, points.arrays.back(), first, rows.count));
            }
        }
    }

    /// To the last bit where the array holds whole numbers, else where its real numbers are whole.
    static std::optional<std::vector<std::int64_t>> whole_numbers(const hdf5::Dataset& array,
                                                                  const std::vector<double>& values, std::size_t first,
                                                                  std::size_t count) {
        if (array.holds_integers()) return array.read_rows<std::int64_t>(first, count);
        std::vector<std::int64_t> result;
        for (const double real : values) {
            const auto whole = whole_number(real);
            if (!whole) return {};
            result.push_back(*whole);
        }
        return result;
    }

    /// Arrays that do not change may be there once.
    [[nodiscard]] std::size_t first_row(const std::string& name, std::size_t step, Rows rows) const {
        const std::string place = "Steps/PointDataOffsets";
        if (times_.empty() || !root_.has("Steps/PointDataOffsets") || !root_.group(place).has(name)) return rows.first;
        return natural(root_.group(place), name, step);
    }

    [[nodiscard]] std::size_t natural(const hdf5::Group& group, const std::string& name, std::size_t row) const {
        const auto values = group.dataset(name).read_rows<std::int64_t>(row, 1);
        if (values.size() != 1 || values[0] < 0) {
            fail(fmt::format("the array {} holds no number of rows for step {}; the file seems damaged", name, row));
        }
        return static_cast<std::size_t>(values[0]);
    }

    [[nodiscard]] std::size_t sum(const std::vector<std::int64_t>& counts) const {
        std::size_t total = 0;
        for (const std::int64_t count : counts) {
            if (count < 0 || static_cast<std::size_t>(count) > rows_ - total) {
                fail(fmt::format("NumberOfPoints holds {}, but there are {} points in all; the file seems damaged",
                                 count, rows_));
            }
            total += static_cast<std::size_t>(count);
        }
        return total;
    }

    [[noreturn]] void fail(const std::string& problem) const {
        throw InputError(fmt::format("{}: {}", file_, problem));
    }

    std::string file_;
    const ColumnNames& chosen_;
    hdf5::Group root_;
    std::size_t rows_ = 0;  ///< of the array Points
    std::vector<double> times_;
};

}  // namespace

bool is_vtkhdf(const Content& content) { return content.is_hdf5() && hdf5::File::open(content.file).has(group_name); }

Series open_vtkhdf(const Content& content, const ReadOptions& options) {
    const auto reader = std::make_shared<const VtkHdfReader>(content, options.columns);
    return {.steps = reader->steps(),
            .read = [reader](std::size_t step) { return reader->read(step); },
            .times = reader->times()};
}

}  // namespace recoat
