#include "solver/output/checkpoint.hpp"

#include <algorithm>
#include <exception>

#include "common/error.hpp"
#include "common/hdf5.hpp"
#include "common/output_file.hpp"
#include "solver/output/file_seal.hpp"

namespace recoat {
namespace {

namespace fs = std::filesystem;

constexpr std::int64_t schema_version = 3;

fs::path last_file(const fs::path& folder) { return folder / "checkpoint.h5"; }
fs::path previous_file(const fs::path& folder) { return folder / "checkpoint-previous.h5"; }

// A slash would mean a folder in HDF5, so the file has a colon instead.
std::string swapped(std::string name, char from, char to) {
    std::ranges::replace(name, from, to);
    return name;
}

std::vector<std::int64_t> as_integers(const std::vector<std::uint64_t>& values) {
    return {values.begin(), values.end()};
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
    checkpoint.progress.blade_stop.x = root.read<double>("blade_stop_x");
    checkpoint.progress.walls.set_values(root.read<double>("walls"));
    const auto frames = root.read<std::int64_t>("frames");
    checkpoint.progress.frames.assign(frames.begin(), frames.end());
    checkpoint.engine.reals = read_arrays<double>(root.group("reals"));
    checkpoint.engine.integers = read_arrays<std::int64_t>(root.group("integers"));
    return checkpoint;
}

}  // namespace

void write_checkpoint(const fs::path& folder, const Checkpoint& checkpoint) {
    OutputFile output(last_file(folder));
    {
        hdf5::File hdf5 = hdf5::File::create(output.path(), seal_size);
        {
            const hdf5::Group root = hdf5.create_group("recoat_checkpoint");
            root.set_attribute("schema_version", schema_version);
            root.set_attribute("version", checkpoint.version);
            root.set_attribute("config", checkpoint.config);
            root.set_attribute("progress", progress_to_text(checkpoint.progress));
            root.write("energy", checkpoint.progress.energy.values());
            root.write("blade_stop_x", checkpoint.progress.blade_stop.x);
            root.write("walls", checkpoint.progress.walls.values());
            root.write("frames", as_integers(checkpoint.progress.frames));
            write_arrays(root.create_group("reals"), checkpoint.engine.reals);
            write_arrays(root.create_group("integers"), checkpoint.engine.integers);
        }
        hdf5.close();
    }
    seal(output.path());
    // A damaged one must not take the place of a whole one.
    if (is_intact(last_file(folder))) fs::rename(last_file(folder), previous_file(folder));
    output.commit();
}

Checkpoint read_checkpoint(const fs::path& file) {
    if (!fs::exists(file)) {
        throw InputError(file.string() + ": there is no checkpoint; start the run with recoat-solve run");
    }
    // First: HDF5 is not made for files that are damaged.
    if (!is_intact(file)) {
        throw InputError(file.string() +
                         ": the checkpoint is damaged or of another program (its bytes do not have the checksum that "
                         "they were written with); start the run anew with recoat-solve run --overwrite");
    }
    const hdf5::File hdf5 = hdf5::File::open(file);
    try {
        return read_checked(hdf5, file.string());
    } catch (const InputError&) {
        throw;
    } catch (const std::exception& error) {
        throw InputError(file.string() + ": the checkpoint cannot be understood (" + error.what() +
                         "); start the run anew with recoat-solve run --overwrite");
    }
}

LatestCheckpoint read_latest_checkpoint(const fs::path& folder) {
    const fs::path last = last_file(folder), previous = previous_file(folder);
    if (fs::exists(last) && (is_intact(last) || !fs::exists(previous))) return {read_checkpoint(last), {}};
    if (!fs::exists(previous)) return {read_checkpoint(last), {}};
    const std::string reason = fs::exists(last) ? "is damaged" : "is missing";
    if (!is_intact(previous)) {
        throw InputError(last.string() + ": the checkpoint " + reason +
                         ", and the earlier one is damaged too; start the run anew with recoat-solve run --overwrite");
    }
    return {read_checkpoint(previous),
            last.string() + " " + reason + "; the run continues from the earlier checkpoint."};
}

bool has_checkpoint(const fs::path& folder) {
    return fs::exists(last_file(folder)) || fs::exists(previous_file(folder));
}

void remove_checkpoints(const fs::path& folder) {
    fs::remove(last_file(folder));
    fs::remove(previous_file(folder));
}

}  // namespace recoat
