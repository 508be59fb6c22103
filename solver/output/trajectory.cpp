#include "solver/output/trajectory.hpp"

#include <string>

namespace recoat {

Trajectory::Trajectory(const std::filesystem::path& folder)
    : file_(folder / "trajectory.vtkhdf"), frames_(folder / "trajectory.frames") {}

std::filesystem::path Trajectory::frame(std::int64_t index) const {
    std::string number = std::to_string(index);
    number.insert(0, number.size() < 6 ? 6 - number.size() : 0, '0');
    return frames_ / (number + ".vtkhdf");
}

void Trajectory::add(std::int64_t index, const StateInfo& info, const State& state) const {
    std::filesystem::create_directories(frames_);
    write_state(frame(index), info, state);
}

void Trajectory::assemble(std::int64_t count, const StateInfo& info) const {
    if (!std::filesystem::exists(frames_)) return;
    StateWriter writer(file_, info);
    for (std::int64_t index = 0; index < count; ++index) writer.append(read_state(frame(index)));
    writer.close();
    std::filesystem::remove_all(frames_);
}

}  // namespace recoat
