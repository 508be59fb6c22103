# `cmake --install BUILD --prefix FOLDER`: the programs with the libraries that they need beside them, but for the C library,
# which must be that of the machine: they run wherever it is no older than here.

foreach(program solver/recoat-solve analyzer/recoat-analyze)
    get_filename_component(target ${program} NAME)
    get_filename_component(folder ${program} DIRECTORY)
    # RPATH and not RUNPATH: it also holds for what the libraries themselves need.
    set_target_properties(${target} PROPERTIES INSTALL_RPATH "$ORIGIN/../lib")
    target_link_options(${target} PRIVATE -Wl,--disable-new-dtags)
    install(TARGETS ${target} RUNTIME_DEPENDENCY_SET recoat_libraries DESTINATION ${folder})
endforeach()
install(RUNTIME_DEPENDENCY_SET recoat_libraries DESTINATION lib
        PRE_EXCLUDE_REGEXES "^ld-linux" "^lib(c|m|dl|rt|pthread|resolv|util)[.]so")
