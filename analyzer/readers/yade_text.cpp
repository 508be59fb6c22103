#include "analyzer/readers/yade_text.hpp"

#include <optional>

#include <fmt/format.h>

#include "common/number.hpp"
#include "common/tables/text_cursor.hpp"

namespace recoat {
namespace {

constexpr std::string_view format_mark = "#format ";

/// The format that the comments on top name.
std::optional<std::string_view> named_format(std::string_view text) {
    TextCursor cursor({}, text);
    while (cursor.next_filled() && trimmed(cursor.line()).starts_with('#')) {
        const std::string_view line = trimmed(cursor.line());
        if (line.starts_with(format_mark)) return trimmed(line.substr(format_mark.size()));
    }
    return {};
}

Source read_yade_text(const Content& content, const ReadOptions& options) {
    TextCursor cursor(content.name(), content.bytes);
    const std::string_view format = *named_format(content.bytes);
    const bool has_id = format.starts_with("id_x_y_z_r");
    if (!has_id && !format.starts_with("x_y_z_r")) {
        cursor.fail(fmt::format("the format \"{}\" is not known; export as x_y_z_r, with what you like after it",
                                quotable(format)));
    }
    const std::size_t x = has_id ? 1 : 0;
    // The materials of Yade stand right behind the radius.
    const std::size_t type = format.substr(has_id ? 3 : 0).starts_with("x_y_z_r_matId") ? x + 4 : 0;
    std::size_t columns = 0;
    Source source;
    source.facts = {{"columns", std::string(format)}};
    while (cursor.next_filled()) {
        if (trimmed(cursor.line()).starts_with('#')) continue;
        cursor.split();
        const std::size_t found = cursor.cells().size();
        if (columns == 0) columns = found;
        if (found < x + 4 || found != columns) {
            cursor.fail(fmt::format("the line has {} columns, {} are expected; correct the line", found,
                                    columns < x + 4 ? fmt::format("{} or more", x + 4) : std::to_string(columns)));
        }
        source.position.push_back({cursor.number(x, "x"), cursor.number(x + 1, "y"), cursor.number(x + 2, "z")});
        source.radius.push_back(cursor.size(x + 3, "r", options.allow_size_zero()));
        if (type > 0 && type < found) source.type.add(cursor.cells()[type]);
        if (has_id) source.id.push_back(cursor.integer(0, "id"));
        source.line.push_back(cursor.line_number());
    }
    cursor.need_line_end();
    return source;
}

}  // namespace

bool is_yade_text(const Content& content) { return named_format(content.head()).has_value(); }

Series open_yade_text(const Content& content, const ReadOptions& options) {
    return single_step([&] { return read_yade_text(content, options); });
}

}  // namespace recoat
