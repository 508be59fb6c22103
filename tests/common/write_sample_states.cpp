// write_sample_states FILE COUNT...: a trajectory whose state s has COUNT particles with values by formula.

#include <cmath>
#include <cstdlib>

#include "common/error.hpp"
#include "common/state.hpp"

namespace {

recoat::State sample(std::size_t step, std::size_t count) {
    recoat::State state;
    state.scalars["CoordinationNumber"] = {};
    state.time = 0.25 * static_cast<double>(step);
    state.step = static_cast<std::int64_t>(1000 * step);
    for (std::size_t i = 0; i < count; ++i) {
        const double a = static_cast<double>(i) + 1e3 * static_cast<double>(step);
        state.id.push_back(static_cast<std::int64_t>(i));
        state.position.push_back({1e-6 * a, -2e-6 * a, 1 / (a + 1)});
        state.velocity.push_back({a, a * a, -a / 3});
        state.angular_velocity.push_back({-a, 0.5, a / 7});
        state.radius.push_back(25e-6 / (a + 1));
        state.scalars["CoordinationNumber"].push_back(static_cast<double>(i % 7));
    }

    return state;
}

}  // namespace

int main(int argc, char** argv) {
    return recoat::run_program("write_sample_states", [&] {
        if (argc < 3) throw recoat::InputError("usage: write_sample_states FILE COUNT...");
        recoat::StateInfo info;
        info.program_version = "sample";
        info.seed = 7;
        info.diameter = 50e-6;
        recoat::StateWriter writer(argv[1], info);
        for (int s = 0; s + 2 < argc; ++s) {
            writer.append(sample(static_cast<std::size_t>(s), std::strtoul(argv[s + 2], nullptr, 10)));
        }
        writer.close();
        return 0;
    });
}
