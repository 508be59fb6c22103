#pragma once

// Read before everything else in a build with the thread sanitizer: the templates that OpenVDB's library carries
// compiled are compiled with our code instead, sanitizer included.
#if __has_include(<openvdb/version.h>)
#include <openvdb/version.h>
#undef OPENVDB_USE_EXPLICIT_INSTANTIATION
#endif
