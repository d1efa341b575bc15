#include "core/mapping/motion/turn_refinement.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <random>

#include <gtest/gtest.h>

#include "core/cloud/search/search.h"
#include "core/mapping/live/live_mapper.h"
#include "core/mapping/live/scan_work.h"
#include "tests/support/room_scene.h"

namespace leitstand::test {
namespace {

constexpr int Columns = 161;
constexpr double TurnTime = 2.3;  ///< [s]
constexpr double Length = 8.0, Width = 6.0, Height = 2.6;
const float NoNumber = std::numeric_limits<float>::quiet_NaN();

/// How a robot moves, and what its odometry makes of it.
struct Drive {
    double speed = 0.4, turnRate = 0.3;             ///< [m/s, rad/s]
    double speedShare = 0.8, turnOff = degrees(3);  ///< odometry's speed, and its error of the turn rate
};

Pose after(double speed, double turnRate, double time) {
    const double turned = turnRate * time;
    const double ahead = std::abs(turnRate) > 1e-9 ? speed / turnRate * std::sin(turned) : speed * time;
    const double aside = std::abs(turnRate) > 1e-9 ? speed / turnRate * (1.0 - std::cos(turned)) : 0.0;
    return poseFrom({ahead, aside, 0}, 0, 0, turned);
}

/// A turn as ScanCutter gives it.
struct Turn {
    LiveScan live;
    Pose sensorInRoom = Pose::Identity();  ///< at the last shot
};

Turn turnOf(const RoomScene& scene, const Pose& begin, const Drive& drive, unsigned seed) {
    const int rows = 241, columns = Columns;
    std::mt19937 random(seed);
    std::normal_distribution<double> noise(0.0, 0.01);
    const auto odometry = [&](double time) {
        return after(drive.speed * drive.speedShare, drive.turnRate + drive.turnOff, time);
    };
    Scan scan;
    scan.robot = "kurt3d";
    scan.rows = rows;
    scan.columns = columns;
    scan.sweep = Sweep::Yawing;
    scan.start = Time(std::chrono::seconds(1000 + 10 * seed));
    scan.end = scan.start + std::chrono::milliseconds(2300);
    for (int row = 0; row < rows; ++row) {
        const double time = TurnTime * row / (rows - 1);
        const Pose sensor = begin * after(drive.speed, drive.turnRate, time);
        const Pose toEnd = odometry(TurnTime).inverse() * odometry(time);
        const double heading = degrees(-180.0 + 360.0 * row / rows);
        for (int column = 0; column < columns; ++column) {
            const double elevation = degrees(-70.0 + 160.0 * column / (columns - 1));
            const Eigen::Vector3d ray(std::cos(elevation) * std::cos(heading),
                                      std::cos(elevation) * std::sin(heading), std::sin(elevation));
            const auto hit = scene.cast(sensor.translation(), sensor.linear() * ray);
            const double error = noise(random);
            scan.points.emplace_back(Eigen::Vector3f::Constant(NoNumber));
            if (!hit || hit->range > 15.0) continue;
            scan.points.back() = (toEnd * Eigen::Vector3d((hit->range + error) * ray)).cast<float>();
        }
    }
    Turn turn;
    turn.sensorInRoom = begin * after(drive.speed, drive.turnRate, TurnTime);
    scan.sensorInOdom = turn.sensorInRoom;
    scan.hasOdometry = true;
    turn.live.up = turn.sensorInRoom.linear().transpose() * Eigen::Vector3d::UnitZ();
    turn.live.levelKnown = true;
    turn.live.scan = std::make_shared<const Scan>(std::move(scan));
    return turn;
}

/// All of a room's surfaces, without noise: the map. @p ends: whether it has walls across its length.
LocalMap mapOf(double length, double width, bool ends) {
    constexpr double Step = 0.07;  // [m]
    const Eigen::Vector3d low(-length / 2, -width / 2, 0.0), high(length / 2, width / 2, Height);
    LocalMap local;
    local.scans = {1};
    for (int axis = ends ? 0 : 1; axis < 3; ++axis) {
        const int across = (axis + 1) % 3, along = (axis + 2) % 3;
        for (double u = low[across]; u <= high[across]; u += Step) {
            for (double v = low[along]; v <= high[along]; v += Step) {
                for (const double side : {low[axis], high[axis]}) {
                    Eigen::Vector3d point;
                    point[axis] = side;
                    point[across] = u;
                    point[along] = v;
                    local.cloud.points.emplace_back(point.cast<float>());
                    local.cloud.normals.emplace_back(Eigen::Vector3f::Unit(axis) *
                                                     (side == low[axis] ? 1.0F : -1.0F));
                }
            }
        }
    }
    local.search = makeSearch(local.cloud, SearchMethod::KdTree);
    return local;
}

/// Root mean square distance of @p points at @p scanInRoom from the planes of the room [m].
double distanceFromPlanes(const std::vector<Eigen::Vector3f>& points, const Pose& scanInRoom) {
    const Eigen::Array3d low(-Length / 2, -Width / 2, 0.0), high(Length / 2, Width / 2, Height);
    double squares = 0.0;
    std::size_t count = 0;
    for (const Eigen::Vector3f& point : points) {
        if (!point.allFinite()) continue;
        const Eigen::Array3d place = (scanInRoom * point.cast<double>()).array();
        squares += std::pow(std::min((place - low).abs().minCoeff(), (high - place).abs().minCoeff()), 2);
        ++count;
    }
    return std::sqrt(squares / static_cast<double>(count));
}

class TurnRefinement : public testing::Test {
protected:
    /// Where @p turn is registered to, as live mapping does it.
    [[nodiscard]] Pose registered(const Turn& turn) const {
        const ReadyScan ready = readyScan(turn.live, {}, turn.sensorInRoom, {});
        FitSettings fit;
        fit.jump = fit.turn = 1.0;
        fit.mostResidual = 0.15;
        const Match found = match(ready.reduced, m_map, turn.sensorInRoom,
                                  {.measured = true, .trusted = true}, std::nullopt, {}, fit);
        EXPECT_EQ(found.doubts, 0);
        return found.scanInMap;
    }

    const RoomScene m_room{Length, Width, Height, false, false};
    const LocalMap m_map = mapOf(Length, Width, true);
    const Pose m_begin = poseFrom({-1.0, 0.3, 0.9}, 0, 0, 0.3);
};

TEST_F(TurnRefinement, PointsOfATurnWithWrongOdometryComeAtLeastTwiceAsNearToThePlanes) {
    const std::vector<Drive> drives = {{0.4, 0.3, 0.8, degrees(3)}, {0.4, -0.2, 1.2, degrees(-3)}};
    for (const Drive& drive : drives) {
        const Turn turn = turnOf(m_room, m_begin, drive, 1);
        const Pose scanInMap = registered(turn);
        const auto drift = turnDrift(*turn.live.scan, m_map, scanInMap);
        ASSERT_TRUE(drift) << drive.speedShare;
        const double before = distanceFromPlanes(turn.live.scan->points, scanInMap);
        const Pose refinedInMap = scanInMap * drift->at(1.0);
        const double refined = distanceFromPlanes(straightened(*turn.live.scan, *drift).points, refinedInMap);
        EXPECT_GT(before, 0.02) << "odometry is wrong";
        EXPECT_LE(refined, 0.5 * before) << before;
        EXPECT_LT(distanceBetween(refinedInMap, turn.sensorInRoom), 0.05);
        EXPECT_LT(distanceBetween(refinedInMap, turn.sensorInRoom),
                  distanceBetween(scanInMap, turn.sensorInRoom));
    }
}

TEST_F(TurnRefinement, ExactOdometryIsNotMadeWorse) {
    const Turn turn = turnOf(m_room, m_begin, {0.4, 0.3, 1.0, 0.0}, 2);
    const Pose scanInMap = registered(turn);
    TurnRefinementSettings settings;
    settings.leastGain = -1.0;  // what is found is taken, although it gains nothing
    const auto drift = turnDrift(*turn.live.scan, m_map, scanInMap, settings);
    ASSERT_TRUE(drift);
    EXPECT_LE(distanceFromPlanes(straightened(*turn.live.scan, *drift).points, scanInMap * drift->at(1.0)),
              distanceFromPlanes(turn.live.scan->points, scanInMap) + 0.001);
    EXPECT_LT(drift->whole.head<3>().norm(), 0.02);
    EXPECT_LT(inDegrees(drift->whole.tail<3>().norm()), 0.5);
}

TEST_F(TurnRefinement, WhatTellsNothingLeavesTheTurnAsItWas) {
    const Turn turn = turnOf(m_room, m_begin, {}, 3);
    const Scan& scan = *turn.live.scan;
    const Pose scanInMap = registered(turn);
    ASSERT_TRUE(turnDrift(scan, m_map, scanInMap));

    Scan few = scan;
    for (std::size_t i = 0; i < few.points.size(); ++i)
        if (i % (2 * Columns) != Columns / 2) few.points[i].setConstant(NoNumber);
    EXPECT_FALSE(turnDrift(few, m_map, scanInMap)) << "too few points";
    Scan nothing = scan;
    for (Eigen::Vector3f& point : nothing.points) point.setConstant(NoNumber);
    EXPECT_FALSE(turnDrift(nothing, m_map, scanInMap));
    Scan unorganised = scan;
    unorganised.rows = unorganised.columns = 0;
    EXPECT_FALSE(turnDrift(unorganised, m_map, scanInMap));
    Scan oneRow = scan;
    oneRow.rows = 1;
    EXPECT_FALSE(turnDrift(oneRow, m_map, scanInMap));
    Pose nowhere = scanInMap;
    nowhere.translation().x() = std::numeric_limits<double>::quiet_NaN();
    EXPECT_FALSE(turnDrift(scan, m_map, nowhere));
    EXPECT_FALSE(turnDrift(scan, LocalMap{}, scanInMap)) << "no map";
    LocalMap elsewhere = mapOf(Length, Width, true);
    for (Eigen::Vector3f& point : elsewhere.cloud.points) point.x() += 100.0F;
    elsewhere.search = makeSearch(elsewhere.cloud, SearchMethod::KdTree);
    EXPECT_FALSE(turnDrift(scan, elsewhere, scanInMap));
    TurnRefinementSettings tight;
    tight.mostTurned = degrees(2);
    EXPECT_FALSE(turnDrift(scan, m_map, scanInMap, tight)) << "no robot errs that much";
}

TEST_F(TurnRefinement, SomePointsThatAreNoNumbersChangeNothingOfTheOthers) {
    const Turn turn = turnOf(m_room, m_begin, {}, 4);
    const Pose scanInMap = registered(turn);
    Scan holes = *turn.live.scan;
    for (std::size_t i = 0; i < holes.points.size(); i += 5) holes.points[i].setConstant(NoNumber);
    const auto drift = turnDrift(holes, m_map, scanInMap);
    ASSERT_TRUE(drift);
    const Scan refined = straightened(holes, *drift);
    ASSERT_EQ(refined.points.size(), holes.points.size());
    for (std::size_t i = 0; i < holes.points.size(); ++i)
        ASSERT_EQ(refined.points[i].allFinite(), holes.points[i].allFinite()) << i;
    EXPECT_LE(distanceFromPlanes(refined.points, scanInMap * drift->at(1.0)),
              0.5 * distanceFromPlanes(holes.points, scanInMap));
}

TEST_F(TurnRefinement, AnOpenCorridorLeavesTheTurnAsItWas) {
    const RoomScene corridor(60.0, 2.0, Height, false, true);
    const LocalMap map = mapOf(32.0, 2.0, false);
    const Turn turn =
        turnOf(corridor, poseFrom({-1.0, 0.1, 0.9}, 0, 0, 0.1), {0.4, 0.05, 0.8, degrees(1)}, 5);
    EXPECT_FALSE(turnDrift(*turn.live.scan, map, turn.sensorInRoom));
    TurnRefinementSettings bold;
    bold.leastCertainty = -1.0;
    EXPECT_TRUE(turnDrift(*turn.live.scan, map, turn.sensorInRoom, bold)) << "only certainty is missing";
}

TEST_F(TurnRefinement, LiveMappingTakesTheRefinedPointsIntoItsMapWhenToldSoOrWhereOdometryErred) {
    const Turn first = turnOf(m_room, m_begin, {0.0, 0.0, 1.0, 0.0}, 6);
    const Turn second = turnOf(m_room, m_begin, {}, 7);
    const auto mappedWith = [&](const LiveSettings& settings) {
        LiveMapper mapper("station", settings);
        const Time now(std::chrono::seconds(5000));
        const MapUpdate begin = mapper.add(first.live, now);
        const MapUpdate update = mapper.add(second.live, now + std::chrono::seconds(3));
        EXPECT_EQ(update.localisation.doubts, 0);
        EXPECT_TRUE(begin.keyScan && update.keyScan);
        const Pose mapInRoom = first.sensorInRoom * begin.keyScan->scanInMap.inverse();
        return distanceFromPlanes(update.keyScan->scan->points, mapInRoom * update.keyScan->scanInMap);
    };
    EXPECT_FALSE(LiveSettings{}.refinement.on);
    EXPECT_TRUE(LiveSettings{}.refined.empty());
    LiveSettings none;
    none.refinement.from = 1.0;
    none.refinement.fromAngle = 1.0;
    LiveSettings all = none, kurts = none, others = none;
    all.refinement.on = true;
    kurts.refined = {"kurt3d"};
    others.refined = {"crawler"};
    const double asMeasured = mappedWith(none);
    EXPECT_LE(mappedWith({}), 0.6 * asMeasured) << "it fits elsewhere than where odometry has it";
    EXPECT_LE(mappedWith(all), 0.6 * asMeasured);
    EXPECT_LE(mappedWith(kurts), 0.6 * asMeasured);
    EXPECT_NEAR(mappedWith(others), asMeasured, 1e-6) << "another robot's";
}

}  // namespace
}  // namespace leitstand::test
