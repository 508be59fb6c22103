#include "solver/output/trajectory.hpp"

#include "common/error.hpp"
#include "common/fingerprint.hpp"
#include "solver/output/folder_lock.hpp"

namespace recoat {

Trajectory::Trajectory(const std::filesystem::path& folder)
    : file_(folder / "trajectory.vtkhdf"), frames_(folder / "trajectory.frames") {}

std::filesystem::path Trajectory::frame(std::size_t index) const {
    std::string number = std::to_string(index);
    number.insert(0, number.size() < 6 ? 6 - number.size() : 0, '0');
    return frames_ / (number + ".vtkhdf");
}

std::uint64_t Trajectory::add(std::size_t index, const StateInfo& info, const State& state) const {
    std::filesystem::create_directories(frames_);
    write_state(frame(index), info, state);
    return fingerprint_of(frame(index));
}

std::vector<std::string> Trajectory::missing(std::size_t count) const {
    std::vector<std::string> names;
    if (std::filesystem::exists(file_)) return names;
    for (std::size_t index = 0; index < count; ++index) {
        if (!std::filesystem::exists(frame(index)))
            names.push_back((frames_.filename() / frame(index).filename()).string());
    }
    return names;
}

State Trajectory::read(std::size_t index, std::uint64_t fingerprint) const {
    const std::filesystem::path file = frame(index);
    if (!std::filesystem::exists(file) && std::filesystem::exists(file_))
        return read_state(file_, static_cast<int>(index));
    if (fingerprint_of(file) != fingerprint) {
        throw InputError(
            file.string() +
            ": this state of the trajectory is not as it was written; delete the folder and start the run anew");
    }
    return read_state(file);
}

void Trajectory::assemble(const std::vector<std::uint64_t>& fingerprints, const StateInfo& info) const {
    if (!std::filesystem::exists(frames_)) return;
    remove_unfinished_files(frames_);
    StateWriter writer(file_, info);
    for (std::size_t index = 0; index < fingerprints.size(); ++index) writer.append(read(index, fingerprints[index]));
    writer.close();
    std::filesystem::remove_all(frames_);
}

}  // namespace recoat
