# Compiles clang's sanitizers into everything of ours: RECOAT_SANITIZE=address or thread (docs/stability.md).
if(NOT CMAKE_CXX_COMPILER_ID MATCHES Clang)
    message(FATAL_ERROR "RECOAT_SANITIZE needs clang: use the preset asan or tsan, as `make sanitize` does")
endif()

if(RECOAT_SANITIZE STREQUAL "address")
    # Division by zero is left out: its infinity is meant (derived numbers of a scene without friction).
    set(sanitizers -fsanitize=address,undefined,float-cast-overflow)
    target_compile_options(recoat_options INTERFACE
        $<${cxx}:-fsanitize-ignorelist=${PROJECT_SOURCE_DIR}/tests/sanitizers/ignored.txt>)
elseif(RECOAT_SANITIZE STREQUAL "thread")
    set(sanitizers -fsanitize=thread)
    # Accesses of more than 16 bytes, and gathers, are passed over by this sanitizer: no vector loops, forced ones included.
    target_compile_options(recoat_options INTERFACE
        "$<${cxx}:-fno-slp-vectorize;SHELL:-mllvm -force-vector-width=1;SHELL:-mllvm -force-vector-interleave=1>")
    # OpenVDB's loops over oneTBB hand over work; those of its compiled part are not seen, so ours are compiled here.
    target_compile_options(recoat_options INTERFACE
        "$<${cxx}:SHELL:-include ${PROJECT_SOURCE_DIR}/tests/sanitizers/openvdb_in_headers.hpp>")
    if(NOT EXISTS ${TBB_DIR}/TBBConfig.cmake)
        message(FATAL_ERROR "RECOAT_SANITIZE=thread needs a oneTBB that tells the sanitizer which of its threads waits "
                            "for which; there is none in TBB_DIR (${TBB_DIR}): call tests/sanitizers/build_tbb.sh first")
    endif()
else()
    message(FATAL_ERROR "RECOAT_SANITIZE is ${RECOAT_SANITIZE}; it can be address, thread or OFF")
endif()

# With checks in it a loop need not become a vector loop.
target_compile_options(recoat_options INTERFACE
    "$<${cxx}:${sanitizers};-fno-sanitize-recover=all;-fno-omit-frame-pointer;-Wno-pass-failed>")
target_compile_definitions(recoat_options INTERFACE $<${cxx}:_GLIBCXX_ASSERTIONS>)
target_link_options(recoat_options INTERFACE ${sanitizers})

# In every program: how the sanitizers behave where the environment does not say it, also in programs started by others.
add_library(recoat_sanitizer_defaults OBJECT common/sanitizer_defaults.cpp)
target_link_libraries(recoat_options INTERFACE $<TARGET_OBJECTS:recoat_sanitizer_defaults>)
