#include "tests/simulation/mapping/robot_pair.h"

#include <algorithm>
#include <cstdio>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "robots/simulation/arena/building_generator.h"
#include "tests/simulation/mapping/measured_seed.h"
#include "tests/support/latency.h"

namespace leitstand::simulation::test {
namespace {

const Pose Wrong = poseFrom({0.32, 0.24, 0}, 0, 0, degrees(15));  ///< 0.4 m

std::string eventsOf(const RobotPair& pair) {
    std::string text;
    for (const RobotPlaceSample& place : pair.places)
        text +=
            std::to_string(static_cast<int>(place.cause)) + (place.certain ? " " : "? ") + place.how + "\n";
    return text;
}

TEST(RobotPair, TheCrawlerIsPlacedFromAWrongSlotAndKeptWhileItDrives) {
    RobotPair pair(2, Wrong);
    pair.pass(9.0, false, false);
    ASSERT_TRUE(pair.crawler().placed) << eventsOf(pair);
    EXPECT_TRUE(pair.crawler().certain);
    EXPECT_LE(pair.off(), 0.10) << eventsOf(pair);
    EXPECT_LE(inDegrees(pair.turned()), 3.0);
    double most = 0.0;
    for (int i = 0; i < 12; ++i) {
        pair.pass(1.0, true, true);
        most = std::max(most, pair.off());
    }
    EXPECT_GT(pair.way, 1.0);
    EXPECT_LE(most, 0.15) << eventsOf(pair);
}

/// Stands until it was placed, 20 s at most.
void untilSeen(RobotPair& pair) {
    pair.sightings = true;
    for (int i = 0; i < 20 && !pair.crawler().certain; ++i) pair.pass(1.0, false, false);
}

void printSighting(std::uint64_t seed, const RobotPair& pair) {
    std::printf("  yellow %u  %zu bodies, placed %2.0f cm and %.1f degrees from the truth, %.0f ms: %s\n",
                static_cast<unsigned>(seed), pair.seen.size(), 100.0 * pair.off(), inDegrees(pair.turned()),
                1e3 * pair.sightingSeconds, pair.places.empty() ? "" : pair.places.back().how.c_str());
}

TEST(RobotPair, TheCrawlerIsPlacedWhereKurt3DSeesItWhenTheSlotIsWrongByMetres) {
    RobotPair pair(2, poseFrom({3.0, 2.0, 0}, 0, 0, degrees(100)));
    untilSeen(pair);
    printSighting(2, pair);
    ASSERT_TRUE(pair.crawler().certain) << eventsOf(pair);
    ASSERT_FALSE(pair.places.empty());
    EXPECT_EQ(pair.places.back().cause, RobotPlaceSample::Cause::Seen) << eventsOf(pair);
    EXPECT_LE(pair.off(), 0.10) << eventsOf(pair);
    EXPECT_LE(inDegrees(pair.turned()), 3.0);
}

TEST(RobotPair, TheCrawlerStaysInNoScanOfKurt3DsOnceItIsPlaced) {
    int points[2] = {0, 0};
    for (const bool leavesOut : {false, true}) {
        RobotPair pair(1, Wrong);
        pair.leavesOut = leavesOut;
        pair.pass(9.0, false, false);
        ASSERT_TRUE(pair.crawler().certain) << eventsOf(pair);
        pair.pass(25.0, true, false);
        points[leavesOut ? 1 : 0] = pair.bodyPoints;
    }
    std::printf("  points on the Crawler in key scans: %d, left out: %d\n", points[0], points[1]);
    EXPECT_GT(points[0], 50);
    EXPECT_LE(points[1], points[0] / 20);
}

// It stands beside Kurt3D, drove off, or both did before it is looked for: it is found or not, but never
// wrong.
TEST(RobotPairLong, TheCrawlerIsPlacedWhereKurt3DSeesItInYellowArenas) {
    constexpr int Seeds = 12;
    int placed = 0;
    for (std::uint64_t seed = 1; seed <= Seeds; ++seed) {
        for (const int drives : {0, 1, 2}) {
            RobotPair pair(seed, poseFrom({3.0, 2.0, 0}, 0, 0, degrees(100)));
            if (drives > 0) pair.pass(drives == 1 ? 12.0 : 25.0, drives == 2, true);
            pair.pass(1.0, false, false);
            untilSeen(pair);
            const bool seen =
                !pair.places.empty() && pair.places.back().cause == RobotPlaceSample::Cause::Seen;
            if (!seen || !pair.crawler().certain) continue;
            ++placed;
            printSighting(seed, pair);
            EXPECT_LE(pair.off(), 0.10) << seed << "\n" << eventsOf(pair);
            EXPECT_LE(inDegrees(pair.turned()), 3.0) << seed;
        }
    }
    std::printf("  %d of %d\n", placed, 3 * Seeds);
    EXPECT_GE(placed, 10);
}

// The Crawler follows into what Kurt3D has seen, and now and then beyond.
TEST(RobotPairLong, AMinuteInFourYellowArenas) {
    std::printf("  arena   way     start          worst while certain  worst          certain  ms a view\n");
    for (const std::uint64_t seed : {1U, 2U, 3U, 4U}) {
        RobotPair pair(seed, Wrong);
        pair.pass(9.0, false, false);
        ASSERT_TRUE(pair.crawler().placed) << eventsOf(pair);
        const double start = pair.off(), startTurned = pair.turned();
        EXPECT_LE(start, 0.10) << eventsOf(pair);
        EXPECT_LE(inDegrees(startTurned), 3.0);
        pair.pass(60.0, true, false);
        double most = 0.0, mostTurned = 0.0, certainMost = 0.0, certainTurned = 0.0;
        int certain = 0;
        for (int i = 0; i < 120; ++i) {
            pair.pass(0.5, true, true);
            most = std::max(most, pair.off());
            mostTurned = std::max(mostTurned, pair.turned());
            if (!pair.crawler().certain) continue;
            ++certain;
            certainMost = std::max(certainMost, pair.off());
            certainTurned = std::max(certainTurned, pair.turned());
        }
        std::printf(
            "  yellow %u %4.1f m  %2.0f cm %4.1f deg  %2.0f cm %4.1f deg       %2.0f cm %4.1f deg  %3d %%    "
            "%.1f\n",
            static_cast<unsigned>(seed), pair.way, 100.0 * start, inDegrees(startTurned), 100.0 * certainMost,
            inDegrees(certainTurned), 100.0 * most, inDegrees(mostTurned), certain * 100 / 120,
            1e3 * pair.seconds / pair.views);
        EXPECT_LE(certainMost, 0.15) << seed << "\n" << eventsOf(pair);
        EXPECT_LE(most, 0.35) << seed << ": where Kurt3D has not been, tracks alone carry it on";
    }
}

// The Crawler goes through a building on its own, mostly where Kurt3D has not been: its own laser carries it
// on.
TEST(RobotPairLong, QuarterOfAnHourInABuilding) {
    const std::uint64_t seed = measuredSeed();
    BuildingSettings settings;
    settings.width = 30.0;
    settings.depth = 20.0;
    RobotPair pair(std::move(generateBuilding(settings, seed)).value(), seed);
    pair.pass(6.0, false, false);
    ASSERT_TRUE(pair.crawler().placed) << eventsOf(pair);
    std::vector<double> all, certain;
    for (int i = 0; i < 900; ++i) {
        pair.tour(1.0);
        all.push_back(pair.offNearby());
        if (pair.crawler().certain) certain.push_back(pair.offNearby());
    }
    using leitstand::test::quantile;
    std::printf(
        "  building %llu, %.0f m: %.2f m off (median), %.2f (95 %%), %.2f (worst); certain %zu of %zu times: "
        "%.2f (95 %%), %.2f (worst); "
        "%.1f ms a view\n",
        static_cast<unsigned long long>(seed), pair.way, quantile(all, 0.5), quantile(all, 0.95),
        quantile(all, 1.0), certain.size(), all.size(), quantile(certain, 0.95), quantile(certain, 1.0),
        1e3 * pair.seconds / pair.views);
    EXPECT_LE(quantile(all, 0.95), 0.5);
    EXPECT_LE(quantile(certain, 0.95), 0.15);
}

}  // namespace
}  // namespace leitstand::simulation::test
