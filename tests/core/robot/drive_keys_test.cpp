#include "core/robot/control/drive_keys.h"

#include <gtest/gtest.h>

namespace leitstand::test {
namespace {

constexpr DriveLimits Limits{.speed = 0.5, .turnRate = 1.0};

TEST(DriveKeys, HeldKeysMakeTheSticks) {
    DriveKeys keys;
    EXPECT_TRUE(isZero(keys.sticks(Limits)));
    keys.set(DriveKey::Forward, true);
    keys.set(DriveKey::Left, true);
    EXPECT_TRUE(keys.any());
    EXPECT_DOUBLE_EQ(keys.sticks(Limits).forward, 0.3);
    EXPECT_DOUBLE_EQ(keys.sticks(Limits).turn, 0.6) << "left is counter-clockwise";
    keys.set(DriveKey::Left, false);
    keys.set(DriveKey::Right, true);
    EXPECT_DOUBLE_EQ(keys.sticks(Limits).turn, -0.6);
}

TEST(DriveKeys, KeysAgainstEachOtherMakeNothing) {
    DriveKeys keys;
    keys.set(DriveKey::Forward, true);
    keys.set(DriveKey::Back, true);
    EXPECT_TRUE(isZero(keys.sticks(Limits)));
    keys.set(DriveKey::Forward, false);
    EXPECT_LT(keys.sticks(Limits).forward, 0.0);
}

TEST(DriveKeys, SlowGoesBeforeFast) {
    DriveKeys keys;
    keys.set(DriveKey::Forward, true);
    keys.set(DriveKey::Fast, true);
    EXPECT_DOUBLE_EQ(keys.sticks(Limits).forward, 0.5);
    keys.set(DriveKey::Slow, true);
    EXPECT_DOUBLE_EQ(keys.sticks(Limits).forward, 0.125);
}

TEST(DriveKeys, AfterFocusIsLostNothingIsHeld) {
    DriveKeys keys;
    keys.set(DriveKey::Forward, true);
    keys.releaseAll();
    EXPECT_FALSE(keys.any());
    EXPECT_TRUE(isZero(keys.sticks(Limits)));
}

}  // namespace
}  // namespace leitstand::test
