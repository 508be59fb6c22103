#include "solver/scene/particle_csv.hpp"

#include <array>
#include <cmath>
#include <fstream>
#include <string>
#include <string_view>

#include "common/error.hpp"
#include "common/number.hpp"

namespace recoat {
namespace {

constexpr std::array<std::string_view, 10> columns = {"x", "y", "z", "radius", "vx", "vy", "vz", "wx", "wy", "wz"};
constexpr std::string_view header = "x,y,z,radius,vx,vy,vz,wx,wy,wz";

class CsvReader {
public:
    explicit CsvReader(const std::filesystem::path& file) : file_(file), stream_(file) {
        if (!stream_) throw InputError(file.string() + ": the table of particles cannot be opened; check the path");
    }

    ParticleTable read() {
        std::string line;
        if (!next(line) || header_of(line) != header) {
            fail("the header is missing; the first line must be " + std::string(header));
        }
        while (next(line)) add_row(line);
        if (table_.size() == 0) fail("the table has no particles; add a line for each");
        return std::move(table_);
    }

private:
    [[noreturn]] void fail(const std::string& sentence) const {
        throw InputError(file_.string() + ":" + std::to_string(line_) + ": " + sentence);
    }

    /// The next line that is neither empty nor a comment.
    bool next(std::string& line) {
        while (std::getline(stream_, line)) {
            ++line_;
            const std::string_view text = trimmed(line);
            if (!text.empty() && text.front() != '#') return true;
        }
        return false;
    }

    static std::string header_of(std::string_view line) {
        std::string result;
        for (char c : line) {
            if (c != ' ' && c != '\r' && c != '\t') result += c;
        }
        return result;
    }

    void add_row(std::string_view line) {
        std::array<double, columns.size()> row{};
        std::size_t count = 0;
        for (std::string_view rest = line; count <= columns.size(); ++count) {
            const std::size_t comma = rest.find(',');
            if (count < columns.size()) row[count] = value(trimmed(rest.substr(0, comma)), columns[count]);
            if (comma == std::string_view::npos) break;
            rest.remove_prefix(comma + 1);
        }
        if (count + 1 != columns.size()) {
            fail("the line has " + std::string(count + 1 < columns.size() ? "fewer" : "more") +
                 " than 10 values; give " + std::string(header));
        }
        if (row[3] <= 0) fail("radius: a particle needs a positive radius in metres");
        table_.position.push_back({row[0], row[1], row[2]});
        table_.radius.push_back(row[3]);
        table_.velocity.push_back({row[4], row[5], row[6]});
        table_.angular_velocity.push_back({row[7], row[8], row[9]});
    }

    double value(std::string_view text, std::string_view column) const {
        const std::optional<double> number = parse_number(text);
        if (!number || !std::isfinite(*number)) {
            fail(std::string(column) + ": \"" + std::string(text) +
                 "\" is not a finite number; give SI values without units");
        }
        return *number;
    }

    std::filesystem::path file_;
    std::ifstream stream_;
    std::int64_t line_ = 0;
    ParticleTable table_;
};

}  // namespace

ParticleTable read_particle_csv(const std::filesystem::path& file) { return CsvReader(file).read(); }

}  // namespace recoat
