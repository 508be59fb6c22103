// What the runtimes of clang's sanitizers ask for at the start of a program. The environment (ASAN_OPTIONS, ...) goes
// before it.

extern "C" {

// NOLINTBEGIN(bugprone-reserved-identifier,cert-dcl37-c,cert-dcl51-cpp): the runtimes ask for these names.

const char* __asan_default_options() {
    return "detect_leaks=1:detect_stack_use_after_return=1:check_initialization_order=1:strict_init_order=1:"
           "strict_string_checks=1";
}

const char* __ubsan_default_options() { return "print_stacktrace=1"; }

/// Archer, which tells the sanitizer what the barriers of OpenMP order, asks for the last of them.
const char* __tsan_default_options() {
    return "halt_on_error=1:second_deadlock_stack=1:history_size=4:ignore_noninstrumented_modules=1";
}

/// Races in which one side is a library's own line. In OpenVDB's rasterisation every thread writes how many particles
/// it left out into the same two numbers; with the bounds of radii that we set these are 0, and nobody reads them.
/// oneTBB keeps its books of a loop on the stack of the caller; the ends of loops in OpenVDB's compiled part, which is
/// the distribution's, are not seen, so that whoever uses that stack next seems to race with it. What loops do to our
/// data has our lines on both sides.
const char* __tsan_default_suppressions() {
    return "race_top:openvdb/tools/ParticlesToLevelSet.h\n"
           "race_top:/src/tbb/\n";
}
// NOLINTEND(bugprone-reserved-identifier,cert-dcl37-c,cert-dcl51-cpp)
}
