#include <fstream>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "common/error.hpp"
#include "solver/sweep_file.hpp"
#include "tests/support/scene_text.hpp"
#include "tests/support/temporary_folder.hpp"
#include "tests/support/throws_message.hpp"

namespace recoat {
namespace {

namespace fs = std::filesystem;
using ::testing::EndsWith;
using ::testing::HasSubstr;
using ::testing::StartsWith;

class SweepFile : public ::testing::Test {
protected:
    SweepFile() { write("scene.yaml", testing::spread_text); }

    void write(const std::string& name, const std::string& text) const { std::ofstream(folder_ / name) << text; }
    [[nodiscard]] std::vector<SweepCase> read(const std::string& text) const {
        write("sweep.yaml", text);
        return read_sweep(folder_ / "sweep.yaml");
    }
    /// The sentence without the folder.
    [[nodiscard]] std::string refusal(const std::string& text) const {
        const std::string sentence = testing::message_of<InputError>([&] { (void)read(text); });
        const std::string start = (folder_ / "").string();
        EXPECT_THAT(sentence, StartsWith(start));
        return sentence.substr(start.size());
    }

    testing::TemporaryFolder folder_;
};

TEST_F(SweepFile, EachCaseHasItsSettingsSceneAndFolder) {
    write("other.yaml", testing::spread_text);
    const auto cases = read(
        "scene: scene.yaml\n"
        "cases:\n"
        "  - {out: a, set: [powder.particles=30, seed=7]}\n"
        "  - out: deep/b\n"
        "  - {out: /tmp/c, scene: other.yaml, set: [powder.particles=50]}\n");
    ASSERT_EQ(cases.size(), 3U);
    EXPECT_EQ(cases[0].name, "a");
    EXPECT_EQ(cases[0].folder, folder_ / "a");
    EXPECT_THAT(cases[0].scene.resolved, HasSubstr("particles: 30"));
    EXPECT_THAT(cases[0].scene.resolved, HasSubstr("seed: 7"));
    EXPECT_EQ(cases[1].folder, folder_ / "deep/b");
    EXPECT_THAT(cases[1].scene.resolved, HasSubstr("particles: 40"));
    EXPECT_EQ(cases[2].folder, "/tmp/c");
    EXPECT_THAT(cases[2].scene.resolved, HasSubstr("particles: 50"));
}

TEST_F(SweepFile, TheSceneOfACaseIsThatOfASingleRun) {
    const std::vector<std::string> settings = {"powder.particles=30"};
    const auto cases = read("scene: scene.yaml\ncases:\n  - {out: a, set: [powder.particles=30]}\n");
    EXPECT_EQ(cases[0].scene.resolved, load_scene(folder_ / "scene.yaml", settings).resolved);
}

TEST_F(SweepFile, WhatIsWrongIsSaidWithItsPlace) {
    EXPECT_THAT(refusal("scene: scene.yaml\n"), StartsWith("sweep.yaml:1: cases: the key is missing"));
    EXPECT_EQ(refusal("scene: scene.yaml\ncases: []\n"),
              "sweep.yaml:2: cases: the list is empty; give at least one case");
    EXPECT_THAT(refusal("scene: scene.yaml\ncases:\n  - {set: [seed=1]}\n"),
                StartsWith("sweep.yaml:3: cases.0.out: the key is missing"));
    EXPECT_EQ(refusal("cases:\n  - {out: a}\n"),
              "sweep.yaml:2: cases.0.scene: the key is missing; name a scene here, or one for all cases at the top of "
              "the file");
    EXPECT_THAT(refusal("scene: scene.yaml\ncases:\n  - {out: a}\n  - {out: b, sets: [seed=1]}\n"),
                StartsWith("sweep.yaml:4: cases.1.sets: "));
    EXPECT_THAT(refusal("scene: scene.yaml\njobs: 3\ncases:\n  - {out: a}\n"), StartsWith("sweep.yaml:2: jobs: "));
    EXPECT_THAT(refusal("scene: scene.yaml\ncases:\n  - {out: a, set: seed=1}\n"),
                StartsWith("sweep.yaml:3: cases.0.set: this is not a list"));
    EXPECT_THAT(refusal("scene: scene.yaml\ncases:\n  - {out: \"\"}\n"),
                StartsWith("sweep.yaml:3: cases.0.out: the text is empty"));
}

TEST_F(SweepFile, ABadSceneIsRefusedWithTheCaseItIsOf) {
    EXPECT_THAT(refusal("scene: scene.yaml\ncases:\n  - {out: a}\n  - {out: b, set: [contact.restitution=2]}\n"),
                StartsWith("sweep.yaml:4: cases.1: --set contact.restitution=2: contact.restitution: 2 is out of"));
    const std::string missing = refusal("scene: missing.yaml\ncases:\n  - {out: a}\n");
    EXPECT_THAT(missing, StartsWith("sweep.yaml:3: cases.0: "));
    EXPECT_THAT(missing, EndsWith("missing.yaml: the file cannot be read or is empty; check its name and permissions"));
}

TEST_F(SweepFile, TwoCasesWithOneFolderAreRefused) {
    const std::string sentence =
        "sweep.yaml:4: cases.1.out: this folder is that of cases.0 too; give each case its own";
    for (const std::string& other : std::vector<std::string>{"a", "./a", "a/", "b/../a", (folder_ / "a").string()}) {
        EXPECT_EQ(refusal("scene: scene.yaml\ncases:\n  - {out: a}\n  - {out: " + other + "}\n"), sentence) << other;
    }
    fs::create_directory(folder_ / "a");
    fs::create_directory_symlink(folder_ / "a", folder_ / "link");
    EXPECT_EQ(refusal("scene: scene.yaml\ncases:\n  - {out: a}\n  - {out: link}\n"), sentence);
}

}  // namespace
}  // namespace recoat
