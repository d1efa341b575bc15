#include <chrono>
#include <cmath>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "tests/simulation/world/test_arena.h"

namespace leitstand::simulation {
namespace {

Element element(ElementKind kind, const std::string& name, const Eigen::Vector3d& at,
                const Eigen::Vector3d& size) {
    Element made;
    made.kind = kind;
    made.name = name;
    made.pose = poseFrom(at, 0, 0, 0);
    made.size = size;
    return made;
}

/// A floor, and things on it as arena files have them.
Arena with(std::vector<Element> things) {
    Arena arena;
    arena.from = {-5, -5};
    arena.to = {15, 5};
    arena.elements.push_back(element(ElementKind::Floor, "floor", {5, 0, 0}, {20, 10, 0.1}));
    arena.elements.insert(arena.elements.end(), things.begin(), things.end());
    return arena;
}

TEST(Elements, StairsOfAnArenaAreClimbedByTheCrawlerOnly) {
    for (const double riser : {0.08, 0.10}) {
        Element stairs = element(ElementKind::Stairs, "stairs", {1.6, 0, 0}, {1.2, 2, 5 * riser});
        stairs.riser = riser;
        const Element landing = element(ElementKind::Wall, "landing", {3.7, 0, 0}, {3, 2, 5 * riser});
        World world(with({stairs, landing}), /*seed=*/1);
        const int crawler = world.addRobot(crawlerBody(), poseFrom({0, 0.4, 0}, 0, 0, 0));
        const int kurt = world.addRobot(kurt3dBody(), poseFrom({0, -0.4, 0}, 0, 0, 0));
        Driver one(world, crawler), other(world, kurt);
        for (int i = 0; i < 2'400; ++i) {
            one.tick(0.25, 0.25);
            other.tick(0.25, 0.25);
            world.advance(Tick);
        }
        EXPECT_NEAR(world.state(crawler).baseInArena.translation().z(), 5 * riser, 0.005);
        EXPECT_NEAR(world.state(kurt).baseInArena.translation().z(), 0.0, 0.01);
    }
}

TEST(Elements, ARampOfAnArenaTiltsAsItIsSteep) {
    const double angle = degrees(12);
    World world(with({element(ElementKind::Ramp, "ramp", {2, 0, 0}, {3, 2, 3 * std::tan(angle)})}),
                /*seed=*/1);
    const int robot = world.addRobot(kurt3dBody(), Pose::Identity());
    Driver(world, robot).drive(0.3, 0.3, 7.0);
    EXPECT_NEAR(pitchOf(world.state(robot)), -angle, degrees(0.3));
    EXPECT_TRUE(world.bumps().empty());
}

TEST(Elements, VictimsStopRobotsByTheirClothes) {
    for (const BodySpec& spec : {kurt3dBody(), crawlerBody()}) {
        for (const double x : {-0.6, -0.2, 0.2, 0.6}) {  // along the body: legs, trunk, head
            Element victim = element(ElementKind::Victim, "victim 1", {1.5, x, 0}, {1.7, 0.5, 0.3});
            victim.pose = poseFrom({1.5, x, 0}, 0, 0, degrees(90));
            victim.victim = VictimTraits{};
            World world(with({victim}), /*seed=*/1);
            const int robot = world.addRobot(spec, Pose::Identity());
            Driver(world, robot).drive(0.3, 0.3, 6.0);
            EXPECT_LT(world.state(robot).baseInArena.translation().x(), 1.5) << spec.name << " at " << x;
            ASSERT_EQ(world.bumps().size(), 1U) << spec.name << " at " << x;
            EXPECT_TRUE(world.bumps()[0].victim);
            EXPECT_EQ(world.bumps()[0].element, "victim 1");
        }
    }
}

TEST(Elements, TheBoxAroundAVictimIsNotTheVictim) {
    Element victim = element(ElementKind::Victim, "victim 2", {1.5, 0, 0}, {1.7, 0.5, 0.3});
    victim.victim = VictimTraits{};
    victim.victim->situation = Situation::Entombed;
    World world(with({victim}), /*seed=*/1);
    const int robot = world.addRobot(kurt3dBody(), Pose::Identity());
    Driver(world, robot).drive(0.3, 0.3, 6.0);
    ASSERT_EQ(world.bumps().size(), 1U);
    EXPECT_FALSE(world.bumps()[0].victim);
    EXPECT_EQ(world.bumps()[0].element, "victim 2");
}

TEST(Elements, CurtainsAndPaperAreDrivenThroughWallsAreNot) {
    Element curtain = element(ElementKind::Curtain, "curtain", {1.0, 0, 0}, {0.05, 2, 1.5});
    Element paper = element(ElementKind::LoosePaper, "paper", {1.6, 0, 0}, {0.4, 0.4, 0.15});
    curtain.material = Material::Cloth;
    paper.material = Material::Paper;
    const Element wall = element(ElementKind::Wall, "wall", {3.0, 0, 0}, {0.05, 2, 1.2});
    World world(with({curtain, paper, wall}), /*seed=*/1);
    const int robot = world.addRobot(kurt3dBody(), Pose::Identity());
    Driver(world, robot).drive(0.3, 0.3, 12.0);
    EXPECT_NEAR(world.state(robot).baseInArena.translation().x(), 2.975 - 0.225, 0.01);
    ASSERT_EQ(world.bumps().size(), 1U);
    EXPECT_EQ(world.bumps()[0].element, "wall");
}

}  // namespace
}  // namespace leitstand::simulation
