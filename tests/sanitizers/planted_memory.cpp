#include <climits>
#include <cstdlib>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "tests/sanitizers/expect_finding.hpp"

// Errors made on purpose: a clean run of all other tests says something only if these are seen.
// Values pass through `opaque`, so that the compiler can neither foresee the error nor leave it out.

namespace {

using recoat::testing::expect_finding;

template <class T>
T opaque(T value) {
    asm volatile("" : "+r"(value) : : "memory");
    return value;
}

int after_the_end() {
    std::vector<int> values(8);
    return opaque(values.data())[opaque(8)];
}

int after_free() {
    auto* values = new std::vector<int>(8);
    const int* const place = opaque(values->data());
    delete values;
    return *opaque(place);
}

// No `opaque` here: a function with assembly in it keeps its locals where nothing notices their end.
int* volatile place_of_local = nullptr;

[[gnu::noinline]] void leave_a_local() {
    int local[8] = {};
    place_of_local = &local[3];
}

int after_return() {
    leave_a_local();
    return *place_of_local;
}

void leak() {
    for (int k = 0; k < 100; ++k) opaque(std::malloc(100));
}

TEST(Planted, ReadBehindTheEnd) { expect_finding(after_the_end, "heap-buffer-overflow"); }
TEST(Planted, UseAfterFree) { expect_finding(after_free, "heap-use-after-free"); }
TEST(Planted, UseAfterReturn) {
    expect_finding([] { return opaque(after_return()); }, "stack-use-after-return");
}
TEST(Planted, Leak) { expect_finding(leak, "detected memory leaks"); }

TEST(Planted, SignedOverflow) {
    expect_finding([] { return opaque(opaque(INT_MAX) + 1); }, "signed integer overflow");
}
TEST(Planted, ShiftTooFar) {
    expect_finding([] { return opaque(1 << opaque(40)); }, "shift exponent");
}
TEST(Planted, NumberTooLargeForAnInteger) {
    expect_finding([] { return opaque(static_cast<int>(opaque(1e30))); }, "outside the range of representable values");
}
TEST(Planted, NullReference) {
    expect_finding([] { return opaque(opaque<std::string*>(nullptr)->size()); }, "null pointer");
}

}  // namespace
