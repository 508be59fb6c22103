#include "solver/output/checkpoint.hpp"

#include <algorithm>
#include <exception>

#include "common/error.hpp"
#include "common/hdf5.hpp"
#include "common/output_file.hpp"

namespace recoat {
namespace {

constexpr std::int64_t schema_version = 1;

// A slash would mean a folder in HDF5, so the file has a colon instead.
std::string swapped(std::string name, char from, char to) {
    std::ranges::replace(name, from, to);
    return name;
}

template <class Number>
void write_arrays(const hdf5::Group& group, const std::map<std::string, std::vector<Number>>& arrays) {
    for (const auto& [name, values] : arrays) group.write(swapped(name, '/', ':'), values);
}

template <class Number>
std::map<std::string, std::vector<Number>> read_arrays(const hdf5::Group& group) {
    std::map<std::string, std::vector<Number>> arrays;
    for (const std::string& name : group.names()) arrays[swapped(name, ':', '/')] = group.read<Number>(name);
    return arrays;
}

Checkpoint read_checked(const hdf5::File& file, const std::string& name) {
    if (!file.has("recoat_checkpoint")) throw InputError(name + ": this is no checkpoint of recoat-solve");
    const hdf5::Group root = file.group("recoat_checkpoint");
    if (root.integer_attribute("schema_version") != schema_version) {
        throw InputError(name + ": the checkpoint was written by another version of recoat-solve (" +
                         root.text_attribute("version") + "); continue with that version, or start the run anew");
    }
    Checkpoint checkpoint;
    checkpoint.version = root.text_attribute("version");
    checkpoint.config = root.text_attribute("config");
    checkpoint.progress = progress_from_text(root.text_attribute("progress"));
    checkpoint.progress.energy.set_values(root.read<double>("energy"));
    checkpoint.engine.reals = read_arrays<double>(root.group("reals"));
    checkpoint.engine.integers = read_arrays<std::int64_t>(root.group("integers"));
    return checkpoint;
}

}  // namespace

void write_checkpoint(const std::filesystem::path& file, const Checkpoint& checkpoint) {
    OutputFile output(file);
    {
        const hdf5::File hdf5 = hdf5::File::create(output.path());
        const hdf5::Group root = hdf5.create_group("recoat_checkpoint");
        root.set_attribute("schema_version", schema_version);
        root.set_attribute("version", checkpoint.version);
        root.set_attribute("config", checkpoint.config);
        root.set_attribute("progress", progress_to_text(checkpoint.progress));
        root.write("energy", checkpoint.progress.energy.values());
        write_arrays(root.create_group("reals"), checkpoint.engine.reals);
        write_arrays(root.create_group("integers"), checkpoint.engine.integers);
    }
    output.commit();
}

Checkpoint read_checkpoint(const std::filesystem::path& file) {
    if (!std::filesystem::exists(file)) {
        throw InputError(file.string() + ": there is no checkpoint; start the run with recoat-solve run");
    }
    const hdf5::File hdf5 = hdf5::File::open(file);
    try {
        return read_checked(hdf5, file.string());
    } catch (const InputError&) {
        throw;
    } catch (const std::exception& error) {
        throw InputError(file.string() + ": the checkpoint is damaged (" + error.what() + "); start the run anew");
    }
}

}  // namespace recoat
