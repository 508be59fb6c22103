#include "analyzer/metrics/packing.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace recoat {

MapError map_error(const Map& approximate, const Map& exact) {
    if (approximate.values.size() != exact.values.size())
        throw std::invalid_argument("maps of different size compared");
    MapError error;
    double squares = 0;
    for (std::size_t i = 0; i < exact.values.size(); ++i) {
        const double difference = approximate.values[i] - exact.values[i];
        error.max = std::max(error.max, std::abs(difference));
        squares += difference * difference;
    }
    if (!exact.values.empty()) error.rms = std::sqrt(squares / static_cast<double>(exact.values.size()));
    return error;
}

}  // namespace recoat
