#pragma once

#include <cstdint>
#include <functional>
#include <utility>
#include <vector>

#include "analyzer/readers/source.hpp"

namespace recoat {

/// The time steps of one file in its order.
struct Series {
    std::vector<std::int64_t> steps;          ///< their numbers; at least one
    std::function<Source(std::size_t)> read;  ///< the particles of one, by its place in `steps`
};

/// The series of a file that holds one time step, without a number.
inline Series single_step(std::function<Source()> read) {
    return {{0}, [read = std::move(read)](std::size_t) { return read(); }};
}

}  // namespace recoat
