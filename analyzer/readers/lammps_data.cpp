#include "analyzer/readers/lammps_data.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include <fmt/format.h>

#include "analyzer/readers/lammps_box.hpp"
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
constexpr std::array<AtomStyle, 9> styles = {{{"sphere", 7, 4, 2},
                                              {"granular", 7, 4, 2},
                                              {"bpm/sphere", 8, 5, 3},
                                              {"atomic", 5, 2, -1},
                                              {"charge", 6, 3, -1},
                                              {"bond", 6, 3, -1},
                                              {"angle", 6, 3, -1},
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

const AtomStyle* find_style(std::string_view name) {
    const auto style = std::ranges::find(styles, name, &AtomStyle::name);
    return style == styles.end() ? nullptr : &*style;
}

class DataReader {
public:
    DataReader(const Content& content, const ReadOptions& options)
        : cursor_(content.name(), content.bytes),
          options_(options),
          si_(options.length_unit.value_or(1.0) == 1.0),
          allow_size_zero_(options.allow_size_zero()) {}

    Source read() {
        cursor_.need("a comment");
        read_header();
        read_atoms();
        while (cursor_.next()) continue;
        cursor_.need_line_end();
        return std::move(source_);
    }

private:
    /// To the next line that is more than a comment; what its comment says is kept.
    bool next_content() {
        while (cursor_.next_filled()) {
            const std::size_t hash = cursor_.line().find('#');
            comment_ = hash == std::string_view::npos ? "" : trimmed(cursor_.line().substr(hash + 1));
            cursor_.drop_comment('#');
            if (!trimmed(cursor_.line()).empty()) return true;
        }
        return false;
    }

    /// Up to the section Atoms.
    void read_header() {
        while (true) {
            if (!next_content()) cursor_.fail("there is no section Atoms; give a data file with atoms");
            cursor_.split();
            const auto& cells = cursor_.cells();
            if (cells[0] == "Atoms") break;
            if (cells.size() == 2 && cells[1] == "atoms") {
                const auto count = cursor_.integer(0, "atoms");
                if (count < 0) cursor_.fail_at(0, "atoms", "a number of atoms cannot be negative");
                count_ = static_cast<std::size_t>(count);
            }
            box_.take(cursor_);
        }
        read_style();
    }

    /// The style that the comment behind "Atoms" names, or the option.
    void read_style() {
        const std::string& told = options_.atom_style;
        if (comment_.empty() && told.empty()) {
            cursor_.fail(
                "the file does not say its atom style, so its columns have no meaning; write it behind the heading, "
                "e.g. "
                "\"Atoms # sphere\", or name it with --atom-style sphere");
        }
        if (!comment_.empty() && !told.empty() && comment_ != told) {
            cursor_.fail(fmt::format("the file says itself that its atom style is \"{}\"; leave --atom-style out",
                                     quotable(comment_)));
        }
        style_ = find_style(comment_.empty() ? std::string_view(told) : comment_);
        if (style_ != nullptr) return;
        std::string known;
        for (const AtomStyle& style : styles) known += (known.empty() ? "" : ", ") + std::string(style.name);
        cursor_.fail(fmt::format("the atom style \"{}\" is not known; write the data with one of {}",
                                 quotable(comment_.empty() ? std::string_view(told) : comment_), known));
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
        cursor_.need_line_end();
        if (next_content() && !is_heading(cursor_.line())) {
            cursor_.fail(
                fmt::format("the section Atoms goes on after {} atoms, all that the head announces; make them "
                            "agree",
                            count_));
        }
        if (trimmed(cursor_.line()).starts_with("Velocities")) read_lammps_velocities(cursor_, source_);
        source_.box = box_.box();
        if (source_.box) source_.box->periodic = periodic_;
        source_.facts.emplace_back("atom style", style_->name);
        if (one_density && density > 0 && si_) source_.info.density = density;
    }

    void next_atom(std::size_t index) {
        if (!next_content() || is_heading(cursor_.line())) {
            cursor_.fail(
                fmt::format("the section Atoms ends after {} of {} atoms; copy the file again from where it "
                            "was made",
                            index, count_));
        }
        cursor_.split();
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
            if (cursor_.integer(style_->columns + a, "image flag") != 0) periodic_[a] = true;
        }
    }

    TextCursor cursor_;
    const ReadOptions& options_;
    std::string_view comment_;  ///< of the line
    bool si_;                   ///< whether densities are in kg/m3
    bool allow_size_zero_;
    std::size_t count_ = 0;
    DataBox box_;
    std::array<bool, 3> periodic_ = {};
    const AtomStyle* style_ = nullptr;
    std::size_t columns_ = 0;  ///< of every atom
    Source source_;
};

}  // namespace

bool is_lammps_data(const Content& content) {
    // The first line may hold anything.
    const std::string_view head = content.head();
    const auto has = [&](std::string_view word) { return head.find(word) != std::string_view::npos; };
    return looks_like_text(head) && ((has("xlo") && has("xhi")) || has(" avec")) && has("atoms");
}

Series open_lammps_data(const Content& content, const ReadOptions& options) {
    return single_step([&] { return DataReader(content, options).read(); });
}

}  // namespace recoat
