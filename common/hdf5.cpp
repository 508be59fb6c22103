#include "common/hdf5.hpp"

#include <algorithm>
#include <numeric>
#include <utility>

#include <fmt/format.h>
#include <hdf5.h>

#include "common/error.hpp"
#include "common/hdf5_lock.hpp"

namespace recoat::hdf5 {
namespace {

static_assert(std::is_same_v<hid_t, std::int64_t>, "handles hold the identifiers of HDF5 1.10 and newer");

/// Before any other call to HDF5: at the end of a program it would try once more to write the files that a full disk
/// did not take, and crash. Handles close everything else by themselves.
[[maybe_unused]] const herr_t no_work_at_exit = H5dont_atexit();

template <class Number>
hid_t number_type() {
    if constexpr (std::is_same_v<Number, double>) return H5T_NATIVE_DOUBLE;
    if constexpr (std::is_same_v<Number, std::int64_t>) return H5T_NATIVE_INT64;
    if constexpr (std::is_same_v<Number, std::int32_t>) return H5T_NATIVE_INT32;
}

[[noreturn]] void fail(const std::string& place, const std::string& problem) {
    throw InputError(fmt::format("{}: {}", place, problem));
}

Handle open(hid_t id, Handle::Close close, const std::string& place, const std::string& problem) {
    if (id < 0) fail(place, problem);
    return {id, close};
}

void check(herr_t status, const std::string& place, const std::string& problem) {
    if (status < 0) fail(place, problem);
}

const std::string cannot_write = "writing failed; is the disk full?";
const std::string cannot_read = "reading failed; the file seems damaged";

Handle space_of(const Shape& shape, const std::string& place) {
    const std::vector<hsize_t> sizes(shape.begin(), shape.end());
    return open(H5Screate_simple(static_cast<int>(sizes.size()), sizes.data(), nullptr), H5Sclose, place, cannot_write);
}

/// Without times of creation the same data give the same bytes.
Handle dataset_properties(const std::string& place) {
    Handle properties = open(H5Pcreate(H5P_DATASET_CREATE), H5Pclose, place, cannot_write);
    H5Pset_obj_track_times(properties.id(), false);
    return properties;
}

std::size_t product(const Shape& shape) {
    return std::accumulate(shape.begin(), shape.end(), std::size_t{1}, std::multiplies<>());
}

Shape shape_of(hid_t dataset) {
    const Handle space(H5Dget_space(dataset), H5Sclose);
    std::vector<hsize_t> sizes(static_cast<std::size_t>(std::max(0, H5Sget_simple_extent_ndims(space.id()))));
    H5Sget_simple_extent_dims(space.id(), sizes.data(), nullptr);
    return {sizes.begin(), sizes.end()};
}

/// Selects rows first ... first + count - 1 and returns the space in the file and in memory.
std::pair<Handle, Handle> select_rows(hid_t dataset, std::size_t first, std::size_t count, const std::string& place) {
    Shape shape = shape_of(dataset);
    // Without first + count, which may be more than fits.
    if (shape.empty() || first > shape[0] || count > shape[0] - first) {
        fail(place, "the array has too few rows; the file seems damaged");
    }
    Handle file_space = open(H5Dget_space(dataset), H5Sclose, place, cannot_read);
    shape[0] = count;
    std::vector<hsize_t> start(shape.size(), 0);
    start[0] = first;
    const std::vector<hsize_t> extent(shape.begin(), shape.end());
    check(H5Sselect_hyperslab(file_space.id(), H5S_SELECT_SET, start.data(), nullptr, extent.data(), nullptr), place,
          cannot_read);
    return {std::move(file_space), space_of(shape, place)};
}

/// Number of elements in `shape`, which must be as many as the stored bytes of the array can hold when they are packed
/// as tightly as they can be: damaged files announce any number.
std::size_t believable_size(hid_t dataset, const Shape& shape, const std::string& place) {
    constexpr std::size_t always = std::size_t{1} << 20, largest_ratio = 1032;  // of deflate
    std::size_t stored = H5Dget_storage_size(dataset);
    const Handle file(H5Iget_file_id(dataset), H5Fclose);
    hsize_t file_size = 0;
    if (H5Fget_filesize(file.id(), &file_size) >= 0) stored = std::min<std::size_t>(stored, file_size);
    const std::size_t most = std::max(always, largest_ratio * stored);
    std::size_t size = 1;
    for (const std::size_t length : shape) {
        if (length != 0 && size > most / length) {
            fail(place, "the array says that it is larger than its file can be; the file seems damaged");
        }
        size *= length;
    }
    return size;
}

}  // namespace

Shape Dataset::shape() const {
    const LibraryLock lock;
    return shape_of(handle_.id());
}

std::size_t Dataset::size() const { return product(shape()); }

bool Dataset::holds_integers() const {
    const LibraryLock lock;
    const Handle type(H5Dget_type(handle_.id()), H5Tclose);
    return H5Tget_class(type.id()) == H5T_INTEGER;
}

template <class Number>
void Dataset::append(const std::vector<Number>& values) const {
    const LibraryLock lock;
    Shape shape = this->shape();
    const std::size_t first = shape.at(0);
    const std::size_t per_row = product({shape.begin() + 1, shape.end()});
    if (values.size() % per_row != 0) throw std::invalid_argument(place_ + ": the values do not fill whole rows");
    const std::size_t count = values.size() / per_row;
    if (count == 0) return;
    shape[0] += count;
    const std::vector<hsize_t> extent(shape.begin(), shape.end());
    check(H5Dset_extent(handle_.id(), extent.data()), place_, cannot_write);
    const auto [in_file, in_memory] = select_rows(handle_.id(), first, count, place_);
    check(H5Dwrite(handle_.id(), number_type<Number>(), in_memory.id(), in_file.id(), H5P_DEFAULT, values.data()),
          place_, cannot_write);
}

template <class Number>
std::vector<Number> Dataset::read() const {
    const LibraryLock lock;
    std::vector<Number> values(believable_size(handle_.id(), shape(), place_));
    const Handle type(H5Dget_type(handle_.id()), H5Tclose);
    const auto wanted = std::is_same_v<Number, double> ? H5T_FLOAT : H5T_INTEGER;
    if (H5Tget_class(type.id()) != wanted) fail(place_, "the array holds another kind of values than expected");
    if (!values.empty()) {
        check(H5Dread(handle_.id(), number_type<Number>(), H5S_ALL, H5S_ALL, H5P_DEFAULT, values.data()), place_,
              cannot_read);
    }
    return values;
}

template <class Number>
std::vector<Number> Dataset::read_rows(std::size_t first, std::size_t count) const {
    const LibraryLock lock;
    Shape shape = this->shape();
    const auto [in_file, in_memory] = select_rows(handle_.id(), first, count, place_);
    shape.at(0) = count;
    std::vector<Number> values(believable_size(handle_.id(), shape, place_));
    check(H5Dread(handle_.id(), number_type<Number>(), in_memory.id(), in_file.id(), H5P_DEFAULT, values.data()),
          place_, cannot_read);
    return values;
}

Group Group::create_group(const std::string& name) const {
    const LibraryLock lock;
    const std::string place = place_ + ": /" + name;
    return {open(H5Gcreate2(handle_.id(), name.c_str(), H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT), H5Gclose, place,
                 cannot_write),
            place};
}

Group Group::group(const std::string& name) const {
    const LibraryLock lock;
    const std::string place = place_ + ": /" + name;
    if (!has(name)) fail(place, "the group is missing; the file was not written by this program or is damaged");
    return {open(H5Gopen2(handle_.id(), name.c_str(), H5P_DEFAULT), H5Gclose, place, cannot_read), place};
}

bool Group::has(const std::string& name) const {
    const LibraryLock lock;
    return H5Lexists(handle_.id(), name.c_str(), H5P_DEFAULT) > 0;
}

std::vector<std::string> Group::names() const {
    const LibraryLock lock;
    std::vector<std::string> names;
    const auto collect = [](hid_t, const char* name, const H5L_info_t*, void* list) -> herr_t {
        static_cast<std::vector<std::string>*>(list)->emplace_back(name);
        return 0;
    };
    check(H5Literate(handle_.id(), H5_INDEX_NAME, H5_ITER_INC, nullptr, collect, &names), place_, cannot_read);
    return names;
}

template <class Number>
void Group::write(const std::string& name, const std::vector<Number>& values, const Shape& shape,
                  bool compressed) const {
    const LibraryLock lock;
    const std::string place = place_ + ": /" + name;
    const Shape sizes = shape.empty() ? Shape{values.size()} : shape;
    if (product(sizes) != values.size()) throw std::invalid_argument(place + ": the shape does not fit the values");
    const Handle space = space_of(sizes, place);
    const Handle properties = dataset_properties(place);
    if (compressed && !values.empty()) {
        const std::vector<hsize_t> chunk(sizes.begin(), sizes.end());
        H5Pset_chunk(properties.id(), static_cast<int>(chunk.size()), chunk.data());
        H5Pset_shuffle(properties.id());
        H5Pset_deflate(properties.id(), 4);
    }
    const Handle dataset = open(H5Dcreate2(handle_.id(), name.c_str(), number_type<Number>(), space.id(), H5P_DEFAULT,
                                           properties.id(), H5P_DEFAULT),
                                H5Dclose, place, cannot_write);
    if (values.empty()) return;
    check(H5Dwrite(dataset.id(), number_type<Number>(), H5S_ALL, H5S_ALL, H5P_DEFAULT, values.data()), place,
          cannot_write);
}

template <class Number>
Dataset Group::create_extendible(const std::string& name, const Shape& row, std::size_t rows_per_chunk) const {
    const LibraryLock lock;
    const std::string place = place_ + ": /" + name;
    std::vector<hsize_t> start{0}, limit{H5S_UNLIMITED};
    start.insert(start.end(), row.begin(), row.end());
    limit.insert(limit.end(), row.begin(), row.end());
    std::vector<hsize_t> chunk = start;
    chunk[0] = rows_per_chunk;
    const Handle space = open(H5Screate_simple(static_cast<int>(start.size()), start.data(), limit.data()), H5Sclose,
                              place, cannot_write);
    const Handle properties = dataset_properties(place);
    H5Pset_chunk(properties.id(), static_cast<int>(chunk.size()), chunk.data());
    // The unused end of a chunk takes no room when it is deflated.
    H5Pset_shuffle(properties.id());
    H5Pset_deflate(properties.id(), 1);
    return {open(H5Dcreate2(handle_.id(), name.c_str(), number_type<Number>(), space.id(), H5P_DEFAULT, properties.id(),
                            H5P_DEFAULT),
                 H5Dclose, place, cannot_write),
            place};
}

Dataset Group::dataset(const std::string& name) const {
    const LibraryLock lock;
    const std::string place = place_ + ": /" + name;
    if (!has(name)) fail(place, "the array is missing; the file was not written by this program or is damaged");
    return {open(H5Dopen2(handle_.id(), name.c_str(), H5P_DEFAULT), H5Dclose, place, cannot_read), place};
}

File File::create(const std::filesystem::path& path, std::size_t user_block) {
    const LibraryLock lock;
    H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr);
    const Handle properties = hdf5::open(H5Pcreate(H5P_FILE_CREATE), H5Pclose, path.string(), cannot_write);
    check(H5Pset_userblock(properties.id(), user_block), path.string(), "the user block has no possible size");
    return {hdf5::open(H5Fcreate(path.c_str(), H5F_ACC_TRUNC, properties.id(), H5P_DEFAULT), H5Fclose, path.string(),
                       "the file cannot be created; check the folder and its permissions"),
            path.string()};
}

File File::open(const std::filesystem::path& path) {
    const LibraryLock lock;
    H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr);
    std::error_code ignored;
    if (!std::filesystem::exists(path, ignored)) fail(path.string(), "there is no such file; check its name");
    return {hdf5::open(H5Fopen(path.c_str(), H5F_ACC_RDONLY, H5P_DEFAULT), H5Fclose, path.string(),
                       "this is not a whole HDF5 file; it may be of another kind, cut off or damaged"),
            path.string()};
}

void File::flush() const {
    const LibraryLock lock;
    check(H5Fflush(handle_.id(), H5F_SCOPE_LOCAL), place_, cannot_write);
}

void File::close() {
    const LibraryLock lock;
    flush();
    check(handle_.close(), place_, cannot_write);
}

bool is_hdf5(const std::filesystem::path& path) {
    const LibraryLock lock;
    H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr);
    return H5Fis_hdf5(path.c_str()) > 0;
}

#define RECOAT_INSTANTIATE(Number)                                                                        \
    template void Dataset::append(const std::vector<Number>&) const;                                      \
    template std::vector<Number> Dataset::read() const;                                                   \
    template std::vector<Number> Dataset::read_rows(std::size_t, std::size_t) const;                      \
    template void Group::write(const std::string&, const std::vector<Number>&, const Shape&, bool) const; \
    template Dataset Group::create_extendible<Number>(const std::string&, const Shape&, std::size_t) const;
RECOAT_INSTANTIATE(double)
RECOAT_INSTANTIATE(std::int64_t)
RECOAT_INSTANTIATE(std::int32_t)
#undef RECOAT_INSTANTIATE

}  // namespace recoat::hdf5
