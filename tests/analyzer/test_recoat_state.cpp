#include <cmath>

#include "analyzer/readers/recoat_state.hpp"
#include "common/state.hpp"
#include "tests/analyzer/reader_fixture.hpp"

namespace recoat {
namespace {

class RecoatState : public testing::ReaderTest {};

TEST_F(RecoatState, StepsOfATrajectory) {
    const testing::TemporaryFolder folder;
    const auto path = folder / "trajectory.vtkhdf";
    StateInfo info;
    info.diameter = 2;
    StateWriter writer(path, info);
    for (const std::int64_t step : {0, 100, 250}) {
        State state;
        state.step = step;
        state.id = {4, 2};
        state.position = {{static_cast<double>(step), 0, 1}, {1, 2, 3}};
        state.velocity = state.angular_velocity = {{}, {}};
        state.radius = {1, 1};
        writer.append(state);
    }
    writer.close();
    const auto at = [&](StepChoice choice) { return read_particles(path, {.columns = {}, .step = choice}); };
    EXPECT_EQ(at({StepChoice::Which::last, 0}).position[0].x, 250);
    EXPECT_EQ(at({StepChoice::Which::first, 0}).position[0].x, 0);
    const Source middle = at({StepChoice::Which::number, 100});
    EXPECT_EQ(middle.position[0].x, 100);
    EXPECT_EQ(middle.id, (std::vector<std::int64_t>{4, 2}));
    EXPECT_EQ(middle.info.particle_diameter, 2);
    EXPECT_EQ(middle.info.base, 0);
    EXPECT_NE(testing::message_of<InputError>([&] {
                  (void)at({StepChoice::Which::number, 7});
              }).find("there is no time step 7; the file has 3: 0, 100, 250"),
              std::string::npos);
}

}  // namespace
}  // namespace recoat
