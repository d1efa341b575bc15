#include "core/mapping/table1.h"

#include <gtest/gtest.h>

#include "core/mapping/scan_preparation.h"
#include "tests/support/rooms.h"

namespace leitstand {
namespace {

ScanPtr roomScan(const Pose& sensorInRoom, unsigned seed) {
    test::RoomSettings settings;
    settings.sensorInRoom = sensorInRoom;
    settings.rows = 116;
    settings.columns = 180;
    settings.seed = seed;
    return labelled(std::make_shared<const Scan>(test::scanRoom(settings).scan));
}

TEST(Table1, HasThePapersRowsAndBruteForcePairsLikeTheKdTree) {
    const ScanPtr target = roomScan(poseFrom({-0.5, 0, 0.9}, 0, 0, 0), 1);
    Scan source = *roomScan(poseFrom({-0.3, 0.1, 0.9}, 0, 0, degrees(3)), 2);
    source.sensorInOdom = source.sensorInOdom * poseFrom({0.04, -0.03, 0}, 0, 0, degrees(1));
    Table1Settings settings;
    settings.repetitions = 1;
    settings.bruteForceIterations = 1;
    const auto table = measureTable1(*target, source, settings);
    ASSERT_TRUE(table) << table.error().text;
    const Table1& rows = *table;
    EXPECT_LT(rows[0].distance, 1e-6) << "brute force pairs the same points";
    EXPECT_TRUE(rows[0].extrapolated);
    EXPECT_EQ(rows[0].iterations, rows[1].iterations);
    EXPECT_GT(rows[0].seconds, rows[1].seconds);
    EXPECT_EQ(rows[1].distance, 0.0);
    EXPECT_EQ(rows[1].speedUp, 1.0);
    EXPECT_NEAR(rows[4].paperSpeedUp, 17.9, 0.05);
    for (std::size_t i = 1; i < rows.size(); ++i) {
        EXPECT_LT(rows[i].distance, 0.06) << "row " << i;
        EXPECT_EQ(rows[i].counts, rows[i].distance <= 0.03 && inDegrees(rows[i].angle) <= 0.5);
        EXPECT_EQ(rows[i].reduced, i >= 2);
        EXPECT_GT(rows[i].seconds, 0.0);
    }
    EXPECT_LT(rows[4].sourcePoints, rows[1].sourcePoints * 2 / 3);
}

TEST(Table1, ScansWithoutPointsInRangeAreAnError) {
    const ScanPtr scan = roomScan(poseFrom({-0.5, 0, 0.9}, 0, 0, 0), 1);
    Table1Settings settings;
    settings.minRange = 24.0;
    const auto table = measureTable1(*scan, *scan, settings);
    ASSERT_FALSE(table);
    EXPECT_NE(table.error().text.find("expected points in range"), std::string::npos);
}

TEST(Table1, CanBeCancelled) {
    const ScanPtr scan = roomScan(poseFrom({-0.5, 0, 0.9}, 0, 0, 0), 1);
    std::stop_source stop;
    stop.request_stop();
    EXPECT_FALSE(measureTable1(*scan, *scan, {}, {{}, stop.get_token()}));
}

}  // namespace
}  // namespace leitstand
