#include <fstream>
#include <functional>
#include <sstream>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "common/error.hpp"
#include "common/output_file.hpp"
#include "solver/run.hpp"
#include "solver/scene/initial_particles.hpp"
#include "tests/stress/ledger_check.hpp"
#include "tests/stress/ledger_rows.hpp"
#include "tests/support/scene_text.hpp"
#include "tests/support/temporary_folder.hpp"
#include "tests/support/throws_message.hpp"

namespace recoat::stress {
namespace {

using recoat::testing::message_of;
using recoat::testing::TemporaryFolder;

using Lines = std::vector<std::string>;
constexpr std::int64_t steps = 1000, interval = 100;

/// A sphere that hits the floor: its run, and its energy.csv to be spoiled.
class LedgerFile : public ::testing::Test {
protected:
    void SetUp() override {
        write_text_file(folder_ / "particles.csv",
                        "x,y,z,radius,vx,vy,vz,wx,wy,wz\n0,0,25.1e-6,25e-6,0.02,0,-0.05,0,0,0\n");
        write_text_file(folder_ / "scene.yaml", "scene: particles\nstiffness_ratio: 0.001\n" +
                                                    recoat::testing::model_text +
                                                    "particles: particles.csv\nduration: 20 us\n"
                                                    "walls:\n  - plane: {name: floor, normal: [0, 0, 1]}\n"
                                                    "output: {energy_interval: 2 us}\n");
        scene_ = load_scene(folder_ / "scene.yaml");
        RunOptions options;
        options.folder = folder_ / "out";
        options.quiet = true;
        run_scene(scene_, options, EngineFactory{make_engine, restore_engine});
    }

    [[nodiscard]] std::filesystem::path file() const { return folder_.path() / "out/energy.csv"; }

    [[nodiscard]] LedgerCheck check() const {
        return check_ledger(scene_, file(), steps, 0.005 * scene_.diameter, initial_particles(scene_));
    }

    /// What the check says of the file after `spoil` has changed its lines.
    [[nodiscard]] std::string finding(const std::function<void(Lines&)>& spoil) const {
        std::ifstream stream(file());
        Lines lines;
        for (std::string line; std::getline(stream, line);) lines.push_back(line);
        spoil(lines);
        std::string text;
        for (const std::string& line : lines) text += line + "\n";
        write_text_file(file(), text);
        return message_of<InputError>([&] { static_cast<void>(check()); });
    }

    TemporaryFolder folder_;
    Scene scene_;
};

/// Replaces a cell of a line.
void set_cell(std::string& line, std::size_t column, const std::string& text) {
    std::stringstream stream(line);
    std::string cell, changed;
    for (std::size_t k = 0; std::getline(stream, cell, ','); ++k)
        changed += (k ? "," : "") + (k == column ? text : cell);
    line = changed;
}

TEST_F(LedgerFile, ThatIsWholeIsClosed) {
    EXPECT_EQ(read_ledger_rows(file(), steps, interval).size(), 11);
    const LedgerCheck found = check();
    EXPECT_GT(found.error, 0);
    EXPECT_LT(found.error, found.bound);
}

TEST_F(LedgerFile, ThatIsMissingIsAFinding) {
    std::filesystem::remove(file());
    EXPECT_EQ(message_of<InputError>([&] { static_cast<void>(check()); }), "energy.csv is missing");
}

TEST_F(LedgerFile, ThatIsEmptyIsAFinding) {
    EXPECT_NE(finding([](Lines& lines) { lines.clear(); }).find("other columns"), std::string::npos);
}

TEST_F(LedgerFile, OfAHeaderOnlyIsAFinding) {
    EXPECT_EQ(finding([](Lines& lines) { lines.resize(1); }), "energy.csv has 0 rows, not 11");
}

TEST_F(LedgerFile, ThatIsCutShortIsAFinding) {
    EXPECT_EQ(finding([](Lines& lines) { lines.pop_back(); }), "energy.csv has 10 rows, not 11");
}

TEST_F(LedgerFile, WithoutARowInItsMiddleIsAFinding) {
    EXPECT_EQ(finding([](Lines& lines) { lines.erase(lines.begin() + 4); }),
              "energy.csv, row of step 300: its step is 400");
}

TEST_F(LedgerFile, WithACutRowIsAFinding) {
    EXPECT_EQ(finding([](Lines& lines) { lines[3].resize(lines[3].rfind(',')); }),
              "energy.csv, row of step 200: 12 cells");
}

TEST_F(LedgerFile, OfOtherColumnsIsAFinding) {
    EXPECT_NE(finding([](Lines& lines) { set_cell(lines[0], 2, "kinetic"); }).find("other columns"), std::string::npos);
}

TEST_F(LedgerFile, WithANumberThatIsNoneIsAFinding) {
    for (const char* text : {"", "x", "1e-9z", "nan", "inf", "-inf"})
        EXPECT_EQ(finding([&](Lines& lines) { set_cell(lines[5], 4, text); }),
                  "energy.csv, row of step 400: elastic_normal is \"" + std::string(text) + "\"");
}

TEST_F(LedgerFile, WhoseSumIsNotFiniteIsAFinding) {
    const auto spoil = [](Lines& lines) {
        for (const std::size_t column : {2, 3}) set_cell(lines[5], column, "1.7e308");
    };
    EXPECT_EQ(finding(spoil), "the balance of energy.csv is not a finite number");
}

TEST_F(LedgerFile, WithEnergyThatAppearsIsOpen) {
    std::ifstream stream(file());
    std::string text, line;
    for (int row = 0; std::getline(stream, line); ++row) {
        if (row == 11) set_cell(line, 2, "1e-9");
        text += line + "\n";
    }
    write_text_file(file(), text);
    const LedgerCheck found = check();
    EXPECT_GT(found.error, found.bound);
}

}  // namespace
}  // namespace recoat::stress
