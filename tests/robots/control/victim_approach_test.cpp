#include "robots/control/driving/victim_approach.h"

#include <cmath>
#include <functional>

#include <gtest/gtest.h>

#include "core/event/picture_samples.h"
#include "tests/robots/control/test_ground.h"

namespace leitstand::test {
namespace {

/// A room of 8 m by 6 m with a pillar and a victim, obstacle number 5.
std::vector<Obstacle> room(const Eigen::Vector2d& victim) {
    return {{{0, 0}, {8, 0}}, {{8, 0}, {8, 6}},          {{8, 6}, {0, 6}},
            {{0, 6}, {0, 0}}, {{4.2, 3}, {4.2, 3}, 0.2}, {victim, victim, 0.22, 0.35}};
}

/// What the thermal camera sees: on a pan-tilt unit that looks ahead, +-@p half wide.
std::optional<HeatCue> cueOf(const TestGround& ground, std::mt19937& random, double half) {
    std::normal_distribution<double> noise(0.0, degrees(0.5));
    const Pose& base = ground.baseInGround();
    const Obstacle& victim = ground.obstacles[5];
    const Eigen::Vector3d camera = base * Eigen::Vector3d(0.15, -0.15, 0.5);
    const Eigen::Vector2d off = victim.a - camera.head<2>();
    const double direction = std::atan2(off.y(), off.x());
    const Eigen::Vector3d seen = base.linear().transpose() * Eigen::Vector3d(off.x(), off.y(), 0.0);
    if (std::abs(std::atan2(seen.y(), seen.x())) > half) return std::nullopt;
    if (ground.cast(camera.head<2>(), direction).second != 5) return std::nullopt;
    const double distance = off.norm();
    // The camera stands where it stands in odometry, and looks as much aside.
    const Eigen::Vector3d inBase = Eigen::Vector3d(seen.x(), seen.y(), -0.35);
    const Eigen::Vector3d inOdom =
        ground.baseInOdom().linear() *
        (Eigen::AngleAxisd(noise(random), Eigen::Vector3d::UnitZ()) * inBase).normalized();
    return HeatCue{ground.now(),
                   {ground.baseInOdom() * Eigen::Vector3d(0.15, -0.15, 0.5), inOdom},
                   2.0 * std::asin(std::min(1.0, 0.2 / distance)),
                   33.0,
                   0.8};
}

TEST(VictimApproach, StopsEightyCentimetresInFrontFromTwentyStarts) {
    std::mt19937 random(11);
    std::uniform_real_distribution<double> x(0.8, 7.2), y(0.8, 5.2), yaw(-3.1, 3.1);
    int good = 0;
    double worst = 0.0, longest = 0.0;
    for (int run = 0; run < 20;) {
        const Eigen::Vector2d victim(x(random), y(random)), start(x(random), y(random));
        TestGround ground(room(victim), static_cast<unsigned>(run + 1));
        if ((victim - start).norm() < 1.2 || (victim - Eigen::Vector2d(4.2, 3)).norm() < 1.0) continue;
        if ((start - Eigen::Vector2d(4.2, 3)).norm() < 0.8) continue;
        ground.place(start.x(), start.y(), yaw(random));
        while (ground.seconds() < 3.0) ground.step({});
        auto cue = cueOf(ground, random, 3.2);
        if (!cue) continue;
        ++run;
        VictimApproach approach(shippedDrive());
        EXPECT_TRUE(approach.isNew(*cue, ground.view(), ground.baseInOdom()));
        approach.start(*cue, ground.now());
        ApproachStep step;
        while (ground.seconds() < 120.0 && !step.done && !step.failed) {
            // While it turns, the pan-tilt unit follows.
            if (auto next = cueOf(ground, random, degrees(100))) cue = next;
            step = approach.step(cue, ground.view(), ground.baseInOdom(), ground.now());
            ground.step(step.velocity);
        }
        for (int i = 0; i < 20; ++i) ground.step({});
        const double distance = ground.fromFront(5);
        EXPECT_TRUE(step.done) << run << ": " << step.reason;
        EXPECT_NEAR(distance, 0.80, 0.05) << run << ": " << step.reason;
        EXPECT_EQ(ground.touches(), 0) << run;
        worst = std::max(worst, std::abs(distance - 0.8));
        longest = std::max(longest, ground.seconds());
        if (step.done && std::abs(distance - 0.8) <= 0.05) ++good;
        if (!step.done) continue;
        ASSERT_EQ(approach.sightings().size(), 1U);
        const Sighting& sighting = approach.sightings().front();
        EXPECT_EQ(sighting.kind, "victim");
        const Eigen::Vector3d offset =
            ground.baseInGround().inverse() * Eigen::Vector3d(victim.x(), victim.y(), 0);
        const Eigen::Vector3d found = ground.baseInOdom().inverse() * sighting.position;
        EXPECT_LT((found - offset).head<2>().norm(), 0.4);
        EXPECT_FALSE(approach.isNew(*cue, ground.view(), ground.baseInOdom())) << "it is reported once";
    }
    std::printf("%d of 20 within 5 cm, worst %.1f cm, longest %.0f s\n", good, 100.0 * worst, longest);
    EXPECT_EQ(good, 20);
}

TEST(VictimApproach, StandsAndTellsWhenTheHeatIsLost) {
    TestGround ground(room({7.0, 3.0}));
    ground.place(5.0, 1.5, 0.3);
    std::mt19937 random(1);
    while (ground.seconds() < 3.0) ground.step({});
    const auto cue = cueOf(ground, random, 3.2);
    ASSERT_TRUE(cue);
    VictimApproach approach(shippedDrive());
    approach.start(*cue, ground.now());
    ground.obstacles[5] = {{7.9, 0.1}, {7.9, 0.1}};  // it crawled away
    ApproachStep step;
    while (ground.seconds() < 20.0 && !step.failed) {
        step = approach.step(std::nullopt, ground.view(), ground.baseInOdom(), ground.now());
        ground.step(step.velocity);
    }
    EXPECT_TRUE(step.failed);
    EXPECT_LT(ground.seconds(), 9.0);
    EXPECT_EQ(step.reason, "the heat was lost");
    EXPECT_TRUE(isZero(step.velocity));
    EXPECT_FALSE(approach.isActive());
    EXPECT_TRUE(approach.sightings().empty());
    EXPECT_EQ(ground.touches(), 0);
    EXPECT_FALSE(approach.isNew(*cue, ground.view(), ground.baseInOdom())) << "not again at once";
}

TEST(VictimApproach, WaitsInFrontOfTheVictim) {
    TestGround ground(room({7.0, 3.0}));
    ground.place(5.2, 2.8, 0.0);
    std::mt19937 random(1);
    while (ground.seconds() < 3.0) ground.step({});
    VictimApproach approach(shippedDrive());
    approach.start(*cueOf(ground, random, 3.2), ground.now());
    ApproachStep step;
    while (ground.seconds() < 60.0) {
        step = approach.step(cueOf(ground, random, 1.0), ground.view(), ground.baseInOdom(), ground.now());
        ground.step(step.velocity);
    }
    EXPECT_TRUE(step.done);
    EXPECT_TRUE(isZero(step.velocity));
    EXPECT_EQ(approach.sightings().size(), 1U);
    EXPECT_NEAR(ground.fromFront(5), 0.8, 0.05);
    approach.abort();
    EXPECT_FALSE(approach.isActive());
}

// Past the corner of a wall a hand was all that was left in sight; the robot stood there for ever, and
// nobody else could tell what it stood before.
TEST(VictimApproach, WhereOnlyAGlimpseIsLeftItExploresOnAndComesAgainWhenItSeesMore) {
    TestGround ground(room({7.0, 3.0}));
    ground.place(5.2, 2.8, 0.0);
    std::mt19937 random(1);
    while (ground.seconds() < 3.0) ground.step({});
    const auto seen = [&](double size, bool cut = false) {
        auto cue = cueOf(ground, random, 3.2);
        if (cue) cue->size = size, cue->cut = cut;
        return *cue;
    };
    VictimApproach approach(shippedDrive());
    const auto drive = [&](double size, bool cut = false) {
        approach.start(seen(size), ground.now());
        ApproachStep step;
        const double begun = ground.seconds();
        while (ground.seconds() < begun + 60.0 && !step.done && !step.failed) {
            step = approach.step(seen(size, cut), ground.view(), ground.baseInOdom(), ground.now());
            ground.step(step.velocity);
        }
        return step;
    };
    const auto isNew = [&](double size) {
        return approach.isNew(seen(size), ground.view(), ground.baseInOdom());
    };
    const ApproachStep hidden = drive(0.02);
    EXPECT_TRUE(hidden.failed);
    EXPECT_EQ(hidden.reason, "the heat is hidden from here");
    EXPECT_TRUE(approach.sightings().empty());
    EXPECT_FALSE(isNew(0.03)) << "it would see no more of it";
    EXPECT_TRUE(isNew(0.08));
    EXPECT_TRUE(drive(0.02).failed);
    EXPECT_TRUE(isNew(0.08));
    EXPECT_TRUE(drive(0.02).failed);
    EXPECT_FALSE(isNew(0.08)) << "three times are enough";
    VictimApproach another(shippedDrive());
    std::swap(approach, another);
    EXPECT_TRUE(drive(0.02, true).done) << "the rest of it is beyond the picture's border";
    EXPECT_EQ(approach.sightings().size(), 1U);
}

TEST(VictimApproach, WhatIsBareIsALampAndNotApproachedAgainButAVictimBesideItIs) {
    TestGround ground(room({7.0, 3.0}));
    ground.place(5.2, 2.8, 0.0);
    std::mt19937 random(1);
    while (ground.seconds() < 3.0) ground.step({});
    const auto lamp = [&] {
        HeatCue cue = *cueOf(ground, random, 3.2);
        cue.clothes = 0.0005;
        return cue;
    };
    VictimApproach approach(shippedDrive());
    approach.start(lamp(), ground.now());
    ApproachStep step;
    while (ground.seconds() < 60.0 && !step.done && !step.failed) {
        step = approach.step(lamp(), ground.view(), ground.baseInOdom(), ground.now());
        ground.step(step.velocity);
    }
    EXPECT_TRUE(step.failed);
    EXPECT_EQ(step.reason, "warm, but no person: no clothes beside the heat");
    EXPECT_TRUE(approach.sightings().empty());
    EXPECT_FALSE(approach.isNew(lamp(), ground.view(), ground.baseInOdom()));
    ground.obstacles[5] = {{7.0, 3.85}, {7.0, 3.85}, 0.22, 0.35};
    const double begun = ground.seconds();
    while (ground.seconds() < begun + 15.0) ground.step({});
    EXPECT_TRUE(approach.isNew(*cueOf(ground, random, 3.2), ground.view(), ground.baseInOdom()))
        << "a victim beside it";
}

/// What becomes of it before a victim that looks like that, @p i pictures after the first.
ApproachStep stepsBefore(const std::function<std::optional<HeatCue>(int i, const HeatCue& cue)>& look) {
    TestGround ground(room({7.0, 3.0}));
    ground.place(5.2, 2.8, 0.0);
    std::mt19937 random(1);
    while (ground.seconds() < 3.0) ground.step({});
    VictimApproach approach(shippedDrive());
    approach.start(look(0, *cueOf(ground, random, 3.2)).value(), ground.now());
    ApproachStep step;
    std::optional<HeatCue> newest;
    for (int i = 1; ground.seconds() < 60.0 && !step.done && !step.failed; ++i) {
        if (const auto cue = look(i, *cueOf(ground, random, 3.2))) newest = cue;
        step = approach.step(newest, ground.view(), ground.baseInOdom(), ground.now());
        ground.step(step.velocity);
    }
    return step;
}

// On a thin link the infrared camera sends one picture a second.
TEST(VictimApproach, ALampIsOneAlsoWherePicturesComeSlowly) {
    const ApproachStep step = stepsBefore([](int i, HeatCue cue) -> std::optional<HeatCue> {
        cue.clothes = 0.0005;
        if (i % 20 != 0) return std::nullopt;
        return cue;
    });
    EXPECT_TRUE(step.failed) << step.reason;
    EXPECT_EQ(step.reason, "warm, but no person: no clothes beside the heat");
}

// A sleeve hides behind the waving arm now and then, or is below the picture.
TEST(VictimApproach, AVictimWhoseClothesAreSeenNowAndThenOrGoOnBeyondThePictureIsOne) {
    EXPECT_TRUE(stepsBefore([](int i, HeatCue cue) {
                    cue.clothes = i % 10 == 0 ? 0.01 : 0.001;
                    return std::optional(cue);
                }).done);
    EXPECT_TRUE(stepsBefore([](int, HeatCue cue) {
                    cue.clothes = 0.001;
                    cue.clothesCut = true;
                    return std::optional(cue);
                }).done);
}

TEST(VictimApproach, WhatIsLargeAndBareIsAHeaterAlsoWhereThePictureCutsIt) {
    const auto bare = [](double size) {
        return stepsBefore([size](int, HeatCue cue) {
            cue.clothes = 0.0;
            cue.size = size;
            cue.cut = true;
            return std::optional(cue);
        });
    };
    EXPECT_EQ(bare(0.3).reason, "warm, but no person: no clothes beside the heat");
    EXPECT_TRUE(bare(0.1).done) << "a face whose clothes are beyond the picture";
}

// It reported what it had seen on its way, of something else.
TEST(VictimApproach, WhatItDoesNotSeeFromWhereItStandsItDoesNotReport) {
    const ApproachStep step = stepsBefore([](int i, HeatCue cue) -> std::optional<HeatCue> {
        if (i > 8) return std::nullopt;
        return cue;
    });
    EXPECT_TRUE(step.failed) << step.reason;
    EXPECT_EQ(step.reason, "the heat was lost");
}

// Hemmed in between a victim and a wall it stood for a minute and a half, and then left without a word.
TEST(VictimApproach, WhereItCannotBackOffItReportsFromWhereItStands) {
    TestGround ground(room({3.0, 1.0}));
    ground.obstacles.push_back({{1.9, 0.2}, {1.9, 1.8}});
    ground.place(2.2, 1.0, 0.0);
    std::mt19937 random(1);
    while (ground.seconds() < 3.0) ground.step({});
    VictimApproach approach(shippedDrive());
    approach.start(*cueOf(ground, random, 3.2), ground.now());
    ApproachStep step;
    while (ground.seconds() < 40.0 && !step.done && !step.failed) {
        step = approach.step(cueOf(ground, random, 1.5), ground.view(), ground.baseInOdom(), ground.now());
        ground.step(step.velocity);
    }
    EXPECT_TRUE(step.done) << step.reason;
    EXPECT_LT(ground.fromFront(5), 0.6);
    EXPECT_EQ(approach.sightings().size(), 1U);
    EXPECT_EQ(ground.touches(), 0);
}

// A shelf beside a victim was taken for a part of it: the robot stood before the shelf, and saw no heat.
TEST(VictimApproach, AShelfBesideAVictimIsNoPartOfIt) {
    HeatCue cue;
    cue.ray = {{0.15, 0.0, 0.36}, Eigen::Vector3d(2.0, 0.0, -0.26).normalized()};
    cue.width = 0.1;
    const auto nearest = [&](double bottom) {
        VirtualScanView view;
        view.obstacles = {{{2.15, 0.05}, 0.0, 0.2, 0.06}, {{2.15, -0.05}, 0.0, 0.2, 0.06}};
        for (int i = 1; i < 6; ++i)
            view.obstacles.push_back({{2.15 - 0.15 * i, 0.15 * i}, 0.0, 0.47, bottom});
        return heatTarget(cue, view, Pose::Identity(), TestGround::body()).value().inBase;
    };
    EXPECT_NEAR(nearest(0.44).x(), 2.15, 1e-9);
    EXPECT_NEAR(nearest(0.05).x(), 1.4, 1e-9) << "a low box, or a leg";
}

TEST(VictimApproach, CuesAreTheBodiesInAPicture) {
    CameraInfoSample camera;
    camera.width = 160;
    camera.height = 120;
    camera.intrinsics = {220, 0, 79.5, 0, 220, 59.5, 0, 0, 1};
    HeatBlob lamp, body;
    lamp.kind = HeatBlob::Kind::Lamp;
    body.kind = HeatBlob::Kind::Body;
    body.centre = {80.0, 60.0};
    body.width = 0.1;
    body.size = 0.05;
    body.cut = true;
    body.mean = 32.0;
    const Pose optical = opticalFrame(poseFrom({1.0, 2.0, 0.5}, 0.0, 0.0, degrees(90)));
    ThermalPicture picture{160, 120, std::vector<float>(160 * 120, 20.0F)};
    EXPECT_TRUE(cuesFrom({lamp}, picture, camera, optical, Time{}).empty());
    const auto cues = cuesFrom({lamp, body}, picture, camera, optical, Time{});
    ASSERT_EQ(cues.size(), 1U);
    EXPECT_TRUE(cues[0].ray.direction.isApprox(Eigen::Vector3d::UnitY(), 1e-9));
    EXPECT_DOUBLE_EQ(cues[0].temperature, 32.0);
    EXPECT_DOUBLE_EQ(cues[0].size, 0.05);
    EXPECT_TRUE(cues[0].cut);
    EXPECT_DOUBLE_EQ(cues[0].clothes, 0.0);
    // A sleeve beside a hand: 20 by 40 pixels of 4.5 mrad each.
    body.left = 78, body.right = 83, body.top = 55, body.bottom = 64;
    body.pixels = 60;
    body.size = std::sqrt(60.0) / 220.0;
    for (int y = 50; y < 70; ++y) {
        for (int x = 78; x < 124; ++x) picture.celsius[static_cast<std::size_t>(160 * y + x)] = 26.0F;
    }
    for (int y = 55; y < 65; ++y) {
        for (int x = 78; x < 84; ++x) picture.celsius[static_cast<std::size_t>(160 * y + x)] = 33.0F;
    }
    const HeatCue sleeve = cuesFrom({body}, picture, camera, optical, Time{})[0];
    EXPECT_NEAR(sleeve.clothes, 0.016, 0.003);
    EXPECT_FALSE(sleeve.clothesCut);
    for (int x = 78; x < 160; ++x) picture.celsius[static_cast<std::size_t>(160 * 60 + x)] = 26.0F;
    EXPECT_TRUE(cuesFrom({body}, picture, camera, optical, Time{})[0].clothesCut);
}

TEST(VictimApproach, PassesByPeopleBeyondWallsAndFindsTheNewOneBesideTheKnown) {
    TestGround ground(room({7.0, 3.0}));
    ground.place(5.2, 2.8, 0.0);
    std::mt19937 random(1);
    while (ground.seconds() < 3.0) ground.step({});
    VictimApproach approach(shippedDrive());
    const HeatCue victim = *cueOf(ground, random, 3.2);
    HeatCue head = victim;  // above the wall behind
    head.ray.direction = Eigen::Vector3d(std::cos(-0.8), std::sin(-0.8), 0.6).normalized();
    HeatCue other = victim;
    other.ray.direction = Eigen::Vector3d(std::cos(-0.8), std::sin(-0.8), 0.0);
    const auto pick = [&](const std::vector<HeatCue>& cues) {
        return approach.pick(cues, ground.view(), ground.baseInOdom());
    };
    EXPECT_FALSE(approach.isNew(head, ground.view(), ground.baseInOdom()));
    EXPECT_TRUE(approach.isNew(other, ground.view(), ground.baseInOdom()));
    EXPECT_FALSE(pick({}));
    ASSERT_TRUE(pick({head, victim}));
    EXPECT_TRUE(pick({head, victim})->ray.direction.isApprox(victim.ray.direction));
    approach.start(victim, ground.now());
    ASSERT_TRUE(pick({other, victim}));
    EXPECT_TRUE(pick({other, victim})->ray.direction.isApprox(victim.ray.direction)) << "stays with it";

    // What it passes by meanwhile it can tell, to come back.
    const auto another = [&](const HeatCue& cue) {
        return approach.another(cue, ground.view(), ground.baseInOdom());
    };
    static_cast<void>(approach.step(victim, ground.view(), ground.baseInOdom(), ground.now()));
    EXPECT_FALSE(another(victim));
    EXPECT_FALSE(another(other)) << "too far away to be sure where it is";
    HeatCue beside = victim;
    beside.ray.direction = Eigen::Vector3d(-1.15, 0.35, 0.0).normalized();
    const auto heat = another(beside);
    ASSERT_TRUE(heat) << "at the pillar behind";
    EXPECT_NEAR((*heat - beside.ray.origin).norm(), 1.0, 0.1);
    beside.clothes = 0.0002;
    EXPECT_FALSE(another(beside)) << "a lamp";
}

}  // namespace
}  // namespace leitstand::test
