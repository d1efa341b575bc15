#include "core/mapping/motion/turn_assembler.h"

#include <algorithm>
#include <limits>

#include <gtest/gtest.h>

#include "tests/support/rooms.h"

namespace leitstand::test {
namespace {

constexpr int Rows = 181, Columns = 161, RowsASlice = 8;

Scan turnAt(const Pose& sensorInRoom) {
    RoomSettings settings;
    settings.sweep = Sweep::Yawing;
    settings.rows = Rows;
    settings.columns = Columns;
    settings.rangeNoise = 0.0;
    settings.sensorInRoom = sensorInRoom;
    return scanRoom(settings).scan;
}

/// Rows from @p first on of a turn, as the scanner at @p sensorInRoom sees them.
CloudSample sliceOf(const Scan& turn, int first, Time stamp) {
    CloudSample slice;
    slice.header = {stamp, "laser"};
    slice.rows = std::min(RowsASlice, turn.rows - first);
    slice.columns = turn.columns;
    const auto begin = turn.points.begin() + static_cast<std::ptrdiff_t>(first) * Columns;
    slice.points.assign(begin, begin + static_cast<std::ptrdiff_t>(slice.rows) * Columns);
    return slice;
}

Time stampOf(int slice) {
    return Time(std::chrono::milliseconds(100 * slice));
}

/// What a covered scanner sends.
CloudSample blindSlice(Time stamp) {
    CloudSample slice;
    slice.header = {stamp, "laser"};
    slice.rows = RowsASlice;
    slice.columns = Columns;
    slice.points.assign(static_cast<std::size_t>(RowsASlice) * Columns,
                        Eigen::Vector3f::Constant(std::numeric_limits<float>::quiet_NaN()));
    return slice;
}

/// How far points lie beyond the room's walls of 8 x 6 x 2.6 m: those of a smeared turn do [m].
double beyondTheWalls(const Scan& scan, const Pose& sensorInRoom) {
    double worst = 0.0;
    for (const Eigen::Vector3f& point : scan.points) {
        if (!point.allFinite()) continue;
        const Eigen::Vector3d inRoom = sensorInRoom * point.cast<double>();
        worst = std::max(
            {worst, std::abs(inRoom.x()) - 4.0, std::abs(inRoom.y()) - 3.0, -inRoom.z(), inRoom.z() - 2.6});
    }
    return worst;
}

TEST(TurnAssembler, SlicesOfAStandingRobotMakeTheTurn) {
    const Scan turn = turnAt(poseFrom({0, 0, 1}, 0, 0, 0));
    TurnAssembler assembler;
    std::vector<Scan> scans;
    for (int first = 0, slice = 0; first < Rows; first += RowsASlice, ++slice) {
        if (auto scan = assembler.add(sliceOf(turn, first, stampOf(slice)), turn.sensorInOdom)) {
            scans.push_back(std::move(*scan));
        }
    }
    ASSERT_EQ(scans.size(), 1u);
    EXPECT_EQ(scans[0].rows, Rows);
    EXPECT_EQ(scans[0].columns, Columns);
    EXPECT_EQ(scans[0].sweep, Sweep::Yawing);
    EXPECT_TRUE(scans[0].hasOdometry);
    EXPECT_EQ(scans[0].end, stampOf(22));
    for (std::size_t i = 0; i < turn.points.size(); ++i) {
        if (!turn.points[i].allFinite()) continue;
        ASSERT_TRUE(scans[0].points[i].isApprox(turn.points[i], 1e-5F));
    }
}

TEST(TurnAssembler, TakesTheMotionFromSliceToSliceOut) {
    TurnAssembler assembler;
    std::optional<Scan> scan;
    Pose last = Pose::Identity();
    for (int first = 0, slice = 0; first < Rows && !scan; first += RowsASlice, ++slice) {
        last = poseFrom({0.02 * slice, 0.0, 1.0}, 0, 0, degrees(0.5 * slice));
        scan = assembler.add(sliceOf(turnAt(last), first, stampOf(slice)), last);
    }
    ASSERT_TRUE(scan);
    EXPECT_TRUE(scan->sensorInOdom.isApprox(last));
    EXPECT_LT(beyondTheWalls(*scan, last), 1e-4);
}

TEST(TurnAssembler, TakesTheMotionWithinSlicesOut) {
    // 0.5 m/s and 90 degrees/s, a raw scan every 12.8 ms: within a slice the robot turns by 8 degrees.
    const auto poseAt = [](Time at) -> std::optional<Pose> {
        const double seconds = std::chrono::duration<double>(at.time_since_epoch()).count();
        return poseFrom({0.5 * seconds, 0.0, 1.0}, 0, 0, degrees(90) * seconds);
    };
    constexpr std::chrono::microseconds RawScan(12'800);
    TurnAssembler assembler;
    std::optional<Scan> scan;
    Time end;
    for (int first = 0; first < Rows && !scan; first += RowsASlice) {
        CloudSample slice = sliceOf(turnAt(*poseAt(Time(first * RawScan))), first, Time(first * RawScan));
        for (int row = 0; row < slice.rows; ++row) {
            const Time at = Time((first + row) * RawScan);
            const CloudSample seen = sliceOf(turnAt(*poseAt(at)), first + row, at);
            const auto begin = static_cast<std::ptrdiff_t>(row) * Columns;
            std::copy_n(seen.points.begin(), Columns, slice.points.begin() + begin);
            slice.times.insert(slice.times.end(), Columns, std::chrono::nanoseconds(row * RawScan).count());
            end = at;
        }
        scan = assembler.add(slice, poseAt);
    }
    ASSERT_TRUE(scan);
    EXPECT_EQ(scan->end, end);
    EXPECT_TRUE(scan->sensorInOdom.isApprox(*poseAt(end)));
    EXPECT_LT(beyondTheWalls(*scan, *poseAt(end)), 1e-4);
}

TEST(TurnAssembler, PointsOfMomentsWithoutAPoseStayWhereTheyAre) {
    CloudSample cloud;
    cloud.points.assign(2, Eigen::Vector3f(1, 0, 0));
    cloud.times = {0, 1'000'000'000};
    const auto poseAt = [](Time at) -> std::optional<Pose> {
        if (at == Time{}) return std::nullopt;
        return poseFrom({2, 0, 0}, 0, 0, 0);
    };
    TurnAssembler assembler;
    const auto scan = assembler.add(cloud, poseAt);
    ASSERT_TRUE(scan && scan->hasOdometry);
    EXPECT_EQ(scan->points[0], Eigen::Vector3f(1, 0, 0));
}

TEST(TurnAssembler, WholeSweepsAreScansAtOnce) {
    CloudSample unorganised;
    unorganised.points.assign(1000, Eigen::Vector3f(1, 2, 3));
    TurnAssembler assembler;
    const auto velodyne = assembler.add(unorganised, std::nullopt);
    ASSERT_TRUE(velodyne);
    EXPECT_FALSE(velodyne->organised());
    EXPECT_FALSE(velodyne->hasOdometry);

    RoomSettings tilting;
    const Scan room = scanRoom(tilting).scan;
    CloudSample sweep;
    sweep.rows = room.rows;
    sweep.columns = room.columns;
    sweep.points = room.points;
    const auto scan = assembler.add(sweep, Pose::Identity());
    ASSERT_TRUE(scan);
    EXPECT_EQ(scan->rows, room.rows);
    EXPECT_EQ(scan->sweep, Sweep::Tilting);
}

TEST(TurnAssembler, ARadioGapEndsATurnThatIsHalfThere) {
    const Scan turn = turnAt(poseFrom({0, 0, 1}, 0, 0, 0));
    TurnAssembler assembler;
    for (int slice = 0; slice < 15; ++slice) {
        EXPECT_FALSE(assembler.add(sliceOf(turn, slice * RowsASlice, stampOf(slice)), turn.sensorInOdom));
    }
    const auto half = assembler.add(sliceOf(turn, 0, stampOf(80)), turn.sensorInOdom);
    ASSERT_TRUE(half);
    EXPECT_EQ(half->rows, 15 * RowsASlice);
    EXPECT_FALSE(assembler.finish()) << "one slice is no turn";
}

TEST(TurnAssembler, SlicesWithoutAnyEchoAreNotScans) {
    const Scan turn = turnAt(poseFrom({0, 0, 1}, 0, 0, 0));
    TurnAssembler assembler;
    EXPECT_FALSE(assembler.add(sliceOf(turn, 0, stampOf(0)), turn.sensorInOdom));
    EXPECT_FALSE(assembler.add(blindSlice(stampOf(1)), turn.sensorInOdom));
}

TEST(TurnAssembler, AYawDriveThatIsStuckEndsTheTurnAfterTenSeconds) {
    const Scan turn = turnAt(poseFrom({0, 0, 1}, 0, 0, 0));
    CloudSample stuck = sliceOf(turn, 0, {});
    for (int row = 1; row < stuck.rows; ++row)
        std::copy_n(stuck.points.begin(), Columns, stuck.points.begin() + std::ptrdiff_t(row) * Columns);
    TurnAssembler assembler(TurnSettings{.leastTurn = 0.0});
    std::vector<Scan> scans;
    for (int slice = 0; slice < 250; ++slice) {
        stuck.header.stamp = stampOf(slice);
        if (auto scan = assembler.add(stuck, turn.sensorInOdom)) {
            EXPECT_EQ(assembler.ended(), TurnEnd::Break);
            scans.push_back(std::move(*scan));
        }
    }
    ASSERT_EQ(scans.size(), 2U);
    for (const Scan& scan : scans) EXPECT_EQ(scan.end - scan.start, std::chrono::seconds(10));
    EXPECT_GT(scans[1].start, scans[0].end) << "no slice is in both";
}

TEST(TurnAssembler, ACoveredWindowEndsTheTurnAndTheNextOneBeginsWhenItIsOpen) {
    const Scan turn = turnAt(poseFrom({0, 0, 1}, 0, 0, 0));
    TurnAssembler assembler(TurnSettings{.leastTurn = 0.0});
    std::vector<Scan> scans;
    int slice = 0;
    const auto give = [&](const CloudSample& cloud) {
        if (auto scan = assembler.add(cloud, turn.sensorInOdom)) scans.push_back(std::move(*scan));
    };
    for (; slice < 10; ++slice) give(sliceOf(turn, slice * RowsASlice, stampOf(slice)));
    for (; slice < 150; ++slice) give(blindSlice(stampOf(slice)));
    ASSERT_EQ(scans.size(), 1U);
    EXPECT_EQ(assembler.ended(), TurnEnd::Break);
    EXPECT_GE(scans[0].end - scans[0].start, std::chrono::seconds(10));
    EXPECT_LE(scans[0].end - scans[0].start, std::chrono::seconds(15)) << "it had turned by 150 degrees";
    for (int first = 0; first < Rows; first += RowsASlice, ++slice)
        give(sliceOf(turn, first, stampOf(slice)));
    ASSERT_EQ(scans.size(), 2U);
    EXPECT_EQ(assembler.ended(), TurnEnd::Turn);
}

TEST(TurnAssembler, ASlowScannersTurnIsWhole) {
    const Scan turn = turnAt(poseFrom({0, 0, 1}, 0, 0, 0));
    TurnAssembler assembler;
    std::vector<Scan> scans;
    for (int round = 0, slice = 0; round < 2; ++round) {
        for (int first = 0; first < Rows; first += RowsASlice, slice += 6) {
            if (auto scan = assembler.add(sliceOf(turn, first, stampOf(slice)), turn.sensorInOdom))
                scans.push_back(std::move(*scan));
        }
    }
    ASSERT_FALSE(scans.empty());
    EXPECT_EQ(assembler.ended(), TurnEnd::Turn);
    EXPECT_GT(scans[0].end - scans[0].start, std::chrono::seconds(10));
}

}  // namespace
}  // namespace leitstand::test
