#include "solver/execution/devices.hpp"

#include <fmt/format.h>

#include "common/error.hpp"

namespace recoat {

void require_device(const Devices& devices, int number) {
    if (devices.found.empty())
        throw InputError(fmt::format("no CUDA device can be used: {}; use --backend cpu", devices.problem));
    const auto count = static_cast<int>(devices.found.size());
    if (number < 0 || number >= count)
        throw InputError(fmt::format("there is no CUDA device {}: this machine has {}, {}", number, count,
                                     count == 1 ? "number 0" : fmt::format("numbers 0 to {}", count - 1)));
    const Device& device = devices.found[static_cast<std::size_t>(number)];
    if (!device.problem.empty())
        throw InputError(fmt::format("CUDA device {} cannot be used: {}; use another device, or --backend cpu", number,
                                     device.problem));
    if (device.major < 8)
        throw InputError(
            fmt::format("CUDA device {} ({}) has compute capability {}.{}, but 8.0 is needed; use another "
                        "device, or --backend cpu",
                        number, device.name, device.major, device.minor));
}

}  // namespace recoat
