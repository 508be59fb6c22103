#include <cmath>
#include <fstream>
#include <random>

#include <gtest/gtest.h>

#include "common/error.hpp"
#include "common/hdf5.hpp"
#include "common/state.hpp"
#include "tests/support/temporary_folder.hpp"
#include "tests/support/throws_message.hpp"

namespace recoat {
namespace {

using testing::message_of;

State random_state(std::size_t count, std::int64_t step) {
    std::mt19937_64 generator(static_cast<std::uint64_t>(step) + 1);
    std::normal_distribution<double> value;
    const auto vector = [&] { return Vec3{value(generator), value(generator), value(generator)}; };
    State state;
    state.time = 1e-8 * static_cast<double>(step);
    state.step = step;
    state.scalars["CoordinationNumber"] = {};
    for (std::size_t i = 0; i < count; ++i) {
        state.id.push_back(static_cast<std::int64_t>(count - i));
        state.position.push_back(vector());
        state.velocity.push_back(vector());
        state.angular_velocity.push_back(vector());
        state.radius.push_back(std::abs(value(generator)));
        state.scalars["CoordinationNumber"].push_back(std::round(3 * std::abs(value(generator))));
    }
    return state;
}

void expect_same(const State& a, const State& b) {
    EXPECT_EQ(a.time, b.time);
    EXPECT_EQ(a.step, b.step);
    EXPECT_EQ(a.id, b.id);
    EXPECT_EQ(a.position, b.position);
    EXPECT_EQ(a.velocity, b.velocity);
    EXPECT_EQ(a.angular_velocity, b.angular_velocity);
    EXPECT_EQ(a.radius, b.radius);
    EXPECT_EQ(a.scalars, b.scalars);
}

class StateFile : public ::testing::Test {
protected:
    testing::TemporaryFolder folder;
    std::filesystem::path path = folder / "a.vtkhdf";
};

TEST_F(StateFile, OneStateOfAnySizeReadsBackTheSame) {
    for (const std::size_t count : {0U, 1U, 2U, 5000U}) {
        const State state = random_state(count, 12);
        write_state(path, {}, state);
        EXPECT_EQ(count_steps(path), 1U);
        expect_same(read_state(path), state);
    }
}

TEST_F(StateFile, EveryStepReadsBackTheSame) {
    const std::vector<std::size_t> counts = {3, 0, 1000, 1, 1000};
    StateWriter writer(path, {});
    for (std::size_t s = 0; s < counts.size(); ++s)
        writer.append(random_state(counts[s], static_cast<std::int64_t>(s)));
    writer.close();
    EXPECT_EQ(count_steps(path), counts.size());
    for (std::size_t s = 0; s < counts.size(); ++s) {
        expect_same(read_state(path, static_cast<int>(s)), random_state(counts[s], static_cast<std::int64_t>(s)));
    }
    expect_same(read_state(path), read_state(path, 4));
    expect_same(read_state(path, -5), read_state(path, 0));
    for (const int index : {5, -6}) {
        EXPECT_NE(message_of<InputError>([&] { (void)read_state(path, index); }).find("the file has 5"),
                  std::string::npos);
    }
}

TEST_F(StateFile, InfoReadsBackTheSame) {
    StateInfo info;
    info.program_version = "1.2.3 (abc)";
    info.config = "cohesion:\n  bond_number: 5\n";
    info.backend = "openmp";
    info.stage = "spread";
    info.seed = -7;
    info.diameter = 50e-6;
    info.density = 4430;
    info.y_min = -0.5e-3;
    info.y_period = 1e-3;
    info.clearance = 2e-4;
    info.blade_start = 0.1;
    info.spread_length = 0.01;
    info.layer_end = 0.107;
    info.bond_number = 50;
    info.hamaker = 1.2e-20;
    info.time_step = 2e-8;
    write_state(path, info, random_state(2, 0));
    const StateInfo read = read_state_info(path);
    EXPECT_EQ(read.schema_version, 1);
    EXPECT_EQ(read.program_version, info.program_version);
    EXPECT_EQ(read.config, info.config);
    EXPECT_EQ(read.backend, info.backend);
    EXPECT_EQ(read.stage, info.stage);
    EXPECT_EQ(read.seed, info.seed);
    EXPECT_EQ(read.diameter, info.diameter);
    EXPECT_EQ(read.density, info.density);
    EXPECT_EQ(read.y_min, info.y_min);
    EXPECT_EQ(read.y_period, info.y_period);
    EXPECT_EQ(read.clearance, info.clearance);
    EXPECT_EQ(read.blade_start, info.blade_start);
    EXPECT_EQ(read.spread_length, info.spread_length);
    EXPECT_EQ(read.layer_end, info.layer_end);
    EXPECT_EQ(read.bond_number, info.bond_number);
    EXPECT_EQ(read.hamaker, info.hamaker);
    EXPECT_EQ(read.time_step, info.time_step);
    EXPECT_TRUE(std::isnan(read.stiffness_ratio));
}

TEST_F(StateFile, VelocitiesNeedNotBeKnown) {
    State state = random_state(7, 3);
    state.angular_velocity.clear();
    write_state(path, {}, state);
    expect_same(read_state(path), state);
    EXPECT_FALSE(hdf5::File::open(path).group("VTKHDF").group("PointData").has("AngularVelocity"));
    StateWriter writer(path, {}, {.velocity = true, .angular_velocity = false});
    writer.append(random_state(0, 1));
    writer.append(state);
    EXPECT_THROW(StateWriter(folder / "b", {}).append(state), std::invalid_argument);
    writer.close();
    EXPECT_EQ(count_steps(path), 2U);
    expect_same(read_state(path, 1), state);
}

TEST_F(StateFile, AppearsOnlyWhenClosed) {
    {
        StateWriter writer(path, {});
        writer.append(random_state(3, 0));
        EXPECT_FALSE(std::filesystem::exists(path));
    }
    EXPECT_TRUE(std::filesystem::is_empty(folder.path()));
    StateWriter writer(path, {});
    writer.append(random_state(3, 0));
    writer.close();
    EXPECT_TRUE(is_state_file(path));
}

TEST_F(StateFile, ArraysMustFitEachOther) {
    StateWriter writer(path, {});
    State state = random_state(3, 0);
    state.radius.pop_back();
    EXPECT_THROW(writer.append(state), std::invalid_argument);
    writer.append(random_state(3, 0));
    state = random_state(3, 1);
    state.scalars["Another"] = {1, 2, 3};
    EXPECT_THROW(writer.append(state), std::invalid_argument);
    state = random_state(3, 1);
    state.scalars.clear();
    EXPECT_THROW(writer.append(state), std::invalid_argument);
}

TEST_F(StateFile, ForeignAndDamagedFilesAreRefused) {
    hdf5::File::create(path).write("a", std::vector<double>{1});
    EXPECT_FALSE(is_state_file(path));
    EXPECT_EQ(message_of<InputError>([&] { (void)read_state(path); }),
              path.string() + ": this HDF5 file holds no particle states; give a .vtkhdf file of recoat-solve");
    write_state(path, {}, random_state(1000, 0));
    std::filesystem::resize_file(path, std::filesystem::file_size(path) - 1000);
    EXPECT_NE(message_of<InputError>([&] { (void)read_state(path); }).find("cut off or damaged"), std::string::npos);
    StateInfo info;
    info.schema_version = 99;
    write_state(path, info, random_state(1, 0));
    EXPECT_NE(message_of<InputError>([&] { (void)read_state(path); }).find("schema version 99"), std::string::npos);
}

TEST_F(StateFile, SpaceThatCannotBeWrittenIsRefused) {
    EXPECT_THROW(write_state("/proc/none/a.vtkhdf", {}, random_state(1, 0)), InputError);
}

}  // namespace
}  // namespace recoat
