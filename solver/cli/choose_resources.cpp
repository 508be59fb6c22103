#include "solver/cli/choose_resources.hpp"

#include <algorithm>
#include <thread>

#include "common/error.hpp"

namespace recoat {
namespace {

void require_working(const Devices& devices, int number, const DeviceTrial& trial) {
    require_device(devices, number);
    const std::string problem = trial(number);
    if (!problem.empty()) throw InputError(problem + "; use another device, or --backend cpu");
}

}  // namespace

ResourceChoice choose_resources(const ResourceRequest& request, const Devices& devices, const DeviceTrial& trial) {
    ResourceChoice choice;
    choice.resources.device = request.device;
    choice.resources.threads =
        request.threads > 0 ? request.threads : static_cast<int>(std::max(1U, std::thread::hardware_concurrency()));
    if (request.backend == "cpu") return choice;
    try {
        require_working(devices, request.device, trial);
        choice.resources.backend = Backend::cuda;
    } catch (const InputError& error) {
        if (request.backend == "cuda") throw;
        if (!devices.found.empty() || devices.out_of_reach)
            choice.notice = std::string(error.what()) + " (computing on the processor now)";
    }
    return choice;
}

}  // namespace recoat
