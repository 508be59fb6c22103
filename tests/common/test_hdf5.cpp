#include <cmath>
#include <fstream>

#include <gtest/gtest.h>

#include "common/error.hpp"
#include "common/hdf5.hpp"
#include "tests/support/temporary_folder.hpp"
#include "tests/support/throws_message.hpp"

namespace recoat::hdf5 {
namespace {

using recoat::testing::message_of;
using recoat::testing::TemporaryFolder;

class Hdf5 : public ::testing::Test {
protected:
    TemporaryFolder folder;
    std::filesystem::path path = folder / "a.h5";
};

TEST_F(Hdf5, ArraysReadBackTheSame) {
    const std::vector<double> reals = {0.1, -1e300, 5e-324, 0, 1.0 / 3, 2};
    const std::vector<std::int64_t> integers = {INT64_MIN, -1, INT64_MAX};
    const std::vector<std::int32_t> shorts = {INT32_MIN, 7};
    {
        const auto file = File::create(path);
        file.write("reals", reals, {3, 2});
        file.write("small", reals, {3, 2}, true);
        const auto group = file.create_group("group");
        group.write("integers", integers);
        group.write("shorts", shorts);
        group.write("nothing", std::vector<double>{});
    }
    const auto file = File::open(path);
    EXPECT_EQ(file.read<double>("reals"), reals);
    EXPECT_EQ(file.read<double>("small"), reals);
    EXPECT_EQ(file.dataset("reals").shape(), (Shape{3, 2}));
    EXPECT_EQ(file.group("group").read<std::int64_t>("integers"), integers);
    EXPECT_EQ(file.group("group").read<std::int32_t>("shorts"), shorts);
    EXPECT_TRUE(file.read<double>("group/nothing").empty());
    EXPECT_EQ(file.group("group").names(), (std::vector<std::string>{"integers", "nothing", "shorts"}));
    EXPECT_TRUE(file.has("group"));
    EXPECT_FALSE(file.has("absent/array"));
}

TEST_F(Hdf5, ExtendibleArraysGrowByRows) {
    {
        const auto file = File::create(path);
        const auto rows = file.create_extendible<double>("rows", {3}, 2);
        rows.append(std::vector<double>{1, 2, 3});
        rows.append(std::vector<double>{});
        rows.append(std::vector<double>{4, 5, 6, 7, 8, 9});
        EXPECT_THROW(rows.append(std::vector<double>{1}), std::invalid_argument);
    }
    const auto rows = File::open(path).dataset("rows");
    EXPECT_EQ(rows.shape(), (Shape{3, 3}));
    EXPECT_EQ(rows.read_rows<double>(1, 1), (std::vector<double>{4, 5, 6}));
    EXPECT_EQ(rows.read_rows<double>(1, 0), std::vector<double>{});
    EXPECT_THROW((void)rows.read_rows<double>(2, 2), InputError);
}

TEST_F(Hdf5, AttributesReadBackTheSame) {
    {
        const auto file = File::create(path);
        file.set_attribute("real", 0.1);
        file.set_attribute("unknown", std::nan(""));
        file.set_attribute("integer", std::int64_t{-3});
        file.set_attribute("integer", std::int64_t{-4});
        file.set_attribute("text", std::string("µ: a\nb"));
        file.set_attribute("empty", std::string());
    }
    const auto file = File::open(path);
    EXPECT_EQ(file.real_attribute("real"), 0.1);
    EXPECT_TRUE(std::isnan(file.real_attribute("unknown")));
    EXPECT_EQ(file.integer_attribute("integer"), -4);
    EXPECT_EQ(file.text_attribute("text"), "µ: a\nb");
    EXPECT_EQ(file.text_attribute("empty"), "");
    EXPECT_FALSE(file.has_attribute("absent"));
    EXPECT_THROW((void)file.real_attribute("absent"), InputError);
    EXPECT_THROW((void)file.real_attribute("text"), InputError);
}

TEST_F(Hdf5, SameContentIsTheSameBytes) {
    const auto bytes = [&](const std::string& name) {
        {
            const auto file = File::create(folder / name);
            file.create_group("g").write("a", std::vector<double>{1, 2, 3});
            file.create_extendible<double>("b", {}, 4).append(std::vector<double>{1, 2, 3});
        }
        std::ifstream stream(folder / name, std::ios::binary);
        return std::string(std::istreambuf_iterator<char>(stream), {});
    };
    const std::string first = bytes("1.h5");
    // HDF5 would store the time of creation in whole seconds.
    ::sleep(1);
    EXPECT_EQ(first, bytes("2.h5"));
}

TEST_F(Hdf5, AUserBlockBelongsToTheCaller) {
    {
        File file = File::create(path, 512);
        file.write("a", std::vector<double>{1, 2});
        file.close();
    }
    std::fstream(path, std::ios::in | std::ios::out | std::ios::binary) << std::string(512, 'x');
    EXPECT_TRUE(is_hdf5(path));
    EXPECT_EQ(File::open(path).read<double>("a"), (std::vector<double>{1, 2}));
    EXPECT_THROW(File::create(path, 100), InputError);
}

TEST_F(Hdf5, DamagedAndForeignFilesAreRefusedByName) {
    EXPECT_EQ(message_of<InputError>([&] { (void)File::open(path); }),
              path.string() + ": there is no such file; check its name");
    std::ofstream(path) << "x,y,z\n1,2,3\n";
    EXPECT_FALSE(is_hdf5(path));
    const std::string refusal =
        path.string() + ": this is not a whole HDF5 file; it may be of another kind, cut off or damaged";
    EXPECT_EQ(message_of<InputError>([&] { (void)File::open(path); }), refusal);
    File::create(path).write("a", std::vector<double>(1000, 1.5));
    EXPECT_TRUE(is_hdf5(path));
    std::filesystem::resize_file(path, std::filesystem::file_size(path) / 2);
    EXPECT_EQ(message_of<InputError>([&] { (void)File::open(path); }), refusal);
}

TEST_F(Hdf5, MissingAndMistypedArraysAreRefused) {
    File::create(path).write("a", std::vector<double>{1});
    const auto file = File::open(path);
    EXPECT_NE(message_of<InputError>([&] { (void)file.read<double>("b"); }).find("/b: the array is missing"),
              std::string::npos);
    EXPECT_THROW((void)file.read<std::int64_t>("a"), InputError);
    EXPECT_THROW((void)file.group("g"), InputError);
}

}  // namespace
}  // namespace recoat::hdf5
