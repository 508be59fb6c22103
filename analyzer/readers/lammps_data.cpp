#include "analyzer/readers/lammps_data.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include <fmt/format.h>

#include "analyzer/readers/lammps_velocities.hpp"
#include "common/number.hpp"
#include "common/tables/text_cursor.hpp"

namespace recoat {
namespace {

/// Columns of the section Atoms in an atom style.
struct AtomStyle {
    std::string_view name;
    std::size_t columns;  ///< without image flags
    std::size_t x;        ///< y and z follow
    int diameter;         ///< density follows; -1: none
};
constexpr std::array<AtomStyle, 8> styles = {{{"sphere", 7, 4, 2},
                                              {"granular", 7, 4, 2},
                                              {"bpm/sphere", 8, 5, 3},
                                              {"atomic", 5, 2, -1},
                                              {"charge", 6, 3, -1},
                                              {"bond", 6, 3, -1},
                                              {"molecular", 6, 3, -1},
                                              {"full", 7, 4, -1}}};

/// The type stands in front of the diameter, of the charge, or else of the position.
std::size_t type_column(const AtomStyle& style) {
    if (style.diameter > 0) return static_cast<std::size_t>(style.diameter) - 1;
    return style.x - (style.name == "charge" || style.name == "full" ? 2 : 1);
}

/// Heading of a section: a line that begins with a letter.
bool is_heading(std::string_view line) {
    const std::string_view text = trimmed(line);
    return !text.empty() && ((text[0] >= 'A' && text[0] <= 'Z') || (text[0] >= 'a' && text[0] <= 'z'));
}

class DataReader {
public:
    DataReader(const Content& content, const ReadOptions& options)
        : cursor_(content.name(), content.bytes),
          si_(options.length_unit.value_or(1.0) == 1.0),
          allow_size_zero_(options.allow_size_zero()) {}

    Source read() {
        cursor_.need("a comment");
        read_header();
        read_atoms();
        return std::move(source_);
    }

private:
    /// Up to the section Atoms.
    void read_header() {
        while (true) {
            if (!cursor_.next_filled()) cursor_.fail("there is no section Atoms; give a data file with atoms");
            const std::string_view line = cursor_.line();
            cursor_.split();
            const auto& cells = cursor_.cells();
            if (cells[0] == "Atoms") break;
            if (cells.size() == 2 && cells[1] == "atoms") {
                const auto count = cursor_.integer(0, "atoms");
                if (count < 0) cursor_.fail_at(0, "atoms", "a number of atoms cannot be negative");
                count_ = static_cast<std::size_t>(count);
            } else if (line.find("xy xz yz") != std::string_view::npos || line.find("avec") != std::string_view::npos) {
                cursor_.fail(
                    "the box is triclinic (tilted), which has no meaning for a layer; write it from an "
                    "orthogonal box");
            } else if (cells.size() == 4) {
                read_bounds();
            }
        }
        const std::size_t hash = cursor_.line().find('#');
        if (hash == std::string_view::npos) return;
        const std::string_view name = trimmed(cursor_.line().substr(hash + 1));
        const auto style = std::ranges::find(styles, name, &AtomStyle::name);
        if (style == styles.end()) {
            cursor_.fail(fmt::format("the atom style \"{}\" is not known; write the data with one of sphere, atomic",
                                     quotable(name)));
        }
        style_ = &*style;
    }

    void read_bounds() {
        struct Axis {
            std::string_view lower, upper;
            double Vec3::*value;
        };
        constexpr std::array<Axis, 3> axes = {
            {{"xlo", "xhi", &Vec3::x}, {"ylo", "yhi", &Vec3::y}, {"zlo", "zhi", &Vec3::z}}};
        for (const Axis& axis : axes) {
            if (cursor_.cells()[2] != axis.lower || cursor_.cells()[3] != axis.upper) continue;
            box_.lower.*axis.value = cursor_.number(0, axis.lower);
            box_.upper.*axis.value = cursor_.number(1, axis.upper);
            ++bounds_;
        }
    }

    /// The style that the number of columns of the first atom tells.
    void guess_style() {
        const std::size_t columns = cursor_.cells().size();
        const bool sphere = columns == 7 || columns == 10, atomic = columns == 5 || columns == 8;
        if (!sphere && !atomic) {
            cursor_.fail(
                fmt::format("no atom style with {} columns is known; name the style: Atoms # sphere", columns));
        }
        style_ = sphere ? &styles[0] : &styles[3];
    }

    void read_atoms() {
        source_.facts = {{"atoms", std::to_string(count_)}};
        double density = 0;
        bool one_density = true;
        for (std::size_t i = 0; i < count_; ++i) {
            next_atom(i);
            const auto& style = *style_;
            source_.position.push_back(
                {cursor_.number(style.x, "x"), cursor_.number(style.x + 1, "y"), cursor_.number(style.x + 2, "z")});
            source_.id.push_back(cursor_.integer(0, "id"));
            source_.type.add(cursor_.cells()[type_column(style)]);
            source_.line.push_back(cursor_.line_number());
            read_images();
            if (style.diameter < 0) continue;
            const auto column = static_cast<std::size_t>(style.diameter);
            source_.radius.push_back(0.5 * cursor_.size(column, "diameter", allow_size_zero_));
            const double own = cursor_.number(column + 1, "density");
            one_density = one_density && (i == 0 || own == density);
            density = own;
        }
        if (cursor_.next_filled() && !is_heading(cursor_.line())) {
            cursor_.fail(
                fmt::format("the section Atoms goes on after {} atoms, all that the head announces; make them "
                            "agree",
                            count_));
        }
        if (trimmed(cursor_.line()).starts_with("Velocities")) read_lammps_velocities(cursor_, source_);
        if (bounds_ == 3) source_.box = box_;
        if (style_ != nullptr) source_.facts.emplace_back("atom style", style_->name);
        if (one_density && density > 0 && si_) source_.info.density = density;
    }

    void next_atom(std::size_t index) {
        const bool there = index == 0 ? cursor_.next_filled() : cursor_.next();
        if (!there || trimmed(cursor_.line()).empty() || is_heading(cursor_.line())) {
            cursor_.fail(
                fmt::format("the section Atoms ends after {} of {} atoms; copy the file again from where it "
                            "was made",
                            index, count_));
        }
        cursor_.split();
        if (style_ == nullptr) guess_style();
        const std::size_t columns = cursor_.cells().size();
        // A line cut behind the position would else be one without image flags.
        if (index == 0 && (columns == style_->columns || columns == style_->columns + 3)) columns_ = columns;
        if (columns == columns_) return;
        cursor_.fail(
            fmt::format("the line has {} columns, but atoms of style {} have {} or {}, all alike; correct the "
                        "line",
                        columns, style_->name, style_->columns, style_->columns + 3));
    }

    void read_images() {
        if (cursor_.cells().size() == style_->columns) return;
        for (std::size_t a = 0; a < 3; ++a) {
            if (cursor_.integer(style_->columns + a, "image flag") != 0) box_.periodic[a] = true;
        }
    }

    TextCursor cursor_;
    bool si_;  ///< whether densities are in kg/m3
    bool allow_size_zero_;
    std::size_t count_ = 0;
    Box box_;
    int bounds_ = 0;
    const AtomStyle* style_ = nullptr;
    std::size_t columns_ = 0;  ///< of every atom
    Source source_;
};

}  // namespace

bool is_lammps_data(const Content& content) {
    // The first line may hold anything.
    const std::string_view head = content.head();
    return looks_like_text(head) && head.find(" xlo xhi") != std::string_view::npos &&
           head.find(" atoms") != std::string_view::npos;
}

Series open_lammps_data(const Content& content, const ReadOptions& options) {
    return single_step([&] { return DataReader(content, options).read(); });
}

}  // namespace recoat
