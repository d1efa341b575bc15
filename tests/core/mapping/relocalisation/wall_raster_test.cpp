#include "core/mapping/walls/wall_raster.h"

#include <cmath>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace leitstand::test {
namespace {

using testing::IsEmpty;
using testing::SizeIs;
using Walls = std::vector<Eigen::Vector2f>;

void addLine(Walls& walls, const Eigen::Vector2f& from, const Eigen::Vector2f& to) {
    const int points = static_cast<int>((to - from).norm() / 0.05F);
    for (int i = 0; i <= points; ++i)
        walls.emplace_back(from + (to - from) * static_cast<float>(i) / static_cast<float>(points));
}

/// A corridor of 30 m along x, 2.4 m wide, with a square pillar each @p apart along both walls; 0: none.
Walls corridor(float apart) {
    Walls walls;
    for (const float side : {-1.2F, 1.2F}) {
        addLine(walls, {-15.0F, side}, {15.0F, side});
        const int most = apart > 0.0F ? static_cast<int>(14.0F / apart) : -1;
        for (int i = -most; i <= most; ++i) {
            const float x = apart * static_cast<float>(i), inner = 0.7F * side;
            addLine(walls, {x - 0.2F, inner}, {x + 0.2F, inner});
            addLine(walls, {x - 0.2F, side}, {x - 0.2F, inner});
            addLine(walls, {x + 0.2F, side}, {x + 0.2F, inner});
        }
    }
    return walls;
}

/// What of @p walls is seen 6 m around from @p x on the corridor's axis.
Walls viewFrom(const Walls& walls, float x) {
    Walls view;
    for (const Eigen::Vector2f& wall : walls) {
        const Eigen::Vector2f there = wall - Eigen::Vector2f(x, 0.0F);
        if (there.norm() < 6.0F) view.push_back(there);
    }
    return view;
}

std::vector<RasterPlace> besideIn(const Walls& walls, double x, double within) {
    const FlatPose here{{x, 0.0}, 0.0};
    return WallRaster(walls).beside(viewFrom(walls, static_cast<float>(x)), here, here.place, within, 0.9);
}

TEST(WallRaster, WhatIsAlikeAllAlongACorridorIsNoOtherPlace) {
    EXPECT_THAT(besideIn(corridor(0.0F), 0.0, 3.0), IsEmpty());
}

TEST(WallRaster, TheNextPillarsOfARowAreOtherPlaces) {
    for (const float apart : {1.6F, 1.85F}) {
        const auto found = besideIn(corridor(apart), 0.3, 2.4);
        ASSERT_THAT(found, SizeIs(2)) << apart;
        for (const RasterPlace& place : found) {
            EXPECT_NEAR(std::abs(place.pose.place.x() - 0.3), double{apart}, 0.11);
            EXPECT_NEAR(place.pose.place.y(), 0.0, 0.11);
        }
    }
}

TEST(WallRaster, WhatLiesFartherOffThanIsAskedForIsNone) {
    EXPECT_THAT(besideIn(corridor(1.6F), 0.3, 1.2), IsEmpty());
}

}  // namespace
}  // namespace leitstand::test
