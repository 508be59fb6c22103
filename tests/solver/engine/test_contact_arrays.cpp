#include <gtest/gtest.h>

#include "solver/engine/snapshot.hpp"

namespace recoat {
namespace {

TEST(ContactArrays, GiveTheMemoryOfScratchBack) {
    Contacts contacts;
    contacts.resize(1000);
    contacts.resize_scratch(true, true);
    contacts.drop_scratch();
    for (const auto* array : {&contacts.normal_x, &contacts.normal_y, &contacts.normal_z, &contacts.separation})
        EXPECT_EQ(array->capacity(), 0u);
    EXPECT_EQ(contacts.force.capacity(), 0u);
    EXPECT_EQ(contacts.rolling.capacity(), 0u);
    EXPECT_EQ(contacts.impulse.capacity(), 0u);
    EXPECT_EQ(contacts.size(), 1000u) << "what is not scratch stays";
}

}  // namespace
}  // namespace recoat
