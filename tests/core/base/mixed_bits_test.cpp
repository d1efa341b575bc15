#include "core/base/mixed_bits.h"

#include <gtest/gtest.h>

namespace leitstand {
namespace {

// What the authors' own splitmix64.c gives from 1234567 on: worlds of a seed are the same on every machine.
TEST(MixedBits, ARowOfThemIsSplitMix64) {
    EXPECT_EQ(mixedBits(1234567), 6457827717110365317U);
    EXPECT_EQ(mixedBits(1234567 + MixedBitsStep), 3203168211198807973U);
    EXPECT_EQ(mixedBits(1234567 + 2 * MixedBitsStep), 9817491932198370423U);
}

}  // namespace
}  // namespace leitstand
