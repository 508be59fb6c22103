#include "common/error.hpp"

#include <cstdio>

namespace recoat {
Ending ending_of(const std::function<int()>& body) noexcept {
    try {
        return {body(), {}};
    } catch (const InputError& error) {
        return {2, error.what()};
    } catch (const SimulationFault& error) {
        return {3, error.what()};
    } catch (const std::exception& error) {
        return {1, error.what()};
    } catch (...) {
        return {1, "unknown exception"};
    }
}

int run_program(std::string_view program, const std::function<int()>& body) noexcept {
    const Ending ending = ending_of(body);
    if (ending.sentence.empty()) return ending.code;
    const char* kind = ending.code == 1 ? "internal error (a bug: please report it with the input)" : "error";
    std::fprintf(stderr, "%.*s: %s: %s\n", static_cast<int>(program.size()), program.data(), kind,
                 ending.sentence.c_str());
    return ending.code;
}

void warn(std::string_view program, std::string_view sentence) noexcept {
    std::fprintf(stderr, "%.*s: warning: %.*s\n", static_cast<int>(program.size()), program.data(),
                 static_cast<int>(sentence.size()), sentence.data());
}

}  // namespace recoat
