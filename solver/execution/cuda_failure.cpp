#include "solver/execution/cuda_failure.hpp"

#include <algorithm>
#include <array>
#include <stdexcept>

#include <fmt/format.h>

#include "common/error.hpp"

namespace recoat {
namespace {

// Numbers of cudaError_t, which CUDA keeps from version to version. As numbers they need no toolkit: this file is
// compiled and tested everywhere.
constexpr int memory_allocation = 2;
/// No image for the device, or only PTX that its driver cannot translate.
constexpr std::array no_code = {200, 209, 218, 221, 222, 223};
/// Devices unavailable (exclusive or prohibited compute mode), already acquired, and what MPS refuses.
constexpr std::array occupied = {46, 210, 805, 806, 807, 808, 809};
/// Uncorrectable ECC, NVLink, contained and hardware stack errors, a display's time limit, an MPS client that was
/// ended, an external device that is gone.
constexpr std::array broken = {214, 220, 226, 702, 714, 810, 911};
/// Drivers and systems that are not fit: initialisation, stub library, driver too old, no device, invalid device, not
/// licensed, operating system, not permitted, system not ready, driver mismatch, no forward compatibility, unknown.
constexpr std::array unfit = {3, 34, 35, 36, 100, 101, 102, 304, 800, 802, 803, 804, 999};

template <std::size_t n>
bool is_one_of(const std::array<int, n>& errors, int error) {
    return std::find(errors.begin(), errors.end(), error) != errors.end();
}

std::string version(int number) { return fmt::format("{}.{}", number / 1000, number % 1000 / 10); }

}  // namespace

CudaFailure cuda_failure(int error, const std::string& text, const std::string& doing, int device,
                         const std::string& versions) {
    using Kind = CudaFailure::Kind;
    const std::string which = device < 0 ? "the CUDA device" : fmt::format("CUDA device {}", device);
    if (error == memory_allocation)
        return {Kind::unusable, fmt::format("{} has too little free memory ({})", which, doing),
                "use fewer particles, another device, or --backend cpu"};
    if (is_one_of(no_code, error))
        return {Kind::unusable, fmt::format("this program has no code for {}: \"{}\" ({})", which, text, versions),
                "build it with the device's architecture in RECOAT_CUDA_ARCHITECTURES, or use --backend cpu"};
    if (is_one_of(occupied, error))
        return {Kind::unusable,
                fmt::format("{} is taken by another program, or closed by its compute mode: \"{}\" ({})", which, text,
                            doing),
                "wait for it (nvidia-smi shows who has it), use another device, or --backend cpu"};
    if (is_one_of(broken, error))
        return {Kind::broken, fmt::format("{} has failed ({}): \"{}\"", which, doing, text),
                "what was made since the last checkpoint is lost; continue from there with recoat-solve resume, on "
                "another device, after a reset of this one, or with --backend cpu"};
    if (is_one_of(unfit, error))
        return {Kind::unusable, fmt::format("{} cannot be used ({}): \"{}\" ({})", which, doing, text, versions),
                "check the driver, use another device, or --backend cpu"};
    return {Kind::bug, fmt::format("{}, {}: \"{}\" ({})", which, doing, text, versions), ""};
}

std::string cuda_versions(int driver, int runtime) {
    const std::string made = "program made with CUDA " + version(runtime);
    return (driver > 0 ? "driver for CUDA " + version(driver) : std::string("no driver")) + ", " + made;
}

void throw_failure(const CudaFailure& failure) {
    const std::string sentence = failure.remedy.empty() ? failure.what : failure.what + "; " + failure.remedy;
    if (failure.kind == CudaFailure::Kind::unusable) throw InputError(sentence);
    if (failure.kind == CudaFailure::Kind::broken) throw SimulationFault(sentence);
    throw std::runtime_error(sentence);
}

}  // namespace recoat
