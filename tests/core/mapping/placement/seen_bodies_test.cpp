#include "core/mapping/sighting/seen_bodies.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/mapping/placement/laser_robot.h"
#include "tests/core/mapping/live/slices.h"
#include "tests/core/mapping/placement/box_scene.h"
#include "tests/core/mapping/placement/flat_world.h"

namespace leitstand::test {
namespace {

using namespace std::chrono_literals;
using testing::HasSubstr;

const RobotBody Crawler{{{0.20, 0.13}, {-0.20, 0.13}, {-0.20, -0.13}, {0.20, -0.13}}, 0.35};

/// Walls on three sides, the far one 3 m ahead.
BoxScene room() {
    BoxScene scene;
    scene.add({3.05, 0}, 0, 0.1, 6, 1.2);
    scene.add({0, 2.55}, 0, 6, 0.1, 1.2);
    scene.add({0, -2.55}, 0, 6, 0.1, 1.2);
    return scene;
}

void addCrawler(BoxScene& scene, const Eigen::Vector2d& place, double heading) {
    scene.add(place, heading, 0.4, 0.26, 0.2);
}

std::vector<SeenBody> seenIn(const BoxScene& scene, const LocalMap& earlier = {},
                             std::span<const Disc> others = {}) {
    return seenBodies(scene.scan(BoxScene::scanner()), BoxScene::scanner(), Crawler, earlier, others);
}

std::string inWords(const std::vector<SeenBody>& seen) {
    std::string text;
    for (const SeenBody& one : seen) {
        text += "at " + std::to_string(one.middle.x()) + " " + std::to_string(one.middle.y()) + ", top " +
                std::to_string(one.top) + ", " + std::to_string(one.points.size()) + " points\n";
    }
    return text;
}

TEST(SeenBodies, ABoxBesideAWallIsSeen) {
    EXPECT_TRUE(seenIn(room()).empty()) << "walls and floor are none";
    for (const double heading : {0.0, 40.0, 90.0}) {
        BoxScene scene = room();
        const Eigen::Vector2d there(2.0, 2.25);
        addCrawler(scene, there, degrees(heading));
        const std::vector<SeenBody> seen = seenIn(scene);
        ASSERT_EQ(seen.size(), 1u) << heading;
        EXPECT_LT((seen[0].middle - there).norm(), 0.15) << heading;
        EXPECT_NEAR(seen[0].ground, BoxScene::Floor, 0.03);
        EXPECT_NEAR(seen[0].top, 0.19, 0.05);
        EXPECT_FALSE(seen[0].fresh) << "there is no earlier map";
        EXPECT_GT(shareWithin(seen[0], Crawler, poseFrom({2.0, 2.25, -0.5}, 0, 0, degrees(heading)), 0.05),
                  0.9);
        EXPECT_LT(shareWithin(seen[0], Crawler, poseFrom({2.0, 1.5, -0.5}, 0, 0, 0), 0.05), 0.1);
    }
}

TEST(SeenBodies, WhatIsLargerTallerLowerOrAnotherRobotIsNone) {
    BoxScene scene = room();
    scene.add({2, 1}, 2.0, 1.6, 0.4, 0.25);    // lies there, as long as a person
    scene.add({1.5, -1.2}, 0, 0.3, 0.3, 0.9);  // stands there
    scene.add({-1.5, 1}, 0, 0.4, 0.3, 0.05);   // to be driven over
    EXPECT_TRUE(seenIn(scene).empty()) << inWords(seenIn(scene));
    addCrawler(scene, {-1.5, -1}, 0.5);
    EXPECT_EQ(seenIn(scene).size(), 1u);
    const std::vector<Disc> known = {{{-1.5, -1}, 0.35}};
    EXPECT_TRUE(seenIn(scene, {}, known).empty());
}

TEST(SeenBodies, BesideSomethingLowItIsToldByWhatTheMapHadBefore) {
    BoxScene scene = room();
    scene.add({2.0, 0.0}, 0, 0.5, 2.0, 0.25);
    const LocalMap earlier = scene.map(BoxScene::scanner());
    const Eigen::Vector2d there(1.6, 0.3);
    addCrawler(scene, there, degrees(90));
    EXPECT_TRUE(seenIn(scene).empty()) << "both hang together";
    const std::vector<SeenBody> seen = seenIn(scene, earlier);
    ASSERT_EQ(seen.size(), 1u);
    EXPECT_TRUE(seen[0].fresh);
    EXPECT_LT((seen[0].middle - there).norm(), 0.2);
}

TEST(SeenBodies, WhatIsNewComesFirstAndBrokenInputIsNothing) {
    BoxScene scene = room();
    addCrawler(scene, {1.5, 0.8}, 0.3);
    const LocalMap earlier = scene.map(BoxScene::scanner());
    addCrawler(scene, {-2.0, -0.8}, 1.3);
    const std::vector<SeenBody> seen = seenIn(scene, earlier);
    ASSERT_EQ(seen.size(), 2u);
    EXPECT_TRUE(seen[0].fresh);
    EXPECT_LT((seen[0].middle - Eigen::Vector2d(-2.0, -0.8)).norm(), 0.15);
    EXPECT_FALSE(seen[1].fresh);

    Scan broken;
    EXPECT_TRUE(seenBodies(broken, Pose::Identity(), Crawler, {}).empty());
    broken.points = {Eigen::Vector3f::Constant(std::numeric_limits<float>::quiet_NaN()),
                     Eigen::Vector3f(1e30F, 0, 0), Eigen::Vector3f(1, 1, -3e38F)};
    EXPECT_TRUE(seenBodies(broken, Pose::Identity(), Crawler, {}).empty());
    EXPECT_TRUE(seenBodies(scene.scan(BoxScene::scanner()), BoxScene::scanner(), {}, {}).empty());
}

/// A robot with a laser in the nook, whose start is not beside the other one.
struct Sought {
    FlatWorld world = FlatWorld::nook();
    Pose there = FlatWorld::at(0.1, -0.4, degrees(20));
    RobotTracker tracker{"crawler"};
    LaserRobot robot{tracker, "station"};
    LiveMapPtr map;
    Time now{1000s};

    Sought() {
        LiveKeyScan scan;
        scan.id = 1;
        scan.reduced = std::make_shared<const MatchedCloud>(world.map().cloud);
        auto live = std::make_shared<LiveMap>();
        live->scans.push_back(scan);
        map = live;
        for (int i = 0; i < 20; ++i) tracker.add(odometryAt(now + i * 50ms, Pose::Identity()), now);
        now += 900ms;
        (void)robot.see(world.view(there, now), map, now);
    }
    /// A body at @p place, seen from one side.
    [[nodiscard]] SeenBody bodyAt(const Pose& place) const {
        SeenBody body;
        for (double x = -0.2; x < 0.2; x += 0.04) {
            const Eigen::Vector3d point = place * Eigen::Vector3d(x, -0.1, 0);
            body.points.emplace_back(point.head<2>());
            body.middle += point.head<2>() / 10.0;
        }
        body.ground = FlatWorld::at(0, 0, 0).translation().z();
        body.top = 0.2;
        return body;
    }
    std::optional<RobotPlaceSample> beside() {
        return robot.placeBeside(FlatWorld::at(5.0, 5.0, 0), map, now);
    }
    std::optional<RobotPlaceSample> seen(const std::vector<SeenBody>& bodies) {
        return robot.placeSeen(bodies, Crawler, "Kurt3D", map, now);
    }
};

TEST(SeenRobot, OfTwoThingsThatLookLikeItTheOneWhereItsLaserFitsIsIt) {
    Sought sought;
    const SeenBody itself = sought.bodyAt(sought.there),
                   other = sought.bodyAt(FlatWorld::at(1.6, -0.8, degrees(90)));
    EXPECT_FALSE(sought.seen({other, itself})) << "beside the other robot comes first";
    EXPECT_FALSE(sought.beside());
    const auto place = sought.seen({other, itself});
    ASSERT_TRUE(place);
    EXPECT_EQ(place->cause, RobotPlaceSample::Cause::Seen);
    EXPECT_TRUE(place->certain);
    EXPECT_LT(distanceBetween(place->baseInMap, sought.there), 0.04);
    EXPECT_LT(inDegrees(angleBetween(place->baseInMap, sought.there)), 2.0);
    EXPECT_THAT(place->how, HasSubstr("seen_by robot=Kurt3D"));
    EXPECT_TRUE(sought.tracker.now().certain);
    EXPECT_FALSE(sought.seen({itself})) << "it is known now";
}

TEST(SeenRobot, AVictimThatIsAsLargeIsNotTakenForIt) {
    Sought sought;
    EXPECT_FALSE(sought.beside());
    EXPECT_FALSE(sought.seen({}));
    EXPECT_FALSE(sought.seen({sought.bodyAt(FlatWorld::at(1.6, -0.8, degrees(90)))})) << "elsewhere";
    EXPECT_FALSE(sought.seen({sought.bodyAt(sought.there * poseFrom({0.1, 0.45, 0}, 0, 0, 0))}))
        << "the laser would fit, but what is seen would stand beside the robot";
    EXPECT_FALSE(sought.tracker.placed()) << "nothing is claimed";
}

TEST(SeenRobot, WhatTheOperatorPutWaitsForItsLaserAndALostRobotIsLookedForAgain) {
    Sought sought;
    const std::vector<SeenBody> seen = {sought.bodyAt(sought.there)};
    const RobotPlaceSample put = sought.robot.place(FlatWorld::at(1.7, 0.0, 0), sought.map, sought.now);
    ASSERT_FALSE(put.certain);
    EXPECT_FALSE(sought.seen(seen)) << "the operator knows better";
    EXPECT_TRUE(sought.robot.place(sought.there, sought.map, sought.now).certain);
    EXPECT_FALSE(sought.seen(seen)) << "its place is known";

    Sought again;
    RobotPlaceSample earlier;
    earlier.measured = again.now;
    earlier.baseInMap = earlier.odomInMap = FlatWorld::at(-5, -5, 0);
    again.robot.restore(earlier);
    EXPECT_FALSE(again.seen(seen)) << "first where it was";
    const auto resumed = again.robot.see(again.world.view(again.there, again.now), again.map, again.now);
    ASSERT_TRUE(resumed);
    ASSERT_FALSE(resumed->certain);
    const auto found = again.seen(seen);
    ASSERT_TRUE(found);
    EXPECT_LT(distanceBetween(found->baseInMap, again.there), 0.04);
}

}  // namespace
}  // namespace leitstand::test
