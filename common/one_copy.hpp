#pragma once

/// Marks a function that must be compiled once and called: were it compiled anew into each of its callers, fused
/// multiply-adds could be placed differently in each, and equal input give results that differ in the last digit.
#ifdef __clang__
#define RECOAT_ONE_COPY __attribute__((noinline))
#else
#define RECOAT_ONE_COPY __attribute__((noipa))
#endif
