#include "core/mapping/sighting/passing_bodies.h"

#include <cmath>
#include <map>
#include <memory>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/event/scan_bodies.h"
#include "core/mapping/live/scan_cleaning.h"
#include "tests/core/mapping/live/mapped_room.h"

namespace leitstand::test {
namespace {

using testing::SizeIs;

/// A robot goes through the furnished room, and somebody stands where the test says.
struct RoomWithSomebody : MappedRoom {
    /// Where a person stands at @p place of the room, as the scanner at @p sensorInRoom sees it; whatever is
    /// behind is hidden.
    static void stand(Scan& scan, const Pose& sensorInRoom, const Eigen::Vector2d& place) {
        constexpr double Radius = 0.25, Height = 1.7;
        const Pose roomInSensor = sensorInRoom.inverse();
        const Eigen::Vector2d eye = sensorInRoom.translation().head<2>();
        const Eigen::Vector2d to = place - eye;
        for (Eigen::Vector3f& point : scan.points) {
            if (!point.allFinite()) continue;
            const Eigen::Vector3d there = sensorInRoom * point.cast<double>();
            const Eigen::Vector2d ray = there.head<2>() - eye;
            const double along = ray.dot(to) / ray.norm();
            const double aside = std::sqrt(std::max(0.0, to.squaredNorm() - along * along));
            if (along <= 0.0 || aside >= Radius || ray.norm() < along) continue;
            const double hit = along - std::sqrt(Radius * Radius - aside * aside);
            const Eigen::Vector3d on =
                sensorInRoom.translation() + hit / ray.norm() * (there - sensorInRoom.translation());
            if (on.z() > 0.02 && on.z() < Height) point = (roomInSensor * on).cast<float>();
        }
    }
    std::map<std::uint64_t, std::vector<BodyInScan>> pass(const Pose& sensorInRoom,
                                                          const std::optional<Eigen::Vector2d>& somebody) {
        LiveScan live = scanAt(sensorInRoom, seed++);
        RoomSettings room;  // as dense as a turn of a real scanner
        room.sensorInRoom = sensorInRoom;
        room.sweep = Sweep::Yawing;
        room.rows = 360;
        room.columns = 120;
        room.seed = seed;
        Scan scan = *live.scan;
        scan.points = scanRoom(room).scan.points;
        scan.rows = room.rows;
        scan.columns = room.columns;
        if (somebody) stand(scan, sensorInRoom, *somebody);
        live.scan = std::make_shared<const Scan>(std::move(scan));
        const MapUpdate update = add(live);
        EXPECT_TRUE(update.keyScan);
        auto found = passing.add(*mapper.map(), update.keyScan->id, mapper.together(update.keyScan->id));
        for (auto& [id, bodies] : found) {
            if (!bodies.empty()) (void)mapper.leaveOut(id, bodies);
        }
        return found;
    }
    /// Points of the map within 40 cm of @p place of the room, over the floor.
    std::size_t pointsAt(const Eigen::Vector2d& place) const {
        const LiveMapPtr map = mapper.map();
        const Pose roomInMap = poseFrom({-1.4, 0, 0.9}, 0, 0, 0).inverse();
        std::size_t points = 0;
        for (const LiveKeyScan& scan : map->scans) {
            for (const Eigen::Vector3f& point : scan.scan->points) {
                const Eigen::Vector3d there =
                    roomInMap.inverse() * (scan.pose.scanInMap * point.cast<double>());
                if (there.z() > 0.2 && there.z() < 1.8 && (there.head<2>() - place).norm() < 0.4) ++points;
            }
        }
        return points;
    }
    static Pose at(int i) { return poseFrom({-1.4 + 0.4 * i, 0.05 * i, 0.9}, 0, 0, degrees(3) * i); }

    PassingBodies passing;
};

TEST(PassingBodies, WhoWalkedByLeavesNothingInTheMap) {
    RoomWithSomebody room;
    const Eigen::Vector2d somewhere(0.4, 1.6);
    for (int i = 0; i < 7; ++i) (void)room.pass(room.at(i), i == 1 ? std::optional(somewhere) : std::nullopt);
    RoomWithSomebody without;
    for (int i = 0; i < 7; ++i) (void)without.pass(room.at(i), std::nullopt);
    EXPECT_LE(room.pointsAt(somewhere), without.pointsAt(somewhere) + 3);
    ASSERT_THAT(room.mapper.bodiesIn(2), SizeIs(1));
    EXPECT_EQ(room.mapper.bodiesIn(2).front().robot, PassingBodies::Name);
}

TEST(PassingBodies, WhoStaysIsPartOfTheMap) {
    RoomWithSomebody room;
    const Eigen::Vector2d somewhere(0.4, 1.6);
    for (int i = 0; i < 7; ++i) (void)room.pass(room.at(i), somewhere);
    EXPECT_GT(room.pointsAt(somewhere), 100U);
}

TEST(PassingBodies, FurnitureStaysAsItIs) {
    RoomWithSomebody room;
    for (int i = 0; i < 7; ++i) EXPECT_THAT(room.pass(room.at(i), std::nullopt), SizeIs(0)) << i;
}

TEST(PassingBodies, OnlyScansThatHangTogetherSaySomethingOfEachOther) {
    RoomWithSomebody room;
    const Eigen::Vector2d somewhere(0.4, 1.6);
    for (int i = 0; i < 7; ++i) (void)room.pass(room.at(i), i == 1 ? std::optional(somewhere) : std::nullopt);
    const LiveMapPtr map = room.mapper.map();
    PassingBodies alone, all;
    std::size_t found = 0;
    for (const LiveKeyScan& scan : map->scans) {
        EXPECT_THAT(alone.add(*map, scan.id, {scan.id}), SizeIs(0)) << scan.id;
        found += all.add(*map, scan.id, {1, 2, 3, 4, 5, 6, 7}).size();
    }
    EXPECT_EQ(found, 0U) << "what was left out already is not there";
}

}  // namespace
}  // namespace leitstand::test
