#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "analyzer/readers/source.hpp"

namespace recoat {

/// The time steps of one file in its order.
struct Series {
    std::vector<std::int64_t> steps;          ///< their numbers; at least one
    std::function<Source(std::size_t)> read;  ///< the particles of one, by its place in `steps`
    std::vector<double> times = {};           ///< their times as the file has them, or empty
    std::string damage = {};                  ///< why what follows these steps cannot be read; empty where all is whole
};

/// The series of a file that holds one time step, without a number.
inline Series single_step(std::function<Source()> read) {
    return {{0}, [read = std::move(read)](std::size_t) { return read(); }};
}

/// Calls `scan` until it says that no time step follows; it adds those that it finds whole. What is damaged behind the
/// first whole one does not keep those before from being read: it becomes `series.damage`.
void scan_steps(Series& series, const std::function<bool()>& scan);

}  // namespace recoat
