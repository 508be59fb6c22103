#include <algorithm>
#include <memory>

#include <fmt/format.h>
#include <hdf5.h>

#include "common/error.hpp"
#include "common/hdf5.hpp"
#include "common/hdf5_lock.hpp"

namespace recoat::hdf5 {
namespace {

constexpr std::size_t largest_attribute = 60000;  // HDF5 keeps an attribute within 64 KiB

[[noreturn]] void fail(const std::string& place, const std::string& name, const std::string& problem) {
    throw InputError(fmt::format("{}: attribute {}: {}", place, name, problem));
}

void write_value(hid_t object, const std::string& place, const std::string& name, hid_t type, const Handle& space,
                 const void* value) {
    if (H5Aexists(object, name.c_str()) > 0) H5Adelete(object, name.c_str());
    const Handle attribute(H5Acreate2(object, name.c_str(), type, space.id(), H5P_DEFAULT, H5P_DEFAULT), H5Aclose);
    if (attribute.id() < 0 || H5Awrite(attribute.id(), type, value) < 0)
        fail(place, name, "writing failed; is the disk full?");
}

Handle scalar_space() { return {H5Screate(H5S_SCALAR), H5Sclose}; }

void write_text(hid_t object, const std::string& place, const std::string& name, const std::string& text) {
    if (text.size() > largest_attribute)
        fail(place, name, "the text is longer than 60000 bytes; shorten the configuration");
    const Handle type(H5Tcopy(H5T_C_S1), H5Tclose);
    H5Tset_size(type.id(), std::max<std::size_t>(1, text.size()));
    H5Tset_strpad(type.id(), H5T_STR_NULLPAD);
    const bool ascii = std::all_of(text.begin(), text.end(), [](unsigned char c) { return c < 128; });
    H5Tset_cset(type.id(), ascii ? H5T_CSET_ASCII : H5T_CSET_UTF8);
    write_value(object, place, name, type.id(), scalar_space(), text.c_str());
}

/// An attribute that holds one value of the given class.
Handle open_single(hid_t object, const std::string& place, const std::string& name, H5T_class_t wanted) {
    if (H5Aexists(object, name.c_str()) <= 0)
        fail(place, name, "it is missing; the file is of another kind or damaged");
    Handle attribute(H5Aopen(object, name.c_str(), H5P_DEFAULT), H5Aclose);
    const Handle type(H5Aget_type(attribute.id()), H5Tclose);
    const Handle space(H5Aget_space(attribute.id()), H5Sclose);
    if (H5Tget_class(type.id()) != wanted || H5Sget_simple_extent_npoints(space.id()) != 1) {
        fail(place, name, "it holds another kind of value than expected; the file is of another kind or damaged");
    }
    return attribute;
}

/// A text of variable length, which the library allocates.
std::string variable_text(const Handle& attribute, const Handle& type, const std::string& place,
                          const std::string& name) {
    char* value = nullptr;
    if (H5Aread(attribute.id(), type.id(), &value) < 0) fail(place, name, "reading failed; the file seems damaged");
    const std::unique_ptr<char, decltype(&H5free_memory)> owner(value, H5free_memory);
    return value == nullptr ? std::string() : std::string(value);
}

}  // namespace

void Group::set_attribute(const std::string& name, double value) const {
    const LibraryLock lock;
    write_value(handle_.id(), place_, name, H5T_NATIVE_DOUBLE, scalar_space(), &value);
}

void Group::set_attribute(const std::string& name, std::int64_t value) const {
    const LibraryLock lock;
    write_value(handle_.id(), place_, name, H5T_NATIVE_INT64, scalar_space(), &value);
}

void Group::set_attribute(const std::string& name, const std::vector<std::int64_t>& values) const {
    const LibraryLock lock;
    const hsize_t size = values.size();
    write_value(handle_.id(), place_, name, H5T_NATIVE_INT64, {H5Screate_simple(1, &size, nullptr), H5Sclose},
                values.data());
}

void Group::set_attribute(const std::string& name, const std::string& text) const {
    const LibraryLock lock;
    write_text(handle_.id(), place_, name, text);
}

void Group::set_dataset_attribute(const std::string& dataset_name, const std::string& name,
                                  const std::string& text) const {
    const LibraryLock lock;
    const Dataset array = dataset(dataset_name);
    write_text(array.handle_.id(), array.place_, name, text);
}

bool Group::has_attribute(const std::string& name) const {
    const LibraryLock lock;
    return H5Aexists(handle_.id(), name.c_str()) > 0;
}

double Group::real_attribute(const std::string& name) const {
    const LibraryLock lock;
    const Handle attribute = open_single(handle_.id(), place_, name, H5T_FLOAT);
    double value = 0;
    if (H5Aread(attribute.id(), H5T_NATIVE_DOUBLE, &value) < 0)
        fail(place_, name, "reading failed; the file seems damaged");
    return value;
}

std::int64_t Group::integer_attribute(const std::string& name) const {
    const LibraryLock lock;
    const Handle attribute = open_single(handle_.id(), place_, name, H5T_INTEGER);
    std::int64_t value = 0;
    if (H5Aread(attribute.id(), H5T_NATIVE_INT64, &value) < 0)
        fail(place_, name, "reading failed; the file seems damaged");
    return value;
}

std::string Group::text_attribute(const std::string& name) const {
    const LibraryLock lock;
    const Handle attribute = open_single(handle_.id(), place_, name, H5T_STRING);
    const Handle type(H5Aget_type(attribute.id()), H5Tclose);
    if (H5Tis_variable_str(type.id()) > 0) return variable_text(attribute, type, place_, name);
    std::string text(H5Tget_size(type.id()), '\0');
    if (H5Aread(attribute.id(), type.id(), text.data()) < 0)
        fail(place_, name, "reading failed; the file seems damaged");
    text.resize(std::min(text.size(), text.find('\0')));
    return text;
}

}  // namespace recoat::hdf5
