#include "solver/cli/choose_resources.hpp"

#include <algorithm>
#include <thread>

#include "common/error.hpp"

namespace recoat {
namespace {

bool usable(const Devices& devices, int number) {
    try {
        require_device(devices, number);
        return true;
    } catch (const InputError&) {
        return false;
    }
}

}  // namespace

Resources choose_resources(const ResourceRequest& request, const Devices& devices) {
    Resources resources;
    resources.device = request.device;
    resources.threads =
        request.threads > 0 ? request.threads : static_cast<int>(std::max(1U, std::thread::hardware_concurrency()));
    if (request.backend == "cuda") require_device(devices, request.device);
    const bool cuda = request.backend == "cuda" || (request.backend == "auto" && usable(devices, request.device));
    resources.backend = cuda ? Backend::cuda : Backend::cpu;
    return resources;
}

}  // namespace recoat
