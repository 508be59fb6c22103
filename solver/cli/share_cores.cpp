#include "solver/cli/share_cores.hpp"

#include <algorithm>

namespace recoat {

Share share_cores(const ShareRequest& request, int cases, int cores, Backend backend) {
    Share share;
    const int wanted = request.jobs > 0 ? std::min(request.jobs, cases) : cases;
    share.threads = request.threads > 0 ? request.threads : std::max(1, cores / wanted);
    const bool all = request.jobs > 0 || backend == Backend::cuda;
    share.jobs = all ? wanted : std::clamp(cores / share.threads, 1, cases);
    return share;
}

}  // namespace recoat
