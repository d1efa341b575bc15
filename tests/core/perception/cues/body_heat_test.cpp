#include "core/perception/heat/body_heat.h"

#include <cmath>
#include <random>

#include <gtest/gtest.h>

#include "core/base/pose.h"
#include "core/event/picture_samples.h"

namespace leitstand::test {
namespace {

CameraInfoSample camera() {
    CameraInfoSample info;
    info.width = 160;
    info.height = 120;
    const double focal = 80.0 / std::tan(degrees(20));
    info.intrinsics = {focal, 0, 79.5, 0, focal, 59.5, 0, 0, 1};
    return info;
}

/// Something of @p skin degrees, a disc, with or without lukewarm clothes beside it.
ThermalPicture picture(float skin, int radius, bool dressed) {
    ThermalPicture thermal{160, 120, std::vector<float>(160 * 120, 20.0F)};
    std::mt19937 random(3);
    std::normal_distribution<float> noise(0.0F, 0.1F);
    for (int y = 0; y < 120; ++y) {
        for (int x = 0; x < 160; ++x) {
            float& value = thermal.celsius[static_cast<std::size_t>(y * 160 + x)];
            if (dressed && x > 80 && x < 80 + 5 * radius && std::abs(y - 60) < radius)
                value = 20.0F + 0.4F * (skin - 20.0F);
            if (std::hypot(x - 80, y - 60) <= radius) value = skin;
            value += noise(random);
        }
    }
    return thermal;
}

BodyHeat judged(const ThermalPicture& thermal, double range) {
    const auto blobs = findHeat(thermal, camera());
    EXPECT_FALSE(blobs.empty());
    return blobs.empty() ? BodyHeat{} : judgeBody(thermal, blobs.front(), range);
}

TEST(BodyHeat, SkinBesideClothesIsAPersonAndABareDiscALamp) {
    const BodyHeat person = judged(picture(33.0F, 8, true), 2.0);
    const BodyHeat lamp = judged(picture(36.0F, 8, false), 2.0);
    EXPECT_GT(person.likelihood, 0.85);
    EXPECT_LT(lamp.likelihood, 0.4);
    EXPECT_NEAR(lamp.across, std::sqrt(3.14159) * 8 * 2.0 / 219.8, 0.02);
    EXPECT_LT(lamp.clothes, 0.003);
}

TEST(BodyHeat, WhatIsTooLargeOrTooSmallIsNone) {
    EXPECT_LT(judged(picture(38.0F, 40, false), 4.0).likelihood, 0.2);
    EXPECT_LT(judged(picture(36.0F, 3, true), 0.4).likelihood, 0.2);
}

TEST(BodyHeat, NothingOfNothing) {
    EXPECT_EQ(judgeBody({}, {}, 1.0).likelihood, 0.0);
    EXPECT_EQ(judgeBody(picture(33.0F, 8, true), {}, 1.0).likelihood, 0.0);
    HeatBlob outside;
    outside.left = outside.top = -50;
    outside.right = outside.bottom = 500;
    outside.pixels = 9;
    outside.size = 0.1;
    EXPECT_LE(judgeBody(picture(33.0F, 8, true), outside, 2.0).likelihood, 1.0);
    EXPECT_EQ(judgeBody(picture(33.0F, 8, true), outside, std::nan("")).likelihood, 0.0);
}

}  // namespace
}  // namespace leitstand::test
