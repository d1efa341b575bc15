#include "core/station/sight_cap.h"

#include <array>
#include <cmath>
#include <string>

#include <gtest/gtest.h>

#include "core/base/pose.h"
#include "core/perception/pictures/picture_watch.h"
#include "core/robot/control/drive_setpoint.h"
#include "tests/core/robot/control_scene.h"

namespace leitstand::test {
namespace {

constexpr double Never = std::numeric_limits<double>::infinity();

SightAges sees(double arrival, double content, double scan = Never, double ahead = Never) {
    return {true, true, {arrival, content}, scan, ahead};
}

TEST(SightCap, CaseByCase) {
    struct Case {
        const char* what;
        SightAges ages;
        double factor;
        SightReason reason;
    };
    const SightAges cameraOnly{true, false, {0.1, 0.1}, Never, Never};
    SightAges scannerOnly{false, true, {}, 0.1, 1.2}, noEyes;
    SightAges scannerOld = scannerOnly, scannerAside = scannerOnly;
    scannerOld.scan = 1.5;
    scannerAside.ahead = Never;
    const Case cases[] = {
        {"fresh picture", sees(0.1, 0.1), 1.0, SightReason::Fresh},
        {"just fresh", sees(0.299, 0.299), 1.0, SightReason::Fresh},
        {"a gap", sees(0.3, 0.3), 0.2, SightReason::OldPicture},
        {"a long gap", sees(0.99, 0.99), 0.2, SightReason::OldPicture},
        {"no more pictures", sees(1.0, 1.0), 0.0, SightReason::OldPicture},
        {"frozen, restamped", sees(0.05, 0.5), 0.2, SightReason::FrozenPicture},
        {"frozen for long", sees(0.05, 3.0), 0.0, SightReason::FrozenPicture},
        {"never a picture", sees(Never, Never), 0.0, SightReason::NoPicture},
        {"the scan is eyes", sees(Never, Never, 0.1, 1.0), 1.0, SightReason::ScanAlone},
        {"frozen, but a scan", sees(0.1, 9.0, 0.1, 2.5), 1.0, SightReason::ScanAlone},
        {"the scan looked elsewhere", sees(5.0, 5.0, 0.1, 3.0), 0.0, SightReason::OldPicture},
        {"the scan's stream has gaps", sees(5.0, 5.0, 0.5, 1.0), 0.2, SightReason::ScanAlone},
        {"all silent", sees(5.0, 5.0, 5.0, 5.0), 0.0, SightReason::OldPicture},
        {"camera alone", cameraOnly, 1.0, SightReason::Fresh},
        {"scanner alone", scannerOnly, 1.0, SightReason::Fresh},
        {"scanner alone, old", scannerOld, 0.0, SightReason::OldScan},
        {"scanner alone, not that way", scannerAside, 0.0, SightReason::OldScan},
        {"neither", noEyes, 1.0, SightReason::NoEyes},
    };
    for (const Case& one : cases) {
        const SightCap cap = sightCap(one.ages, false);
        EXPECT_DOUBLE_EQ(cap.factor, one.factor) << one.what;
        EXPECT_EQ(cap.reason, one.reason) << one.what;
        EXPECT_FALSE(cap.overridden) << one.what;
        const SightCap overridden = sightCap(one.ages, true);
        EXPECT_DOUBLE_EQ(overridden.factor, 1.0) << one.what;
        EXPECT_EQ(overridden.reason, one.reason) << "it is still said why: " << one.what;
        EXPECT_TRUE(overridden.overridden) << one.what;
    }
    EXPECT_DOUBLE_EQ(sightCap(sees(0.05, 3.0), false).age, 3.0);
    EXPECT_TRUE(sightCap(sees(5.0, 5.0), true).isBlind());
    EXPECT_FALSE(sightCap(sees(0.1, 0.1), true).isBlind());
}

TEST(SightCap, SlowerSticksStayAsTheyAreAndDirectionsAreKept) {
    const DriveLimits limits{0.5, 1.0, false};
    SightCap creep;
    creep.factor = 0.2;
    EXPECT_EQ(capped({0.05, 0.0, 0.1}, creep, limits), (DriveVelocity{0.05, 0.0, 0.1}));
    EXPECT_EQ(capped({-0.5, 0.0, 0.0}, creep, limits), (DriveVelocity{-0.1, 0.0, 0.0}));
    EXPECT_EQ(capped({0.0, 0.0, 1.0}, creep, limits), (DriveVelocity{0.0, 0.0, 0.2}));
    for (const double none : {0.0, -1.0, std::nan("")}) {
        creep.factor = none;
        EXPECT_TRUE(isZero(capped({0.5, 0.0, 1.0}, creep, limits))) << none;
    }
}

TEST(SightCap, TheScanIsAskedWhereTheMotionLeads) {
    VirtualScanView view;
    view.sectors.resize(360);
    for (int i = 0; i < 360; ++i)
        view.sectors[static_cast<std::size_t>(i)].age =
            std::abs(view.directionOf(i)) < degrees(100) ? 0.5 : 9.0;
    EXPECT_DOUBLE_EQ(scanAgeAlong(view, {0.3, 0.0, 0.0}), 0.5);
    EXPECT_DOUBLE_EQ(scanAgeAlong(view, {}), 0.5) << "who stands asks for the way ahead";
    EXPECT_DOUBLE_EQ(scanAgeAlong(view, {-0.3, 0.0, 0.4}), 9.0);
    EXPECT_DOUBLE_EQ(scanAgeAlong(view, {0.0, 0.0, 0.4}), 0.5) << "on the spot: the half ahead";
    EXPECT_DOUBLE_EQ(scanAgeAlong(view, {-0.3, 0.3, 0.0}), 9.0) << "sideways, to the back left";
    for (int i = 178; i < 182; ++i) view.sectors[static_cast<std::size_t>(i)].age = Never;
    EXPECT_DOUBLE_EQ(scanAgeAlong(view, {0.3, 0.0, 0.0}), 0.5) << "a post of its own hides little";
    EXPECT_EQ(scanAgeAlong(VirtualScanView{}, {0.3, 0.0, 0.0}), Never);
    view.sectors.resize(4);
    EXPECT_GE(scanAgeAlong(view, {0.3, 0.0, 0.0}), 0.5) << "few sectors";
}

TEST(PictureWatch, FindsOutADriverThatRestampsOnePicture) {
    const std::array<std::byte, 3> one{std::byte{1}, std::byte{2}, std::byte{3}},
        other{std::byte{1}, std::byte{2}, std::byte{4}};
    PictureWatch watch;
    EXPECT_EQ(watch.at(at(0)).seconds(), Never);
    watch.arrived(one, at(0));
    watch.arrived(other, at(100));
    EXPECT_NEAR(watch.at(at(150)).seconds(), 0.05, 1e-9);
    for (int i = 2; i <= 20; ++i) watch.arrived(other, at(100 * i));
    EXPECT_NEAR(watch.at(at(2'050)).arrival, 0.05, 1e-9);
    EXPECT_NEAR(watch.at(at(2'050)).content, 1.95, 1e-9);
    EXPECT_TRUE(watch.at(at(2'050)).isFrozen(0.3));
    EXPECT_FALSE(watch.at(at(9'000)).isFrozen(0.3)) << "then nothing comes at all";
    watch.arrived(one, at(2'100));
    EXPECT_NEAR(watch.at(at(2'100)).seconds(), 0.0, 1e-9);
}

TEST(DriveSetpoint, HaltedSticksMustBeNeutralAndTheOverrideEndsWithThem) {
    DriveSetpoint setpoint({0.5, 1.0, false});
    setpoint.permit(true);
    setpoint.set({}, at(0));
    setpoint.set({0.3, 0.0, 0.0}, at(10), true);
    EXPECT_TRUE(setpoint.withoutEyes(at(10)));
    EXPECT_FALSE(setpoint.withoutEyes(at(210))) << "nobody tells it any more";
    setpoint.set({0.3, 0.0, 0.0}, at(220));
    EXPECT_FALSE(setpoint.withoutEyes(at(220))) << "let go";
    EXPECT_EQ(setpoint.at(at(220)).forward, 0.3);
    setpoint.halt();
    EXPECT_TRUE(isZero(setpoint.at(at(220))));
    setpoint.set({0.3, 0.0, 0.0}, at(230));
    EXPECT_TRUE(isZero(setpoint.at(at(230)))) << "still held";
    EXPECT_TRUE(setpoint.waitsForNeutral());
    setpoint.set({}, at(240));
    setpoint.set({0.3, 0.0, 0.0}, at(250));
    EXPECT_EQ(setpoint.at(at(250)).forward, 0.3);
    setpoint.set({0.3, 0.0, 0.0}, at(260), true);
    setpoint.permit(false);
    EXPECT_FALSE(setpoint.withoutEyes(at(260)));
}

}  // namespace
}  // namespace leitstand::test
