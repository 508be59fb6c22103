#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <string>
#include <type_traits>
#include <vector>

/// A thin layer over the HDF5 C library: objects close themselves, errors are InputError naming the file and the
/// object. Numbers are double, std::int64_t or std::int32_t (the element types for which the templates are
/// instantiated). Different threads may use different files at the same time: calls to the library take turns.
namespace recoat::hdf5 {

/// An open HDF5 object (file, group, dataset, ...) that closes itself.
class Handle {
public:
    using Close = int (*)(std::int64_t);

    Handle() = default;
    Handle(std::int64_t id, Close closer) : id_(id), close_(closer) {}
    Handle(Handle&& other) noexcept;
    Handle& operator=(Handle&& other) noexcept;
    ~Handle();

    [[nodiscard]] std::int64_t id() const { return id_; }
    /// Closes it now and returns the status of HDF5: negative when that failed.
    int close();

private:
    std::int64_t id_ = -1;
    Close close_ = nullptr;
};

/// Sizes of an array along its axes.
using Shape = std::vector<std::size_t>;

class Group;

/// An array in a file.
class Dataset {
public:
    [[nodiscard]] Shape shape() const;
    [[nodiscard]] std::size_t size() const;  ///< number of elements
    [[nodiscard]] bool holds_integers() const;

    /// Adds rows (along the first axis) to a dataset made by Group::create_extendible.
    template <class Number>
    void append(const std::vector<Number>& values) const;

    /// All elements, the last axis running fastest.
    template <class Number>
    [[nodiscard]] std::vector<Number> read() const;

    /// Elements of the rows first ... first + count - 1.
    template <class Number>
    [[nodiscard]] std::vector<Number> read_rows(std::size_t first, std::size_t count) const;

private:
    friend class Group;
    Dataset(Handle handle, std::string place) : handle_(std::move(handle)), place_(std::move(place)) {}

    Handle handle_;
    std::string place_;
};

/// A folder in a file; also the file itself.
class Group {
public:
    Group create_group(const std::string& name) const;
    [[nodiscard]] Group group(const std::string& name) const;
    [[nodiscard]] bool has(const std::string& name) const;
    [[nodiscard]] std::vector<std::string> names() const;  ///< of groups and datasets, in alphabetical order

    /// Writes an array at once; an empty `shape` means one axis. `compressed` arrays are shuffled and deflated.
    template <class Number>
    void write(const std::string& name, const std::vector<Number>& values, const Shape& shape = {},
               bool compressed = false) const;

    /// An array with no rows yet, each of shape `row` (empty: one number), to be appended to; stored in chunks of
    /// `rows_per_chunk` rows.
    template <class Number>
    [[nodiscard]] Dataset create_extendible(const std::string& name, const Shape& row,
                                            std::size_t rows_per_chunk) const;

    [[nodiscard]] Dataset dataset(const std::string& name) const;

    /// All elements of an array.
    template <class Number>
    [[nodiscard]] std::vector<Number> read(const std::string& name) const {
        return dataset(name).read<Number>();
    }

    /// Attributes of this group. Texts are stored with a fixed length; ASCII where they are ASCII.
    void set_attribute(const std::string& name, double value) const;
    void set_attribute(const std::string& name, std::int64_t value) const;
    void set_attribute(const std::string& name, const std::vector<std::int64_t>& values) const;
    void set_attribute(const std::string& name, const std::string& text) const;
    /// Attribute of the array `dataset_name` of this group, e.g. its unit.
    void set_dataset_attribute(const std::string& dataset_name, const std::string& name, const std::string& text) const;

    [[nodiscard]] bool has_attribute(const std::string& name) const;
    [[nodiscard]] double real_attribute(const std::string& name) const;
    [[nodiscard]] std::int64_t integer_attribute(const std::string& name) const;
    [[nodiscard]] std::string text_attribute(const std::string& name) const;

protected:
    Group(Handle handle, std::string place) : handle_(std::move(handle)), place_(std::move(place)) {}

    Handle handle_;
    std::string place_;  ///< "file" or "file: /group", for messages
};

/// An open file.
class File : public Group {
public:
    /// `user_block`: bytes at the start that HDF5 leaves to the caller; 0, or a power of 2 from 512.
    static File create(const std::filesystem::path& path, std::size_t user_block = 0);
    static File open(const std::filesystem::path& path);  ///< for reading

    void flush() const;
    /// Closes the file and says, unlike the destructor, when something of it could not be written.
    void close();

private:
    using Group::Group;
};

/// Whether the file exists and begins like an HDF5 file.
bool is_hdf5(const std::filesystem::path& path);

}  // namespace recoat::hdf5
