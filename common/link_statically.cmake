# Makes the libraries of the solver part of its program, so that it runs on machines that have none of them. What stays
# outside is the C library, because the CUDA driver can only be loaded through it.

function(find_archive variable)
    find_library(${variable} NAMES ${ARGN} REQUIRED)
endfunction()

find_archive(hdf5_archive libhdf5_serial.a libhdf5.a PATH_SUFFIXES hdf5/serial)
find_archive(sz_archive libsz.a)
find_archive(aec_archive libaec.a)
find_archive(zlib_archive libz.a)
find_archive(yaml_archive libyaml-cpp.a)
execute_process(COMMAND ${CMAKE_CXX_COMPILER} -print-file-name=libgomp.a
                OUTPUT_VARIABLE gomp_archive OUTPUT_STRIP_TRAILING_WHITESPACE)

add_library(recoat_hdf5_without_s3 STATIC common/hdf5_without_s3.c)
set_property(TARGET hdf5::hdf5 PROPERTY IMPORTED_LOCATION ${hdf5_archive})
set_property(TARGET hdf5::hdf5 PROPERTY INTERFACE_LINK_LIBRARIES
    recoat_hdf5_without_s3 ${sz_archive} ${aec_archive} ${zlib_archive} ${CMAKE_DL_LIBS} m)

get_target_property(yaml_configurations yaml-cpp IMPORTED_CONFIGURATIONS)
foreach(configuration ${yaml_configurations})
    set_property(TARGET yaml-cpp PROPERTY IMPORTED_LOCATION_${configuration} ${yaml_archive})
endforeach()
set_property(TARGET fmt::fmt PROPERTY INTERFACE_COMPILE_DEFINITIONS FMT_HEADER_ONLY=1)
set_property(TARGET OpenMP::OpenMP_CXX PROPERTY INTERFACE_LINK_LIBRARIES ${gomp_archive} Threads::Threads
                                                                         ${CMAKE_DL_LIBS})

# The shared library of fmt is not needed by anything and so is left out.
add_link_options(-static-libstdc++ -static-libgcc -Wl,--as-needed)
