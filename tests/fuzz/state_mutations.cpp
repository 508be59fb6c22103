#include "tests/fuzz/state_mutations.hpp"

#include <array>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <limits>
#include <vector>

#include <hdf5.h>

#include "common/state.hpp"

namespace recoat::fuzz {
namespace {

/// Takes numbers from bytes; zeros when there are none left.
class Recipe {
public:
    explicit Recipe(std::span<const std::uint8_t> bytes) : bytes_(bytes) {}
    [[nodiscard]] bool empty() const { return bytes_.empty(); }
    std::size_t below(std::size_t count) {
        if (bytes_.empty()) return 0;
        const std::size_t value = bytes_.front() % count;
        bytes_ = bytes_.subspan(1);
        return value;
    }
    template <class Value, std::size_t Count>
    Value one_of(const std::array<Value, Count>& values) {
        return values[below(Count)];
    }

private:
    std::span<const std::uint8_t> bytes_;
};

constexpr std::array<const char*, 22> objects = {"VTKHDF",
                                                 "recoat",
                                                 "VTKHDF/Points",
                                                 "VTKHDF/NumberOfPoints",
                                                 "VTKHDF/PointData",
                                                 "VTKHDF/PointData/Id",
                                                 "VTKHDF/PointData/Radius",
                                                 "VTKHDF/PointData/Velocity",
                                                 "VTKHDF/PointData/AngularVelocity",
                                                 "VTKHDF/PointData/Extra",
                                                 "VTKHDF/FieldData",
                                                 "VTKHDF/FieldData/Step",
                                                 "VTKHDF/FieldData/Time",
                                                 "VTKHDF/Steps",
                                                 "VTKHDF/Steps/Values",
                                                 "VTKHDF/Steps/PointOffsets",
                                                 "VTKHDF/Steps/PartOffsets",
                                                 "VTKHDF/Steps/NumberOfParts",
                                                 "VTKHDF/Steps/PointDataOffsets",
                                                 "VTKHDF/Steps/PointDataOffsets/Radius",
                                                 "VTKHDF/PointData/v",
                                                 "VTKHDF/PointData/d"};
struct Attribute {
    const char *object, *name;
};
constexpr std::array<Attribute, 9> attributes = {{{"VTKHDF", "Type"},
                                                  {"VTKHDF", "Version"},
                                                  {"VTKHDF/Steps", "NSteps"},
                                                  {"recoat", "schema_version"},
                                                  {"recoat", "stage"},
                                                  {"recoat", "particle_diameter"},
                                                  {"recoat", "y_period"},
                                                  {"recoat", "seed"},
                                                  {"recoat", "config"}}};

constexpr std::array<hsize_t, 11> lengths = {0, 1, 2, 3, 4, 6, 7, 18, 1ULL << 20, 1ULL << 40, 1ULL << 62};
constexpr std::array<std::int64_t, 11> integers = {0,
                                                   1,
                                                   -1,
                                                   2,
                                                   3,
                                                   6,
                                                   100,
                                                   1LL << 40,
                                                   1LL << 60,
                                                   std::numeric_limits<std::int64_t>::max(),
                                                   std::numeric_limits<std::int64_t>::min()};
constexpr std::array<double, 8> reals = {
    0, 1, -1, 1e-5, 1e300, std::numeric_limits<double>::infinity(), std::numeric_limits<double>::quiet_NaN(), 5e-324};

hid_t type_of(Recipe& recipe) {
    constexpr std::size_t text_length = 8;
    const std::size_t kind = recipe.below(9);
    if (kind == 7) {
        const hid_t text = H5Tcopy(H5T_C_S1);
        H5Tset_size(text, recipe.below(2) == 0 ? text_length : H5T_VARIABLE);
        return text;
    }
    if (kind == 8) {
        const hid_t compound = H5Tcreate(H5T_COMPOUND, 2 * sizeof(double));
        H5Tinsert(compound, "x", 0, H5T_NATIVE_DOUBLE);
        H5Tinsert(compound, "y", sizeof(double), H5T_NATIVE_DOUBLE);
        return compound;
    }
    const std::array<hid_t, 7> plain = {H5T_NATIVE_DOUBLE, H5T_NATIVE_FLOAT, H5T_NATIVE_INT64, H5T_STD_I32BE,
                                        H5T_NATIVE_UINT8,  H5T_STD_U64BE,    H5T_NATIVE_INT8};
    return H5Tcopy(plain[kind]);
}

/// Any space, or that of the array with one length changed.
hid_t space_of(hid_t file, const char* name, Recipe& recipe) {
    std::vector<hsize_t> shape;
    const hid_t array = recipe.below(2) == 0 ? H5Dopen2(file, name, H5P_DEFAULT) : H5I_INVALID_HID;
    if (array >= 0) {
        const hid_t own = H5Dget_space(array);
        shape.resize(static_cast<std::size_t>(H5Sget_simple_extent_ndims(own)));
        H5Sget_simple_extent_dims(own, shape.data(), nullptr);
        H5Sclose(own);
        H5Dclose(array);
        if (!shape.empty()) shape[recipe.below(shape.size())] = recipe.one_of(lengths);
    } else {
        shape.resize(recipe.below(4));
        for (hsize_t& length : shape) length = recipe.one_of(lengths);
    }
    return H5Screate_simple(static_cast<int>(shape.size()), shape.data(), nullptr);
}

void replace_array(hid_t file, const char* name, Recipe& recipe) {
    const hid_t type = type_of(recipe), space = space_of(file, name, recipe);
    H5Ldelete(file, name, H5P_DEFAULT);
    const hid_t properties = H5Pcreate(H5P_DATASET_CREATE);
    if (recipe.below(2) == 1) {
        const std::array<hsize_t, 3> chunk = {2, 3, 1};
        H5Pset_chunk(properties, H5Sget_simple_extent_ndims(space), chunk.data());
    }
    const double fill = recipe.one_of(reals);
    if (H5Tget_class(type) == H5T_FLOAT) H5Pset_fill_value(properties, H5T_NATIVE_DOUBLE, &fill);
    const hid_t array = H5Dcreate2(file, name, type, space, H5P_DEFAULT, properties, H5P_DEFAULT);
    if (array >= 0) H5Dclose(array);
    H5Pclose(properties);
    H5Sclose(space);
    H5Tclose(type);
}

void change_value(hid_t file, const char* name, Recipe& recipe) {
    const hid_t array = H5Dopen2(file, name, H5P_DEFAULT);
    if (array < 0) return;
    const hid_t space = H5Dget_space(array), type = H5Dget_type(array), one = H5Screate(H5S_SCALAR);
    std::array<hsize_t, H5S_MAX_RANK> place = {};
    const int rank = H5Sget_simple_extent_ndims(space);
    for (int axis = 0; axis < rank; ++axis) place[static_cast<std::size_t>(axis)] = recipe.below(6);
    if (rank > 0) H5Sselect_elements(space, H5S_SELECT_SET, 1, place.data());
    if (H5Tget_class(type) == H5T_INTEGER) {
        const std::int64_t value = recipe.one_of(integers);
        H5Dwrite(array, H5T_NATIVE_INT64, one, space, H5P_DEFAULT, &value);
    } else if (H5Tget_class(type) == H5T_FLOAT) {
        const double value = recipe.one_of(reals);
        H5Dwrite(array, H5T_NATIVE_DOUBLE, one, space, H5P_DEFAULT, &value);
    }
    H5Sclose(one);
    H5Tclose(type);
    H5Sclose(space);
    H5Dclose(array);
}

void replace_attribute(hid_t file, const Attribute& attribute, Recipe& recipe) {
    const hid_t object = H5Oopen(file, attribute.object, H5P_DEFAULT);
    if (object < 0) return;
    H5Adelete(object, attribute.name);
    const std::size_t kind = recipe.below(4);
    if (kind == 1) {
        const std::int64_t value = recipe.one_of(integers);
        const hid_t space = H5Screate(H5S_SCALAR);
        const hid_t made = H5Acreate2(object, attribute.name, H5T_NATIVE_INT64, space, H5P_DEFAULT, H5P_DEFAULT);
        H5Awrite(made, H5T_NATIVE_INT64, &value);
        H5Aclose(made);
        H5Sclose(space);
    } else if (kind > 1) {
        const hsize_t length = 1 + recipe.below(3);
        const hid_t type = type_of(recipe);
        const hid_t space = kind == 2 ? H5Screate(H5S_NULL) : H5Screate_simple(1, &length, nullptr);
        const hid_t made = H5Acreate2(object, attribute.name, type, space, H5P_DEFAULT, H5P_DEFAULT);
        if (made >= 0) H5Aclose(made);
        H5Sclose(space);
        H5Tclose(type);
    }
    H5Oclose(object);
}

void change_link(hid_t file, const char* name, Recipe& recipe) {
    H5Ldelete(file, name, H5P_DEFAULT);
    const std::size_t kind = recipe.below(4);
    if (kind == 1) H5Lcreate_soft(recipe.one_of(objects), file, name, H5P_DEFAULT, H5P_DEFAULT);
    if (kind == 2) H5Lcreate_hard(file, recipe.one_of(objects), file, name, H5P_DEFAULT, H5P_DEFAULT);
    if (kind == 3) {
        const hid_t group = H5Gcreate2(file, name, H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT);
        if (group >= 0) H5Gclose(group);
    }
}

}  // namespace

std::string small_state_file() {
    std::string folder = "/tmp/recoat-fuzz-XXXXXX";
    if (mkdtemp(folder.data()) == nullptr) std::abort();
    const auto path = std::filesystem::path(folder) / "small.vtkhdf";
    StateWriter writer(path, {});
    for (const std::int64_t step : {0, 5}) {
        State state;
        state.step = step;
        state.id = {1, 2, 3};
        state.position = {{1, 2, 3}, {4, 5, 6}, {7, 8, 9}};
        state.velocity = state.angular_velocity = state.position;
        state.radius = {0.5, 0.25, 0.5};
        state.scalars["Extra"] = {1, 2, 3};
        writer.append(state);
    }
    writer.close();
    std::ifstream stream(path, std::ios::binary);
    std::string bytes{std::istreambuf_iterator<char>(stream), {}};
    std::filesystem::remove_all(folder);
    return bytes;
}

void mutate(const std::filesystem::path& path, std::span<const std::uint8_t> bytes) {
    H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr);
    const hid_t file = H5Fopen(path.c_str(), H5F_ACC_RDWR, H5P_DEFAULT);
    for (Recipe recipe(bytes); !recipe.empty();) {
        const std::size_t kind = recipe.below(8);
        if (kind == 0) {
            change_link(file, recipe.one_of(objects), recipe);
        } else if (kind < 3) {
            replace_array(file, recipe.one_of(objects), recipe);
        } else if (kind < 6) {
            change_value(file, recipe.one_of(objects), recipe);
        } else {
            replace_attribute(file, recipe.one_of(attributes), recipe);
        }
    }
    H5Fclose(file);
}

}  // namespace recoat::fuzz
