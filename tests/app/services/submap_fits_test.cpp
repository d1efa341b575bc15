#include "app/services/mapping/submap_fits.h"

#include <optional>
#include <set>

#include <gtest/gtest.h>

#include "tests/core/mapping/live/mapped_room.h"
#include "tests/support/wait.h"

namespace leitstand::test {
namespace {

using namespace std::chrono_literals;

/// A map of eight scans, of which the last four are moved.
struct MovedRun {
    MovedRun() {
        room.drive(8);
        map = room.mapper.map();
        run = submapOf(*map, 5, SubmapKind::FromHere);
    }
    MappedRoom room;
    LiveMapPtr map;
    std::set<std::uint64_t> run;
};

Pose aside(double metres) {
    return poseFrom({0, metres, 0}, 0, 0, 0);
}

TEST(SubmapFits, TellsHowItFitsWhereItWasWantedLast) {
    const MovedRun moved;
    SubmapFits fits;
    EXPECT_FALSE(fits.submap());
    fits.begin(moved.map, moved.run);
    for (int i = 1; i <= 50; ++i) fits.want(aside(0.02 * i));  // as it is dragged
    ASSERT_TRUE(waitUntil([&] { return fits.submap() && fits.fit(); }));
    const SubmapFit last = fits.submap()->at(aside(1.0));
    EXPECT_TRUE(waitUntil([&] {
        const auto fit = fits.fit();
        return fit && fit->overlap == last.overlap && fit->seam == last.seam;
    }));
    fits.want(aside(0.0));
    EXPECT_TRUE(waitUntil([&] { return fits.fit()->seam < last.seam; }));
}

TEST(SubmapFits, SnapsFromWhereItIsAndTellsOnce) {
    const MovedRun moved;
    SubmapFits fits;
    fits.begin(moved.map, moved.run);
    ASSERT_TRUE(waitUntil([&] { return fits.submap() != nullptr; }));
    fits.snap(aside(0.3));
    std::optional<SubmapFits::Snapped> snapped;
    ASSERT_TRUE(waitUntil([&] { return (snapped = fits.takeSnapped()).has_value(); }, 30s));
    ASSERT_TRUE(snapped->moved);
    EXPECT_LT(distanceBetween(*snapped->moved, Pose::Identity()), 0.05) << "it lay right";
    EXPECT_FALSE(fits.takeSnapped());
    fits.snap(aside(80.0));
    ASSERT_TRUE(waitUntil([&] { return (snapped = fits.takeSnapped()).has_value(); }, 30s));
    EXPECT_FALSE(snapped->moved) << "nothing is there";
}

TEST(SubmapFits, WhatWasBegunBeforeTellsNothingMore) {
    const MovedRun moved;
    SubmapFits fits;
    fits.begin(moved.map, moved.run);
    fits.want(aside(0.1));
    fits.snap(aside(0.3));
    const std::set<std::uint64_t> other = submapOf(*moved.map, 7, SubmapKind::FromHere);
    fits.begin(moved.map, other);
    ASSERT_TRUE(waitUntil([&] { return fits.submap() != nullptr; }));
    EXPECT_EQ(fits.submap()->submap(), other);
    fits.want(aside(0.1));
    ASSERT_TRUE(waitUntil([&] { return fits.fit().has_value(); }));
    EXPECT_FALSE(fits.takeSnapped());
    fits.end();
    EXPECT_FALSE(fits.submap());
    EXPECT_FALSE(fits.fit());
}

}  // namespace
}  // namespace leitstand::test
