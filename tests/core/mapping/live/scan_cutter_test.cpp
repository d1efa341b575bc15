#include "core/mapping/motion/scan_cutter.h"

#include <algorithm>
#include <random>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/event/motion_samples.h"
#include "tests/core/mapping/live/slices.h"

namespace leitstand::test {
namespace {

using std::chrono::milliseconds;
using std::chrono::seconds;

/// Gives slices [first, last) as they are taken, each when it is complete.
void live(Operation& operation, const SliceMaker& maker, int first, int last) {
    for (int i = first; i < last; ++i) {
        operation.until(maker.stampOf(i + 1) - operation.robotAhead);
        operation.give(maker.slice(i));
    }
}

std::vector<LiveScan> all(Operation& operation) {
    operation.until(operation.now + seconds(3));
    std::vector<LiveScan> scans = std::move(operation.scans);
    for (LiveScan& scan : operation.cutter.finish()) scans.push_back(std::move(scan));
    return scans;
}

TEST(ScanCutter, EveryTurnIsAScanAndEverySliceInOne) {
    for (const int firstRow : {0, 7, 31}) {  // begins where the scanner happens to be
        ScanCutter cutter("kurt3d");
        Operation operation(cutter);
        SliceMaker maker;
        maker.firstRow = firstRow;
        live(operation, maker, 0, 3 * SliceMaker::SlicesATurn + 5);
        const auto scans = all(operation);
        ASSERT_EQ(scans.size(), 4U);
        for (int i = 0; i < 3; ++i) {
            const LiveScan& scan = scans[static_cast<std::size_t>(i)];
            EXPECT_EQ(scan.end, TurnEnd::Turn);
            EXPECT_EQ(scan.slices, SliceMaker::SlicesATurn);
            EXPECT_EQ(scan.scan->robot, "kurt3d");
            EXPECT_TRUE(scan.scan->hasOdometry);
            EXPECT_FALSE(scan.extrapolated || scan.bridged);
        }
        EXPECT_EQ(scans[3].end, TurnEnd::Break);
        EXPECT_EQ(rowsIn(scans), allRows(3 * SliceMaker::RowsATurn + 15));
    }
}

TEST(ScanCutter, ASliceWaitsForOdometryButNotForEver) {
    ScanCutter cutter("kurt3d");
    Operation operation(cutter);
    const SliceMaker maker;
    operation.speed = 0.5;
    live(operation, maker, 0, SliceMaker::SlicesATurn - 1);
    operation.until(maker.stampOf(SliceMaker::SlicesATurn - 1) + milliseconds(10));
    operation.odometry = false;  // the last slice ends 67 ms after it
    const Time given = maker.stampOf(SliceMaker::SlicesATurn);
    operation.until(given);
    operation.give(maker.slice(SliceMaker::SlicesATurn - 1));
    EXPECT_EQ(cutter.due(), given + milliseconds(150));
    operation.until(given + milliseconds(150));
    EXPECT_TRUE(operation.scans.empty());
    operation.until(given + milliseconds(170));
    ASSERT_EQ(operation.scans.size(), 1U);
    EXPECT_TRUE(operation.scans[0].extrapolated);
    EXPECT_GT(operation.scans[0].guessed, 0.0);
    EXPECT_LT(operation.scans[0].guessed, 0.1) << "a few points at the end";
    EXPECT_FALSE(operation.scans[0].isGuessed());
    const Scan& scan = *operation.scans[0].scan;
    EXPECT_LT(distanceBetween(scan.sensorInOdom, operation.poseAt(scan.end)), 1e-6) << "as it moved last";
    EXPECT_FALSE(cutter.due());
}

TEST(ScanCutter, OdometryThatComesInTimeIsUsed) {
    ScanCutter cutter("kurt3d");
    Operation operation(cutter);
    const SliceMaker maker;
    operation.speed = 0.5;
    for (int i = 0; i < SliceMaker::SlicesATurn; ++i) {  // slices overtake the odometry
        operation.until(maker.stampOf(i) + milliseconds(20));
        operation.give(maker.slice(i));
    }
    const auto scans = all(operation);
    ASSERT_EQ(scans.size(), 1U);
    EXPECT_FALSE(scans[0].extrapolated);
}

TEST(ScanCutter, ATurnWhoseOdometryAlwaysComesTooLateIsGuessed) {
    ScanCutter cutter("kurt3d");
    const SliceMaker maker;
    std::vector<LiveScan> scans;
    const auto late = milliseconds(400);
    int given = 0;
    for (Time now = maker.start; now < maker.start + seconds(3); now += milliseconds(10)) {
        const auto passed = now - maker.start;
        if (passed % milliseconds(50) == milliseconds(0)) {
            const double x = 0.5 * std::chrono::duration<double>(passed - late).count();
            cutter.add(odometryAt(now - late, poseFrom({x, 0, 0}, 0, 0, 0)), now);
        }
        // The first slices find odometry that is old enough.
        if (passed > seconds(1) && passed % SliceMaker::Slice == milliseconds(0) &&
            given < SliceMaker::SlicesATurn) {
            CloudSample slice = maker.slice(given++);
            slice.header.stamp = now - SliceMaker::Slice;
            cutter.add(std::move(slice), Pose::Identity(), now);
        }
        for (LiveScan& scan : cutter.take(now)) scans.push_back(std::move(scan));
    }
    ASSERT_EQ(scans.size(), 1U);
    EXPECT_TRUE(scans[0].scan->hasOdometry);
    EXPECT_FALSE(scans[0].bridged);
    EXPECT_GT(scans[0].guessed, 0.9);
    EXPECT_TRUE(scans[0].isGuessed()) << "as where odometry is missing within it";
}

TEST(ScanCutter, SlicesOfARadioGapComeLateInOrder) {
    ScanCutter cutter("kurt3d");
    Operation operation(cutter);
    const SliceMaker maker;
    live(operation, maker, 0, 20);
    operation.odometry = false;  // best effort: what was said in the gap is lost
    operation.until(maker.stampOf(620));
    operation.odometry = true;
    operation.until(maker.stampOf(621));
    for (int i = 20; i < 620; ++i) {
        operation.give(maker.slice(i));
        if (i % 10 == 0) operation.until(operation.now + milliseconds(20));
    }
    live(operation, maker, 640, 660);
    const auto scans = all(operation);
    std::vector<int> expected = allRows(620 * SliceMaker::Rows);
    for (int i = 640 * SliceMaker::Rows; i < 660 * SliceMaker::Rows; ++i) expected.push_back(i);
    EXPECT_EQ(rowsIn(scans), expected);
    EXPECT_FALSE(scans.front().bridged);
    EXPECT_FALSE(scans[10].scan->hasOdometry) << "nobody knows a minute's way";
}

TEST(ScanCutter, AShortGapOfTheOdometryIsBridgedAndFlagged) {
    ScanCutter cutter("kurt3d");
    Operation operation(cutter);
    const SliceMaker maker;
    live(operation, maker, 0, 15);
    operation.odometry = false;
    operation.until(maker.stampOf(45));
    operation.odometry = true;
    operation.until(maker.stampOf(46));
    for (int i = 15; i < 45; ++i) operation.give(maker.slice(i));
    const auto scans = all(operation);
    ASSERT_EQ(scans.size(), 3U);
    EXPECT_FALSE(scans[0].bridged);
    EXPECT_TRUE(scans[1].bridged && scans[1].scan->hasOdometry);
    EXPECT_TRUE(scans[1].isGuessed());
    EXPECT_EQ(rowsIn(scans), allRows(45 * SliceMaker::Rows));
}

TEST(ScanCutter, SlicesInAnyOrderGetIntoOneScanEach) {
    for (unsigned seed = 1; seed <= 30; ++seed) {
        std::mt19937 random(seed);
        ScanCutter cutter("kurt3d");
        Operation operation(cutter);
        const SliceMaker maker;
        operation.speed = 0.2;
        auto slices = maker.slices(0, 200);
        // A part comes as it is taken, a part in disorder, some of it long after, some twice.
        std::shuffle(slices.begin() + 50, slices.begin() + 150, random);
        operation.until(maker.stampOf(1));
        for (std::size_t i = 0; i < slices.size(); ++i) {
            operation.give(slices[i]);
            if (random() % 5 == 0) operation.give(slices[i]);
            operation.odometry = random() % 10 != 0;
            operation.until(operation.now + milliseconds(random() % 300));
        }
        EXPECT_GT(cutter.doubled(), 0U);
        EXPECT_EQ(rowsIn(all(operation)), allRows(200 * SliceMaker::Rows)) << seed;
    }
}

TEST(ScanCutter, AClockThatJumpsCostsNoSlice) {
    for (const int jump : {-3600, -100, -10, -2, 2, 30, 86'400}) {
        ScanCutter cutter("kurt3d");
        Operation operation(cutter);
        SliceMaker maker;
        live(operation, maker, 0, 40);
        operation.robotAhead = seconds(jump);
        maker.start += seconds(jump);
        live(operation, maker, 40, 100);
        const auto scans = all(operation);
        EXPECT_EQ(rowsIn(scans), allRows(100 * SliceMaker::Rows)) << jump;
        const auto turns = std::count_if(scans.begin(), scans.end(),
                                         [](const LiveScan& scan) { return scan.end == TurnEnd::Turn; });
        EXPECT_GE(turns, 5) << jump << ": goes on as before";
        EXPECT_FALSE(scans[scans.size() - 2].extrapolated) << jump;
    }
}

TEST(ScanCutter, OdometryThatBeginsAnewEndsTheScan) {
    ScanCutter cutter("kurt3d");
    Operation operation(cutter);
    operation.speed = 0.5;
    const SliceMaker maker;
    live(operation, maker, 0, 20);
    operation.speed = -0.9;  // elsewhere at once
    live(operation, maker, 20, 50);
    const auto scans = all(operation);
    ASSERT_EQ(scans.size(), 4U);
    EXPECT_EQ(scans[0].odometryFrame, scans[1].odometryFrame);
    EXPECT_EQ(scans[1].end, TurnEnd::Break);
    EXPECT_NE(scans[1].odometryFrame, scans[2].odometryFrame);
    EXPECT_EQ(scans[2].odometryFrame, scans[3].odometryFrame);
    EXPECT_EQ(rowsIn(scans), allRows(50 * SliceMaker::Rows));
}

TEST(ScanCutter, AScannerThatBeginsAnewBeginsAnotherScan) {
    ScanCutter cutter("kurt3d");
    Operation operation(cutter);
    SliceMaker maker;
    live(operation, maker, 0, 10);
    maker.firstRow = 17;
    live(operation, maker, 30, 50);
    const auto scans = all(operation);
    ASSERT_EQ(scans.size(), 3U);
    EXPECT_EQ(scans[0].end, TurnEnd::Break);
    EXPECT_EQ(scans[0].slices, 10);
    EXPECT_EQ(scans[1].end, TurnEnd::Turn);
    EXPECT_EQ(scans[1].scan->start, maker.stampOf(30));
}

TEST(ScanCutter, AScanIsCutWhereTheRobotMovedTooFar) {
    ScanCutter cutter("kurt3d", {milliseconds(150), 0.5, degrees(270)});
    Operation operation(cutter);
    operation.speed = 0.6;
    const SliceMaker maker;
    live(operation, maker, 0, 45);
    const auto scans = all(operation);
    ASSERT_GE(scans.size(), 5U);
    for (std::size_t i = 0; i + 1 < scans.size(); ++i) EXPECT_EQ(scans[i].end, TurnEnd::Distance);
    EXPECT_EQ(rowsIn(scans), allRows(45 * SliceMaker::Rows));
    EXPECT_LT((scans[0].scan->end - scans[0].scan->start), milliseconds(1100));
    // From the end of its first slice to its last shot.
    EXPECT_NEAR(
        scans[1].began.norm(),
        0.6 * std::chrono::duration<double>(scans[1].scan->end - scans[1].scan->start - SliceMaker::Slice)
                  .count(),
        0.05);
    EXPECT_LT(scans[1].began.x(), 0.0) << "it drives ahead";
}

TEST(ScanCutter, WholeSweepsAreScansBesideATurn) {
    ScanCutter cutter("kurt3d");
    Operation operation(cutter);
    const SliceMaker maker;
    live(operation, maker, 0, 10);
    CloudSample sweep;
    sweep.header = {operation.now - seconds(3), "tilting"};
    sweep.points.assign(100, Eigen::Vector3f(1, 2, 3));
    operation.give(sweep);
    live(operation, maker, 10, 15);
    const auto scans = all(operation);
    ASSERT_EQ(scans.size(), 2U);
    const auto turn = std::find_if(scans.begin(), scans.end(),
                                   [](const LiveScan& scan) { return scan.end == TurnEnd::Turn; });
    ASSERT_NE(turn, scans.end());
    EXPECT_EQ(turn->slices, SliceMaker::SlicesATurn);
}

TEST(ScanCutter, WithoutOdometrySlicesStillMakeScans) {
    ScanCutter cutter("kurt3d");
    Operation operation(cutter);
    operation.odometry = false;
    live(operation, SliceMaker{}, 0, 30);
    const auto scans = all(operation);
    ASSERT_EQ(scans.size(), 2U);
    EXPECT_FALSE(scans[0].scan->hasOdometry || scans[0].levelKnown);
}

TEST(ScanCutter, TheInertialUnitTellsTheLevel) {
    ScanCutter cutter("kurt3d");
    Operation operation(cutter);
    const SliceMaker maker;
    const Pose tilted = poseFrom({0, 0, 0}, degrees(5), degrees(-8), 0);
    const Pose unitInBase = poseFrom({0, 0, 0.2}, 0, 0, degrees(90));
    for (int i = 0; i < 30; ++i) {
        ImuSample imu;
        imu.header = {maker.stampOf(0) + i * milliseconds(50), "imu"};
        imu.orientation = Eigen::Quaterniond(tilted.linear() * unitInBase.linear());
        cutter.add(imu, unitInBase, operation.now);
    }
    live(operation, maker, 0, 15);
    const auto scans = all(operation);
    ASSERT_EQ(scans.size(), 1U);
    EXPECT_TRUE(scans[0].levelKnown);
    EXPECT_TRUE(scans[0].up.isApprox(tilted.linear().transpose() * Eigen::Vector3d::UnitZ(), 1e-6));
    EXPECT_LT(angleBetween(scans[0].scan->sensorInOdom, tilted), 1e-6) << "odometry knows no slopes";
}

TEST(ScanCutter, WhereTheInertialUnitFallsSilentNobodyKnowsTheLevel) {
    ScanCutter cutter("kurt3d");
    Operation operation(cutter);
    const SliceMaker maker;
    ImuSample imu;
    imu.orientation = Eigen::Quaterniond(poseFrom({0, 0, 0}, 0, degrees(-8), 0).linear());
    for (int i = 0; i < 10; ++i) {
        imu.header = {maker.stampOf(0) + i * milliseconds(50), "imu"};
        cutter.add(imu, Pose::Identity(), operation.now);
    }
    live(operation, maker, 0, 30);
    const auto scans = all(operation);
    ASSERT_EQ(scans.size(), 2U);
    EXPECT_FALSE(scans[1].levelKnown) << "odometry knows no slopes";
    EXPECT_TRUE(scans[1].up.isApprox(Eigen::Vector3d::UnitZ())) << "but there is nothing better";
}

}  // namespace
}  // namespace leitstand::test
