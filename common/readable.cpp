#include "common/readable.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include <fmt/format.h>

namespace recoat {
namespace {

struct Scale {
    std::string_view name;
    double size;
};

constexpr std::array<Scale, 11> prefixes = {{{"T", 1e12},
                                             {"G", 1e9},
                                             {"M", 1e6},
                                             {"k", 1e3},
                                             {"", 1},
                                             {"m", 1e-3},
                                             {"u", 1e-6},
                                             {"n", 1e-9},
                                             {"p", 1e-12},
                                             {"f", 1e-15},
                                             {"a", 1e-18}}};

constexpr std::array<std::string_view, 6> bare_units = {"m", "s", "g", "N", "J", "Pa"};

/// Rounded to what is shown, so that 999.96 becomes 1 of the next prefix and not "1000".
double rounded(double value) {
    if (value == 0 || !std::isfinite(value)) return value;
    const double unit = std::pow(10, std::floor(std::log10(std::abs(value))) - 3);
    return std::round(value / unit) * unit;
}

}  // namespace

std::string readable(double value, std::string_view unit) {
    if (unit == "kg") return readable(1e3 * value, "g");
    const double size = std::abs(rounded(value));
    const bool takes_prefix = std::ranges::find(bare_units, unit) != bare_units.end();
    if (std::isfinite(value) && value != 0 && takes_prefix && size < 1e15) {
        for (const Scale& prefix : prefixes) {
            if (size >= prefix.size * (1 - 1e-9))
                return fmt::format("{:.4g} {}{}", value / prefix.size, prefix.name, unit);
        }
    }
    return unit.empty() ? fmt::format("{:.4g}", value) : fmt::format("{:.4g} {}", value, unit);
}

std::string readable_speed(double speed) { return readable(speed, "m") + "/s"; }

std::string readable_duration(double seconds) {
    if (!std::isfinite(seconds)) return "for ever";
    if (seconds == 0) return "0 s";
    constexpr std::array<Scale, 8> units = {{{"years", 365.25 * 86400},
                                             {"days", 86400},
                                             {"h", 3600},
                                             {"min", 60},
                                             {"s", 1},
                                             {"ms", 1e-3},
                                             {"us", 1e-6},
                                             {"ns", 1e-9}}};
    for (const Scale& unit : units) {
        // Whole minutes, hours and days only from two on: "90 s" says more than "1.5 min".
        const double least = unit.size > 1 ? 1.995 : 0.0995;
        const double count = seconds / unit.size;
        if (count >= least || unit.size == 1e-9)
            return fmt::format("{:.{}g} {}", count, count >= 100 ? 3 : 2, unit.name);
    }
    return {};
}

std::string readable_bytes(double bytes) {
    constexpr std::array<Scale, 5> units = {
        {{"TiB", 0x1p40}, {"GiB", 0x1p30}, {"MiB", 0x1p20}, {"KiB", 0x1p10}, {"bytes", 1}}};
    for (const Scale& unit : units) {
        if (bytes >= 0.9995 * unit.size || unit.size == 1) {
            const double count = bytes / unit.size;
            return fmt::format("{:.{}g} {}", count, count >= 1000 ? 4 : 3, unit.name);
        }
    }
    return {};
}

std::string readable_count(long long count) {
    std::string text = std::to_string(count);
    const std::size_t first = count < 0 ? 1 : 0;
    for (std::size_t place = text.size(); place > first + 3; place -= 3) text.insert(place - 3, 1, ' ');
    return text;
}

}  // namespace recoat
