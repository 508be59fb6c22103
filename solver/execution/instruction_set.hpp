#pragma once

#include <string>
#include <vector>

namespace recoat {

/// What a processor offers to the vector loops; one program has a version of them for each and takes the best that the
/// machine has.
enum class InstructionSet { baseline, avx2, avx512 };

/// Tags of the same for templates.
struct Baseline {};
struct Avx2 {};
struct Avx512 {};

/// As it stands in results and in the environment: baseline, avx2, avx512.
std::string name_of(InstructionSet set);

/// Those that this machine runs, from the least to the best.
std::vector<InstructionSet> usable_instruction_sets();

/// The best of them, or the one that the environment variable RECOAT_INSTRUCTION_SET names. Throws InputError when the
/// machine does not run that.
InstructionSet chosen_instruction_set();

}  // namespace recoat
