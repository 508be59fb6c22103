#include <fstream>
#include <sstream>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "solver/output/energy_balance.hpp"
#include "solver/output/energy_series.hpp"
#include "solver/output/ledger_fields.hpp"
#include "tests/support/fake_engine.hpp"
#include "tests/support/temporary_folder.hpp"

namespace recoat {
namespace {

EnergyLedger ledger(double stored, double dissipated, double work, double removed) {
    EnergyLedger result;
    result.kinetic_translation = 0.5 * stored;
    result.cohesion = 0.5 * stored;
    result.dissipated_rolling = dissipated;
    result.wall_work = work;
    result.removed_with_walls = removed;
    return result;
}

TEST(EnergyBalance, WorkThatIsStoredDissipatedOrRemovedIsAccountedFor) {
    const EnergyBalance balance = energy_balance(ledger(10, 1, 2, 0), ledger(12, 6, 10, 1));
    EXPECT_DOUBLE_EQ(balance.wall_work, 8);
    EXPECT_DOUBLE_EQ(balance.dissipated, 5);
    EXPECT_DOUBLE_EQ(balance.error, 0);
}

TEST(EnergyBalance, ErrorIsRelativeToWhatWasExchanged) {
    // dissipated 2, work 4, and 0.5 each that came to be in motion and in the attraction
    const EnergyBalance balance = energy_balance(ledger(0, 0, 0, 0), ledger(1, 2, -4, 0));
    EXPECT_DOUBLE_EQ(balance.error, 7);
    EXPECT_DOUBLE_EQ(balance.relative_error(), 7.0 / 7);
    EXPECT_EQ(energy_balance({}, {}).relative_error(), 0);
}

// A bed at rest: the error is that of rounding the large energies held, the exchanged energy is of that order, too.
TEST(EnergyBalance, IsNeverARatioOfRoundings) {
    EnergyLedger start, end;
    start.cohesion = -1;
    end.cohesion = -1 + 3e-16;
    end.dissipated_normal = 1e-16;
    const EnergyBalance balance = energy_balance(start, end);
    EXPECT_GT(balance.error / balance.exchanged, 0.5);
    EXPECT_LT(balance.relative_error(), 1e-6);
    EXPECT_DOUBLE_EQ(balance.scale(), 1e-9);
}

// Motion and springs at both ends, and whatever changed between: nothing cancels.
TEST(EnergyBalance, ExchangedIsAllThatMovedOrCouldHave) {
    EnergyLedger start, end;
    start.elastic_normal = 1;
    start.gravity = 100;
    start.cohesion = -30;
    end.kinetic_translation = 2;
    end.kinetic_rotation = 4;
    end.elastic_tangential = 8;
    end.gravity = 84;
    end.cohesion = -62;
    end.dissipated_normal = 64;
    end.wall_work = -128;
    end.removed_with_walls = -256;
    EXPECT_DOUBLE_EQ(energy_balance(start, end).exchanged, 511);
    EXPECT_DOUBLE_EQ(energy_balance(start, start).exchanged, 2);
}

// Guards against an entry that is added to the ledger but not to the files.
TEST(LedgerFields, NameEveryEntry) { EXPECT_EQ(ledger_fields.size() * sizeof(double), sizeof(EnergyLedger)); }

TEST(EnergySeries, WritesOneRowPerSample) {
    testing::TemporaryFolder folder;
    testing::FakeScript script;
    Wall blade;
    blade.name = "blade";
    testing::FakeEngine engine(script, 0.1, {}, {blade});
    EnergySeries series;
    EXPECT_TRUE(series.empty());
    series.add(engine);
    engine.set_wall_velocity(0, {3, 0, 0});
    engine.advance(7);
    series.add(engine);
    series.write_csv(folder / "energy.csv");
    std::ifstream file(folder / "energy.csv");
    std::string header, first, second;
    std::getline(file, header);
    std::getline(file, first);
    std::getline(file, second);
    EXPECT_EQ(header,
              "step,time_s,kinetic_translation_J,kinetic_rotation_J,elastic_normal_J,elastic_tangential_J,gravity_J,"
              "cohesion_J,dissipated_normal_J,dissipated_tangential_J,dissipated_rolling_J,wall_work_J,"
              "removed_with_walls_J");
    EXPECT_EQ(first, "0,0,0,0,0,0,0,0,0,0,0,0,0");
    std::vector<double> values;
    std::istringstream row(second);
    for (std::string cell; std::getline(row, cell, ',');) values.push_back(std::stod(cell));
    ASSERT_EQ(values.size(), 13U);
    EXPECT_EQ(values[0], 7);
    EXPECT_EQ(values[1], engine.time());
    EXPECT_EQ(values[11], engine.ledger().wall_work);
}

}  // namespace
}  // namespace recoat
