#include "solver/execution/instruction_set.hpp"

#include <algorithm>
#include <cstdlib>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "common/error.hpp"

namespace recoat {

std::string name_of(InstructionSet set) {
    switch (set) {
        case InstructionSet::avx512:
            return "avx512";
        case InstructionSet::avx2:
            return "avx2";
        case InstructionSet::baseline:
            break;
    }
    return "baseline";
}

std::vector<InstructionSet> usable_instruction_sets() {
    std::vector<InstructionSet> sets = {InstructionSet::baseline};
#if defined(__x86_64__)
    if (__builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma")) sets.push_back(InstructionSet::avx2);
    if (sets.size() == 2 && __builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512dq") &&
        __builtin_cpu_supports("avx512bw") && __builtin_cpu_supports("avx512vl"))
        sets.push_back(InstructionSet::avx512);
#endif
    return sets;
}

InstructionSet chosen_instruction_set() {
    const std::vector<InstructionSet> usable = usable_instruction_sets();
    const char* wanted = std::getenv("RECOAT_INSTRUCTION_SET");
    if (wanted == nullptr || *wanted == '\0') return usable.back();
    std::vector<std::string> names;
    for (const InstructionSet set : usable) {
        names.push_back(name_of(set));
        if (names.back() == wanted) return set;
    }
    throw InputError(
        fmt::format("RECOAT_INSTRUCTION_SET is '{}'; this machine has {}", wanted, fmt::join(names, ", ")));
}

}  // namespace recoat
