#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "core/event/picture_samples.h"
#include "core/event/stream_role.h"
#include "core/perception/heat/heat.h"
#include "core/perception/pictures/coding/picture_decoding.h"
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

/// Whether the infrared picture @p sample has a body in its middle half.
bool showsABody(const PictureSample& sample) {
    const auto picture = temperatures(*decodePicture(sample), {});
    if (!picture) return false;
    const auto blobs = findHeat(*picture, {});
    return std::any_of(blobs.begin(), blobs.end(), [&](const HeatBlob& one) {
        return one.kind == HeatBlob::Kind::Body &&
               std::abs(one.centre.x() - 0.5 * picture->width) < 0.25 * picture->width &&
               std::abs(one.centre.y() - 0.5 * picture->height) < 0.25 * picture->height;
    });
}

struct Approached {
    bool stands = false, shown = false;
    double distance = 0.0, moved = 0.0, off = 0.0, seconds = 0.0;
    std::size_t sightings = 0;
    int bumps = 0;
};

Approached approach(const Arena& arena, const Pose& start, int number) {
    DriveSetup setup;
    setup.seed = static_cast<std::uint64_t>(number) + 1;
    setup.start = start;
    DrivenWorld driven(arena, setup);
    PictureSample newest;
    driven.onSample = [&newest](const HardwareSample& one) {
        const auto* picture = one.sample.as<PictureSample>();
        if (picture != nullptr && one.role == StreamRole::Thermal) newest = *picture;
    };
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
        const auto& elements = driven.world->arena().elements;
        const auto victim = std::find_if(elements.begin(), elements.end(),
                                         [](const Element& one) { return one.victim.has_value(); });
        result.off = (place - victim->pose.translation().head<2>()).norm();
    }
    driven.pass(0.5);
    const Eigen::Vector2d here = driven.place();
    driven.pass(4.0);  // it waits
    result.moved = (driven.place() - here).norm();
    result.shown = showsABody(newest);
    result.distance = driven.fromFrontTo("victim");
    result.bumps = driven.bumps();
    return result;
}

void expectGood(const Approached& result, int number, double& worst) {
    std::printf("start %2d: %5.1f s, front %.1f cm from the victim, report %.2f m from its middle\n", number,
                result.seconds, 100.0 * result.distance, result.off);
    EXPECT_TRUE(result.stands) << number;
    EXPECT_NEAR(result.distance, 0.80, 0.05) << number;
    EXPECT_EQ(result.sightings, 1U) << number << ": reported once";
    EXPECT_LT(result.off, 0.75) << number;
    EXPECT_LT(result.moved, 0.005) << number << ": it waits";
    EXPECT_TRUE(result.shown) << number << ": its camera shows what it stands before";
    EXPECT_EQ(result.bumps, 0) << number;
    worst = std::max(worst, std::abs(result.distance - 0.80));
}

TEST(Approach, StandsEightyCentimetresBeforeTheVictim) {
    double worst = 0.0;
    for (const int number : {4, 19})
        expectGood(approach(roomWithVictim(), startNumber(number), number), number, worst);
}

// It stood before the shelf, and its camera looked past the victim.
TEST(Approach, AShelfBesideTheVictimIsNoPartOfIt) {
    Arena arena = room(6.5, 5.0);
    arena.elements.push_back(warmVictim({2.2, 4.785}, 0.0));
    Element shelf = elementOf(ElementKind::Overhang);
    shelf.name = "shelf";
    shelf.size = {0.75, 0.34, 0.03};
    shelf.pose = poseFrom({3.455, 4.805, 0.437}, 0.0, 0.0, 0.0);
    arena.elements.push_back(shelf);
    double worst = 0.0;
    expectGood(approach(arena, poseFrom({4.85, 4.08, 0.0}, 0.0, 0.0, degrees(116)), 7), 7, worst);
}

TEST(Approach, AHeaterThatLooksAsWarmAsSkinIsLeft) {
    Arena arena = room(5.0, 4.0);
    Element heater = elementOf(ElementKind::Heater);
    heater.name = "heater";
    heater.size = {0.5, 0.1, 0.5};
    heater.temperature = 57.0;  // of bright metal
    heater.pose = poseFrom({4.85, 2.0, 0.0}, 0.0, 0.0, degrees(90));
    arena.elements.push_back(heater);
    DrivenWorld driven(arena, {});
    driven.pass(0.2);
    driven.ask("explore");
    driven.pass(60.0);
    EXPECT_TRUE(driven.sightings.empty());
    EXPECT_EQ(std::count_if(driven.modes.begin(), driven.modes.end(),
                            [](const ModeSample& one) {
                                return one.reason == "warm, but no person: no clothes beside the heat";
                            }),
              1)
        << "it went there, once";
}

TEST(ApproachLong, StandsEightyCentimetresBeforeTheVictimFromTwentyStarts) {
    double worst = 0.0;
    for (int number = 0; number < 20; ++number)
        expectGood(approach(roomWithVictim(), startNumber(number), number), number, worst);
    std::printf("worst: %.1f cm off\n", 100.0 * worst);
}

}  // namespace
}  // namespace leitstand::simulation::test
