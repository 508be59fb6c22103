#include "common/error.hpp"

#include <cstdio>

namespace recoat {
namespace {

void report(std::string_view program, const char* kind, const char* sentence) noexcept {
    std::fprintf(stderr, "%.*s: %s: %s\n", static_cast<int>(program.size()), program.data(), kind, sentence);
}

}  // namespace

int run_program(std::string_view program, const std::function<int()>& body) noexcept {
    try {
        return body();
    } catch (const InputError& error) {
        report(program, "error", error.what());
        return 2;
    } catch (const SimulationFault& error) {
        report(program, "error", error.what());
        return 3;
    } catch (const std::exception& error) {
        report(program, "internal error (a bug: please report it with the input)", error.what());
    } catch (...) {
        report(program, "internal error (a bug: please report it with the input)", "unknown exception");
    }
    return 1;
}

}  // namespace recoat
