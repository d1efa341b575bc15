#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "robots/simulation/arena/random.h"
#include "tests/simulation/drives/driven_world.h"
#include "tests/simulation/drives/rooms.h"

namespace leitstand::simulation::test {
namespace {

const Eigen::Vector2d VictimAt(4.6, 2.9);

/// A room with a victim in the open, a table's width away from a wall that hides it from a part of the floor.
Arena roomWithVictim() {
    Arena arena = room(6.5, 5.0);
    arena.elements.push_back(warmVictim(VictimAt, degrees(115)));
    arena.elements.push_back(wall("screen", {2.6, 1.2}, {2.6, 3.0}));
    return arena;
}

/// The start number @p wanted of an endless list: anywhere on the free floor, turned anyhow, not yet before
/// the victim.
Pose startNumber(int wanted) {
    Random random(2006);
    for (int number = 0;;) {
        const Eigen::Vector2d place(random.between(0.5, 6.0), random.between(0.5, 4.5));
        const double yaw = random.between(-3.14, 3.14);
        const bool atScreen = std::abs(place.x() - 2.6) < 0.5 && place.y() < 3.5 && place.y() > 0.7;
        if ((place - VictimAt).norm() < 1.6 || atScreen) continue;
        if (number++ == wanted) return poseFrom({place.x(), place.y(), 0.0}, 0.0, 0.0, yaw);
    }
}

struct Approached {
    bool stands = false;
    double distance = 0.0, moved = 0.0, off = 0.0, seconds = 0.0;
    std::size_t sightings = 0;
    int bumps = 0;
};

Approached approachFrom(int number) {
    DriveSetup setup;
    setup.seed = static_cast<std::uint64_t>(number) + 1;
    setup.start = startNumber(number);
    DrivenWorld driven(roomWithVictim(), setup);
    driven.pass(0.2);
    driven.ask("explore");
    Approached result;
    const auto isThere = [&] {
        return driven.mode() == DriveMode::VictimApproach && driven.reason().starts_with("stands");
    };
    while (driven.world->seconds() < 240.0 && !isThere()) driven.pass(0.2);
    result.stands = isThere();
    result.seconds = driven.world->seconds();
    result.sightings = driven.sightings.size();
    if (!driven.sightings.empty()) {
        const Eigen::Vector2d place = driven.inArena(driven.sightings.back().position).head<2>();
        result.off = (place - VictimAt).norm();
    }
    driven.pass(0.5);
    const Eigen::Vector2d here = driven.place();
    driven.pass(4.0);  // it waits
    result.moved = (driven.place() - here).norm();
    result.distance = driven.fromFrontTo("victim");
    result.bumps = driven.bumps();
    return result;
}

void expectGood(int number, double& worst) {
    const Approached result = approachFrom(number);
    std::printf("start %2d: %5.1f s, front %.1f cm from the victim, report %.2f m from its middle\n", number,
                result.seconds, 100.0 * result.distance, result.off);
    EXPECT_TRUE(result.stands) << number;
    EXPECT_NEAR(result.distance, 0.80, 0.05) << number;
    EXPECT_EQ(result.sightings, 1U) << number << ": reported once";
    EXPECT_LT(result.off, 0.75) << number;
    EXPECT_LT(result.moved, 0.005) << number << ": it waits";
    EXPECT_EQ(result.bumps, 0) << number;
    worst = std::max(worst, std::abs(result.distance - 0.80));
}

TEST(Approach, StandsEightyCentimetresBeforeTheVictim) {
    double worst = 0.0;
    for (const int number : {4, 19}) expectGood(number, worst);
}

TEST(ApproachLong, StandsEightyCentimetresBeforeTheVictimFromTwentyStarts) {
    double worst = 0.0;
    for (int number = 0; number < 20; ++number) expectGood(number, worst);
    std::printf("worst: %.1f cm off\n", 100.0 * worst);
}

}  // namespace
}  // namespace leitstand::simulation::test
