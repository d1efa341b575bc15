#include "robots/control/driving/explorer.h"

#include <cmath>
#include <set>

#include <gtest/gtest.h>

#include "tests/robots/control/test_ground.h"

namespace leitstand::test {
namespace {

constexpr double Cell = 1.2;
const std::vector<std::string> Maze = {"+-+-+-+-+-+-+",  //
                                       "|   |       |",  //
                                       "+ + + +-+-+ +",  //
                                       "| |   |   | |",  //
                                       "+ +-+-+ + + +",  //
                                       "|   |   | | |",  //
                                       "+-+ + +-+ + +",  //
                                       "|   |     | |",  //
                                       "+ +-+-+ +-+ +",  //
                                       "|           |",  //
                                       "+-+-+-+-+-+-+"};

/// Which tenths of a metre of the maze's floor (6 x 5 cells, all within reach) the scanner has seen.
class Coverage {
public:
    void add(const TestGround& ground) {
        const Eigen::Vector2d here = ground.baseInGround().translation().head<2>();
        for (const Eigen::Vector3d& ray : ground.rays) {
            const Eigen::Vector2d end = ray.head<2>();
            const double sight = std::min(ray.z(), 4.0);
            for (double along = 0.0; along < sight; along += 0.05)
                mark(here + along / ray.z() * (end - here));
        }
    }
    [[nodiscard]] double share() const { return static_cast<double>(m_seen.size()) / (72.0 * 60.0); }

private:
    void mark(const Eigen::Vector2d& place) {
        const int x = static_cast<int>(std::floor(place.x() * 10)),
                  y = static_cast<int>(std::floor(place.y() * 10));
        if (x >= 0 && x < 72 && y >= 0 && y < 60) m_seen.insert(1000 * x + y);
    }
    std::set<int> m_seen;
};

TEST(Explorer, SeesMostOfAMazeWithoutTouchingIt) {
    for (const unsigned seed : {1U, 2U, 3U}) {
        TestGround ground(maze(Maze, Cell), seed);
        const double starts[3][3] = {{0.6, 0.6, 0.0}, {3.0, 1.8, 1.0}, {6.6, 5.4, -2.0}};
        ground.place(starts[seed - 1][0], starts[seed - 1][1], starts[seed - 1][2]);
        Explorer explorer(shippedDrive());
        Coverage coverage;
        ExplorerStep step;
        double seventy = 0.0;
        while (ground.seconds() < 480.0 && !step.done) {
            step = explorer.step(ground.view(), ground.baseInOdom(), ground.newest(), ground.now());
            ground.step(step.velocity);
            coverage.add(ground);
            if (seventy == 0.0 && coverage.share() > 0.7) seventy = ground.seconds();
        }
        std::printf("seed %u: %.0f %% seen after %.0f s (70 %% after %.0f s), %d touches, ends: %s\n", seed,
                    100.0 * coverage.share(), ground.seconds(), seventy, ground.touches(),
                    step.reason.c_str());
        EXPECT_GT(coverage.share(), 0.85) << seed;
        EXPECT_GT(seventy, 0.0) << seed;
        EXPECT_LT(seventy, 240.0) << seed;
        EXPECT_EQ(ground.touches(), 0) << seed;
    }
}

TEST(Explorer, DrivesToAGoalAroundCorners) {
    TestGround ground(maze(Maze, Cell), 4);
    ground.place(0.6, 0.6, 0.0);
    Explorer explorer(shippedDrive());
    explorer.setGoal(Eigen::Vector3d(6.0, 4.8, 0.0));  // in odom: where it starts is 0, 0
    ExplorerStep step;
    while (ground.seconds() < 200.0 && !step.done && !step.failed) {
        step = explorer.step(ground.view(), ground.baseInOdom(), ground.newest(), ground.now());
        ground.step(step.velocity);
    }
    EXPECT_TRUE(step.done) << step.reason;
    EXPECT_LT((ground.baseInOdom().translation().head<2>() - Eigen::Vector2d(6.0, 4.8)).norm(), 0.3);
    EXPECT_EQ(ground.touches(), 0);
    std::printf("to the goal in %.0f s\n", ground.seconds());
}

TEST(Explorer, ComesOutOfADeadEnd) {
    TestGround ground(maze({"+-+-+-+-+-+-+", "|         | |", "+-+-+-+-+-+ +"}, 1.0));
    ground.place(4.4, 0.5, 0.0);
    Explorer explorer(shippedDrive());
    explorer.setGoal(Eigen::Vector3d(-3.8, 0.0, 0.0));
    ExplorerStep step;
    while (ground.seconds() < 90.0 && !step.done && !step.failed) {
        step = explorer.step(ground.view(), ground.baseInOdom(), ground.newest(), ground.now());
        ground.step(step.velocity);
    }
    EXPECT_TRUE(step.done) << step.reason;
    EXPECT_EQ(ground.touches(), 0);
}

TEST(Explorer, GoesOnWhenWhoStoodInItsWayHasGone) {
    TestGround ground(maze({"+-+-+-+-+-+-+-+-+", "|               |", "+-+-+-+-+-+-+-+-+"}, 1.2));
    ground.place(0.6, 0.6, 0.0);
    ground.obstacles.push_back({{2.0, 0.6}, {2.0, 0.6}, 0.5, 0.5});  // another robot, in a narrow passage
    Explorer explorer(shippedDrive());
    ExplorerStep step;
    const auto passUntil = [&](double seconds) {
        while (ground.seconds() < seconds && !step.done) {
            step = explorer.step(ground.view(), ground.baseInOdom(), ground.newest(), ground.now());
            ground.step(step.velocity);
        }
    };
    passUntil(22.0);
    EXPECT_FALSE(step.done) << "somebody else may go on: " << step.reason;
    EXPECT_LT(ground.baseInGround().translation().x(), 1.4);
    ground.obstacles.pop_back();
    passUntil(60.0);
    EXPECT_GT(ground.baseInGround().translation().x(), 2.4) << step.reason;
    EXPECT_EQ(ground.touches(), 0);
}

TEST(Explorer, SaysWhenThereIsNoWayToTheGoal) {
    TestGround ground(maze({"+-+-+-+", "|   | |", "+-+-+-+"}, 2.0));
    ground.place(1.0, 1.0, 0.0);
    Explorer explorer(shippedDrive());
    explorer.setGoal(Eigen::Vector3d(4.0, 0.0, 0.0));
    ExplorerStep step;
    while (ground.seconds() < 60.0 && !step.done && !step.failed) {
        step = explorer.step(ground.view(), ground.baseInOdom(), ground.newest(), ground.now());
        ground.step(step.velocity);
    }
    EXPECT_TRUE(step.failed) << step.reason;
    EXPECT_TRUE(isZero(step.velocity));
}

TEST(Explorer, StandsWhenTheScannerIsSilentAndWhenAllIsSeen) {
    TestGround ground(maze({"+-+-+", "|   |", "+-+-+"}, 1.5));
    ground.place(0.75, 0.75, 0.0);
    Explorer explorer(shippedDrive());
    ExplorerStep step;
    while (ground.seconds() < 4.0) {
        step = explorer.step(ground.view(), ground.baseInOdom(), ground.newest(), ground.now());
        ground.step(step.velocity);
    }
    ground.scannerRuns = false;
    while (ground.seconds() < 9.0) {
        step = explorer.step(ground.view(), ground.baseInOdom(), ground.newest(), ground.now());
        ground.step(step.velocity);
    }
    EXPECT_TRUE(isZero(step.velocity));
    EXPECT_EQ(step.reason, "the scanner is silent: stands");
    ground.scannerRuns = true;
    while (ground.seconds() < 60.0 && !step.done) {
        step = explorer.step(ground.view(), ground.baseInOdom(), ground.newest(), ground.now());
        ground.step(step.velocity);
    }
    EXPECT_TRUE(step.done);
    EXPECT_EQ(step.reason, "nothing is left to explore");
    EXPECT_EQ(ground.touches(), 0);
}

TEST(FloorMemory, AWayToTheUnseenBeginsAheadWhereTurningCosts) {
    FloorMemorySettings settings;
    settings.around = 0.5;
    FloorMemory memory(settings);
    VirtualScanView view;  // its scanner is blind behind
    view.sectors.resize(180);
    for (int i = 30; i < 150; ++i) {
        const double direction = view.directionOf(i);
        view.sectors[static_cast<std::size_t>(i)].age = 0.1;
        view.sectors[static_cast<std::size_t>(i)].outer =
            Eigen::Vector2d(std::cos(direction), std::sin(direction));
    }
    memory.see(view, Pose::Identity());
    EXPECT_TRUE(memory.isSeen({-0.4, 0.0, 0.0})) << "it stands there";
    EXPECT_FALSE(memory.isSeen({-0.7, 0.0, 0.0}));
    EXPECT_LT(memory.wayToUnseen({0.0, 0.0, 0.0}).front().x(), 0.0) << "nearest by way";
    EXPECT_GT(memory.wayToUnseen({0.0, 0.0, 0.0}, {.heading = 0.0, .cost = 2.0}).front().x(), 0.0);
}

TEST(FloorMemory, RemembersWhatItSawAndWhereItWas) {
    FloorMemory memory;
    VirtualScanView view;
    view.sectors.resize(180);
    for (auto& sector : view.sectors) sector.age = 0.1;
    const int ahead = view.sectorOf(0.01);
    for (int i = ahead - 20; i < ahead + 20; ++i) {
        const double direction = view.directionOf(i);
        const Eigen::Vector2d wall =
            Eigen::Vector2d(std::cos(direction), std::sin(direction)) / std::cos(direction);
        view.sectors[static_cast<std::size_t>(i)].inner = wall;
        view.obstacles.push_back({wall, 0.1});
    }
    memory.see(view, Pose::Identity());
    EXPECT_TRUE(memory.isSeen({0.5, 0.0, 0.0}));
    EXPECT_TRUE(memory.isSeen({-2.5, 0.0, 0.0}));
    EXPECT_TRUE(memory.isBlocked({1.02, 0.0, 0.0}));
    EXPECT_FALSE(memory.isSeen({1.5, 0.0, 0.0})) << "behind the wall";
    EXPECT_FALSE(memory.isSeen({-4.5, 0.0, 0.0})) << "beyond its sight";
    EXPECT_EQ(memory.visits({0.0, 0.0, 0.0}), 1);
    EXPECT_EQ(memory.visits({-2.5, 0.0, 0.0}), 0);
    const auto way = memory.wayToUnseen({0.0, 0.0, 0.0});
    ASSERT_FALSE(way.empty());
    EXPECT_TRUE(memory.isBorderNear(way.back()));
    EXPECT_FALSE(memory.isFreeBetween({0.0, 0.0, 0.0}, {2.0, 0.0, 0.0}));
    EXPECT_TRUE(memory.isFreeBetween({0.0, 0.0, 0.0}, {-2.0, 0.0, 0.0}));
    memory.giveUp(way.back(), 0.3);
    EXPECT_FALSE(memory.isBorderNear(way.back()));

    view.obstacles.clear();  // the wall is gone
    for (auto& sector : view.sectors) sector.inner.reset();
    for (int i = 0; i < 8; ++i) memory.see(view, Pose::Identity());
    EXPECT_FALSE(memory.isBlocked({1.02, 0.0, 0.0}));
    EXPECT_TRUE(memory.isSeen({1.5, 0.0, 0.0}));
}

/// In a corridor along x, 1.2 m wide: its walls in sight at both sides up to 3 m.
VirtualScanView inCorridor() {
    VirtualScanView view;
    view.sectors.resize(180);
    for (int i = 0; i < 180; ++i) {
        VirtualSector& sector = view.sectors[static_cast<std::size_t>(i)];
        const Eigen::Vector2d along(std::cos(view.directionOf(i)), std::sin(view.directionOf(i)));
        sector.age = 0.1;
        if (std::abs(along.y()) < 0.2) continue;  // beyond its sight
        sector.inner = along * (0.6 / std::abs(along.y()));
        view.obstacles.push_back({*sector.inner, 0.1});
    }
    return view;
}

TEST(FloorMemory, StoreysLieAboveEachOther) {
    FloorMemory memory;
    const VirtualScanView view = inCorridor();
    constexpr double Slope = degrees(11.3), Storey = 2.6, RampLength = 13.0, Before = 2.0;
    // A corridor, a ramp at its end, and from its top a corridor beside it back to over where it began.
    const auto on = [](double x, double y, double z, double pitch, double yaw) {
        return poseFrom({x, y, z}, 0.0, pitch, yaw);
    };
    for (double x = 0.0; x < Before; x += 0.1) memory.see(view, on(x, 0.0, 0.0, 0.0, 0.0));
    for (double up = 0.0; up < RampLength; up += 0.1)
        memory.see(view, on(Before + up, 0.0, Storey * up / RampLength, -Slope, 0.0));
    EXPECT_TRUE(memory.isSeen({0.0, 0.0, 0.0}));
    EXPECT_FALSE(memory.isSeen({0.0, 0.0, Storey}));
    EXPECT_TRUE(memory.isBlocked({0.0, 0.62, 0.0}));
    EXPECT_FALSE(FloorMemory().wayTo({0.0, 0.0, 0.0}, {RampLength, 0.0, Storey}).empty())
        << "up a ramp that nobody has seen";
    EXPECT_FALSE(memory.isBlocked({0.0, 0.62, Storey}));

    VirtualScanView open;  // nothing stands up there
    open.sectors.resize(180);
    for (VirtualSector& sector : open.sectors) sector.age = 0.1;
    constexpr double Top = Before + RampLength, Aside = 2.5, Quarter = degrees(90);
    for (double y = 0.0; y < Aside; y += 0.1) memory.see(open, on(Top, y, Storey, 0.0, Quarter));
    for (double x = Top; x > 0.0; x -= 0.1) memory.see(view, on(x, Aside, Storey, 0.0, 2.0 * Quarter));
    for (double y = Aside; y > 0.0; y -= 0.1) memory.see(open, on(0.0, y, Storey, 0.0, -Quarter));
    EXPECT_TRUE(memory.isSeen({0.0, 0.0, Storey}));
    EXPECT_FALSE(memory.isBlocked({0.0, 0.62, Storey}));
    EXPECT_TRUE(memory.isBlocked({0.0, 0.62, 0.0})) << "it was not seen again";
    EXPECT_EQ(memory.visits({0.0, 0.0, 0.0}), 1);

    const auto way = memory.wayTo({0.5, 0.0, Storey}, {0.5, 0.0, 0.0});
    double highest = 0.0, lowest = 10.0, farthest = 0.0;
    for (const Eigen::Vector3d& place : way) {
        highest = std::max(highest, place.z());
        lowest = std::min(lowest, place.z());
        farthest = std::max(farthest, place.x());
    }
    ASSERT_FALSE(way.empty()) << "down the ramp";
    EXPECT_NEAR(highest, Storey, 0.3);
    EXPECT_NEAR(lowest, 0.0, 0.3);
    EXPECT_GT(farthest, Top - 1.0) << "by the ramp's top";
}

}  // namespace
}  // namespace leitstand::test
