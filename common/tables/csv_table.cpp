#include "common/tables/csv_table.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include <fmt/format.h>

#include "common/number.hpp"
#include "common/tables/csv_header.hpp"
#include "common/text_encoding.hpp"

namespace recoat {
namespace {

class CsvReader {
public:
    CsvReader(const std::string& name, std::string_view text, const CsvOptions& options)
        : cursor_(name, without_byte_order_mark(text)),
          header_(read_csv_header(cursor_, options.columns)),
          allows_size_zero_(options.allows_size_zero),
          about_size_zero_(options.about_size_zero) {
        try {
            find_columns(options);
        } catch (const ColumnError& error) {
            cursor_.fail(error.what());
        }
    }

    CsvTable read() {
        while (cursor_.next_filled()) {
            if (!next_row()) continue;
            table_.position.push_back(vector(columns_.position, position_factors_));
            if (columns_.size) table_.radius.push_back(size());
            if (columns_.id) table_.id.push_back(identity());
            if (columns_.velocity) table_.velocity.push_back(any_vector(*columns_.velocity, velocity_factors_));
            if (columns_.angular_velocity) {
                table_.angular_velocity.push_back(any_vector(*columns_.angular_velocity, spin_factors_));
            }
            if (columns_.type) table_.type.push_back(cursor_.cells()[*columns_.type]);
            table_.line.push_back(cursor_.line_number());
        }
        if (!cursor_.has_line_end() && !trimmed(cursor_.line()).empty()) {
            table_.warnings.push_back(
                fmt::format("{}:{}: the last line has no line end; if the file was cut there, its last number is wrong",
                            cursor_.name(), cursor_.line_number()));
        }
        return std::move(table_);
    }

private:
    void find_columns(const CsvOptions& options) {
        Header& header = header_.columns;
        try {
            columns_ = find_particle_columns(header, options.columns);
        } catch (const ColumnError& error) {
            throw ColumnError(fmt::format("{}; {}", error.what(), options.naming));
        }
        if (!columns_.size && options.needs_size) {
            throw ColumnError(
                fmt::format("there is no column \"radius\" or \"diameter\" among those of the file ({}); {}",
                            quotable_list(header.names()), options.naming));
        }
        const auto part = find_part_of_velocity(header.bare_names());
        if (options.whole_velocities && part) {
            throw ColumnError(
                fmt::format("the column \"{}\" is one component of a velocity, but not all three are there; "
                            "give all, or none",
                            quotable(header.names()[*part])));
        }
        position_factors_ = factors(columns_.position, Dimension::length);
        if (columns_.size) {
            size_factor_ = columns_.size->to_radius * header.factor(columns_.size->index, Dimension::length);
        }
        if (columns_.velocity) velocity_factors_ = factors(*columns_.velocity, Dimension::speed);
        if (columns_.angular_velocity) {
            spin_factors_ = factors(*columns_.angular_velocity, Dimension::angular_velocity);
        }
        std::vector<std::size_t> lengths(columns_.position.begin(), columns_.position.end());
        if (columns_.size) lengths.push_back(columns_.size->index);
        table_.has_units = lengths_have_units(header, lengths);
        table_.columns = header.names();
        list_unused();
    }

    [[nodiscard]] Vec3 factors(const VectorColumns& columns, Dimension dimension) const {
        const Header& header = header_.columns;
        return {header.factor(columns[0], dimension), header.factor(columns[1], dimension),
                header.factor(columns[2], dimension)};
    }

    void list_unused() {
        std::vector<bool> used(header_.columns.size());
        const auto use = [&](const VectorColumns& columns) {
            for (const std::size_t column : columns) used[column] = true;
        };
        use(columns_.position);
        if (columns_.velocity) use(*columns_.velocity);
        if (columns_.angular_velocity) use(*columns_.angular_velocity);
        if (columns_.size) used[columns_.size->index] = true;
        if (columns_.id) used[*columns_.id] = true;
        for (std::size_t i = 0; i < used.size(); ++i) {
            if (!used[i]) table_.unused.push_back(header_.columns.names()[i]);
        }
    }

    /// Cuts the line; false when it is a comment or has only empty cells.
    bool next_row() {
        if (is_csv_comment(cursor_.line())) return false;
        if (cursor_.line().find('"') == std::string_view::npos) cursor_.drop_comment('#');
        cursor_.split_quoted(header_.separator);
        const auto& cells = cursor_.cells();
        const auto is_empty = [](std::string_view cell) { return cell.empty(); };
        if (cells.front().empty() && std::ranges::all_of(cells, is_empty)) return false;
        const std::size_t columns = header_.columns.size();
        const bool rest_is_empty =
            cells.size() > columns &&
            std::all_of(cells.begin() + static_cast<std::ptrdiff_t>(columns), cells.end(), is_empty);
        if (cells.size() == columns || rest_is_empty) return true;
        const bool commas = header_.separator == ',' && cells.size() == 2 * columns;
        cursor_.fail(
            fmt::format("the line has {} columns, the first line names {}; make them agree{}", cells.size(), columns,
                        commas ? " (numbers with decimal commas need semicolons between them, or quotes)" : ""));
    }

    /// A number with a decimal point or comma, whichever the first number of the file has that has either.
    [[nodiscard]] double any_number(std::size_t column) {
        const std::string_view cell = cursor_.cells()[column];
        if (mark_ == '\0') {
            const std::size_t place = cell.find_first_of(".,");
            if (place != std::string_view::npos) mark_ = cell[place];
        }
        const auto value = mark_ == ',' ? parse_number_with_comma(cell) : parse_number(cell);
        if (value) return *value;
        fail_at(column, mark_ == ','                    ? "this is no number with a decimal comma, as those before"
                        : parse_number_with_comma(cell) ? "this has a decimal comma, but those before a decimal point"
                                                        : "this is no number");
    }

    [[nodiscard]] double number(std::size_t column) {
        const double value = any_number(column);
        if (!std::isfinite(value)) fail_at(column, "the number is not finite");
        return value;
    }

    [[noreturn]] void fail_at(std::size_t column, std::string_view problem) const {
        cursor_.fail_at(column, header_.columns.names()[column], std::string(problem));
    }

    [[nodiscard]] Vec3 vector(const VectorColumns& columns, const Vec3& factors) {
        const double x = number(columns[0]), y = number(columns[1]), z = number(columns[2]);
        return {factors.x * x, factors.y * y, factors.z * z};
    }

    /// Not a number where a cell is empty, as tables are written from numbers that are none.
    [[nodiscard]] double number_or_nothing(std::size_t column) {
        return cursor_.cells()[column].empty() ? std::numeric_limits<double>::quiet_NaN() : any_number(column);
    }

    [[nodiscard]] Vec3 any_vector(const VectorColumns& columns, const Vec3& factors) {
        const double x = number_or_nothing(columns[0]), y = number_or_nothing(columns[1]),
                     z = number_or_nothing(columns[2]);
        return {factors.x * x, factors.y * y, factors.z * z};
    }

    [[nodiscard]] double size() {
        const double value = number(columns_.size->index);
        if (value < 0) fail_at(columns_.size->index, "a particle must have a size above zero");
        if (value == 0 && !allows_size_zero_) fail_at(columns_.size->index, about_size_zero_);
        return size_factor_ * value;
    }

    /// Some programs write whole numbers as 12.0.
    [[nodiscard]] std::int64_t identity() {
        const std::string_view cell = cursor_.cells()[*columns_.id];
        if (const auto whole = parse_integer(cell)) return *whole;
        const std::size_t mark = std::min(cell.find_first_of(".,"), cell.size());
        const bool only_zeros = cell.find_first_not_of('0', mark + 1) == std::string_view::npos;
        if (const auto whole = parse_integer(cell.substr(0, mark)); whole && only_zeros) return *whole;
        const double value = number(*columns_.id);
        constexpr double largest = 0x1p53;
        if (value != std::floor(value) || std::abs(value) > largest) {
            fail_at(*columns_.id, "this is no whole number of 64 bits");
        }
        return static_cast<std::int64_t>(value);
    }

    TextCursor cursor_;
    CsvHeader header_;
    ParticleColumns columns_;
    Vec3 position_factors_, velocity_factors_, spin_factors_;
    double size_factor_ = 1;
    bool allows_size_zero_ = false;
    std::string_view about_size_zero_;
    char mark_ = '\0';  ///< of decimals; '\0': not seen yet
    CsvTable table_;
};

}  // namespace

CsvTable read_csv_table(const std::string& name, std::string_view text, const CsvOptions& options) {
    return CsvReader(name, text, options).read();
}

}  // namespace recoat
