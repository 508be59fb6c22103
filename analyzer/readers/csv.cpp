#include "analyzer/readers/csv.hpp"

#include <utility>

#include "common/tables/csv_table.hpp"
#include "common/tables/text_cursor.hpp"

namespace recoat {
namespace {

Source read_csv(const Content& content, const ReadOptions& options) {
    const CsvOptions table_options = {
        .columns = options.columns,
        .needs_size = !options.radius && options.radius_of_type.empty(),
        .allows_size_zero = options.allow_size_zero(),
        .naming =
            "name it in the first line, or choose the column: --set columns.x=NAME, --radius-column NAME, "
            "--diameter-column NAME; or give one --radius for all",
        .about_size_zero = "a particle must have a size above zero (--skip-size-zero leaves such particles out)"};
    CsvTable table = read_csv_table(content.name(), content.bytes, table_options);
    Source source;
    source.position = std::move(table.position);
    source.radius = std::move(table.radius);
    source.velocity = std::move(table.velocity);
    source.angular_velocity = std::move(table.angular_velocity);
    source.id = std::move(table.id);
    for (const std::string_view name : table.type) source.type.add(name);
    source.line = std::move(table.line);
    source.warnings = std::move(table.warnings);
    source.columns = std::move(table.columns);
    if (table.has_units) source.own_unit = 1.0;
    source.info.base = 0;
    return source;
}

}  // namespace

bool is_csv(const Content& content) { return looks_like_text(content.head()); }

Series open_csv(const Content& content, const ReadOptions& options) {
    return single_step([&] { return read_csv(content, options); });
}

}  // namespace recoat
