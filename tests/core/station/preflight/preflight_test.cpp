#include "core/station/preflight/preflight.h"

#include <algorithm>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/event/stream_role.h"
#include "core/station/alarms/alarm_rules.h"

namespace leitstand::test {
namespace {

using namespace std::chrono_literals;
using Kind = PreflightCheck::Kind;
using Verdict = BrakeResult::Verdict;

StreamStatus stream(StreamRole role, const std::string& topic) {
    StreamStatus one;
    one.role = role;
    one.topic = topic;
    one.samples = 100;
    one.rate = one.expectedRate = 10.0;
    one.age = 0.1;
    one.steady = true;
    return one;
}

/// A station with one robot, all in order.
PreflightFacts goodFacts() {
    PreflightFacts facts;
    RobotFacts robot;
    robot.robot.name = "kurt3d";
    robot.robot.streams.emplace_back();
    robot.robot.streams.back().role = StreamRole::StopCommand;
    robot.view.link.state = LinkState::Connected;
    robot.view.link.silence = 0.1;
    robot.view.link.roundTrip = RoundTripStatus{.last = 0.02, .median = 0.02};
    robot.view.link.clock = ClockStatus{.ahead = 3ms};
    robot.view.link.streams = {stream(StreamRole::Points, "/kurt3d/points"),
                               stream(StreamRole::Odometry, "/kurt3d/odom"),
                               stream(StreamRole::Picture, "/kurt3d/left/image/compressed")};
    robot.view.drive.drivable = robot.view.drive.reachable = true;
    robot.view.grant.mine = true;
    robot.brake = {.verdict = Verdict::Passed, .seconds = 0.3, .metres = 0.02, .when = Time(1'000h)};
    facts.now = Time(1'001h);
    facts.robots = {robot};
    facts.cards = {{"lo", "127.0.0.1", true, true, true}, {"wlan0", "192.168.0.7", true, false, true}};
    facts.folder = "/missions/one";
    facts.freeBytes = 100'000'000'000;
    facts.writeRate = 200e6;
    facts.gamepad = "Xbox pad";
    facts.secured = true;
    facts.security = "station1";
    facts.versions = {"Leitstand 0.1"};
    return facts;
}

const PreflightCheck* find(const std::vector<PreflightCheck>& checks, Kind kind) {
    const auto found =
        std::find_if(checks.begin(), checks.end(), [&](const auto& one) { return one.kind == kind; });
    return found == checks.end() ? nullptr : &*found;
}

class Preflight : public testing::Test {
protected:
    [[nodiscard]] RobotFacts& robot() { return facts.robots.front(); }
    /// The check of @p kind has @p state now.
    void expect(Kind kind, CheckState state) const {
        const auto checks = preflight(facts);
        const PreflightCheck* check = find(checks, kind);
        ASSERT_NE(check, nullptr) << int(kind);
        EXPECT_EQ(check->state, state) << int(kind);
    }
    [[nodiscard]] bool has(Kind kind) const { return find(preflight(facts), kind) != nullptr; }

    PreflightFacts facts = goodFacts();
};

TEST_F(Preflight, ACalmStationIsCalm) {
    const auto checks = preflight(facts);
    EXPECT_EQ(worstOf(checks), CheckState::Ok);
    EXPECT_EQ(checks.front().robot, "kurt3d");
    EXPECT_EQ(checks.back().kind, Kind::Versions);
    EXPECT_EQ(find(checks, Kind::StreamsComing)->number, 3.0);
}

TEST_F(Preflight, ARobotThatIsNotThereIsAllThatIsSaidOfIt) {
    robot().view.link = {};
    expect(Kind::RobotMissing, CheckState::Fail);
    EXPECT_FALSE(has(Kind::StreamsMissing));
    EXPECT_FALSE(has(Kind::BrakePassed));
    robot().view.link.state = LinkState::Lost;
    expect(Kind::RobotMissing, CheckState::Fail);
}

TEST_F(Preflight, StreamsThatNeverCameStoppedOrAreOff) {
    robot().view.link.streams[0].samples = 0;
    expect(Kind::StreamsMissing, CheckState::Attention);
    robot().view.link.streams[0].paused = true;
    expect(Kind::StreamsComing, CheckState::Ok);
    robot().view.link.streams[1].stale = true;
    expect(Kind::StreamsStale, CheckState::Attention);
    robot().view.link.streams[1].stale = false;
    robot().view.link.streams[1].samples = 0;
    robot().view.link.streams[1].role = StreamRole::Bumps;
    expect(Kind::StreamsComing, CheckState::Ok);
}

TEST_F(Preflight, OldPicturesFail) {
    robot().view.link.streams[2].age = 4.0;
    expect(Kind::PicturesOld, CheckState::Fail);
    EXPECT_EQ(find(preflight(facts), Kind::PicturesOld)->detail, "left/image/compressed");
    robot().view.link.streams[2].paused = true;
    EXPECT_FALSE(has(Kind::PicturesOld)) << "switched off by the operator";
}

TEST_F(Preflight, ADegradedLinkAClockAndComplaintsNeedALook) {
    robot().view.link.state = LinkState::Degraded;
    robot().view.link.reasons = {{.kind = LinkReason::Kind::Slow, .value = 0.4}};
    expect(Kind::RobotConnected, CheckState::Attention);
    robot().view.link.clock->ahead = -3600s;
    expect(Kind::ClockFar, CheckState::Attention);
    robot().view.link.clock.reset();
    expect(Kind::ClockUnknown, CheckState::Attention);
    robot().complaints = {{"/kurt3d/odom", {{WireProblem::Kind::OffersLess, "best effort", "reliable"}}}};
    expect(Kind::Wire, CheckState::Attention);
    EXPECT_EQ(find(preflight(facts), Kind::Wire)->wire, robot().complaints.front());
}

TEST_F(Preflight, AClockIsFarFromWhereTheAlarmTellsOfIt) {
    EXPECT_EQ(facts.farClock, AlarmLimits{}.clock);
    EXPECT_LE(facts.farClock, 1.0) << "from there on every command may be dropped";
    for (const auto side : {1, -1}) {
        robot().view.link.clock = ClockStatus{.ahead = side * 990ms};
        expect(Kind::ClockSteady, CheckState::Ok);
        robot().view.link.clock->ahead = side * 1000ms;
        expect(Kind::ClockFar, CheckState::Attention);
        robot().view.link.clock->uncertainty = 20ms;
        expect(Kind::ClockSteady, CheckState::Ok);
    }
    facts.farClock = 0.5;  // as the team's file says
    robot().view.link.clock = ClockStatus{.ahead = 600ms};
    expect(Kind::ClockFar, CheckState::Attention);
}

TEST_F(Preflight, WhoDrives) {
    robot().view.grant = {};
    expect(Kind::GrantFree, CheckState::Ok);
    robot().view.grant.holder = "other";
    robot().view.grant.holderTitle = "Desk 2";
    expect(Kind::GrantOthers, CheckState::Attention);
    EXPECT_EQ(find(preflight(facts), Kind::GrantOthers)->detail, "Desk 2");
    robot().view.drive.reachable = false;
    expect(Kind::Deaf, CheckState::Fail);
    robot().view.stop.stopped = true;
    expect(Kind::Stopped, CheckState::Attention);
    robot().view.drive.drivable = false;
    EXPECT_FALSE(has(Kind::Deaf));
}

TEST_F(Preflight, Brakes) {
    expect(Kind::BrakePassed, CheckState::Ok);
    facts.now = Time(1'030h);
    expect(Kind::BrakeOld, CheckState::Attention);
    robot().brake.verdict = Verdict::Failed;
    expect(Kind::BrakeFailed, CheckState::Fail);
    robot().brakeOverridden = true;
    expect(Kind::BrakeOverridden, CheckState::Attention);
    robot().guard.state = GuardView::State::Ready;
    expect(Kind::BrakeOverridden, CheckState::Attention);
    robot().guard = {GuardView::State::Failed, "no such file"};
    expect(Kind::BrakeOverridden, CheckState::Fail);
    EXPECT_EQ(find(preflight(facts), Kind::BrakeOverridden)->guard.problem, "no such file");
    robot().guard = {};
    robot().brake = {};
    expect(Kind::BrakeUntested, CheckState::Attention);
    robot().brake.verdict = Verdict::Inconclusive;
    robot().brake.cause = BrakeResult::Cause::Deaf;
    expect(Kind::BrakeUnclear, CheckState::Attention);
    EXPECT_EQ(find(preflight(facts), Kind::BrakeUnclear)->brake.cause, BrakeResult::Cause::Deaf);
}

TEST_F(Preflight, DiskAndNetwork) {
    facts.freeBytes = 4'000'000'000;
    expect(Kind::DiskShort, CheckState::Attention);
    facts.freeBytes = 100'000'000;
    expect(Kind::DiskShort, CheckState::Fail);
    facts.freeBytes = 1'000'000'000'000;
    facts.writeRate = 2e6;
    expect(Kind::DiskSlow, CheckState::Attention);
    facts.writeRate = 1e6;
    expect(Kind::DiskSlow, CheckState::Fail);
    facts.writeRate.reset();
    expect(Kind::Disk, CheckState::Ok);
    facts.logProblem = "disk full";
    expect(Kind::DiskBroken, CheckState::Fail);
    facts.cards.pop_back();
    expect(Kind::NetworkNone, CheckState::Attention);
}

TEST_F(Preflight, AlarmsThatNobodyHearsAreLookedAt) {
    EXPECT_TRUE(has(Kind::Sound));
    facts.soundProblem = "no device";
    EXPECT_TRUE(has(Kind::SoundNone) && !has(Kind::Sound));
    EXPECT_EQ(worstOf(preflight(facts)), CheckState::Attention);
}

TEST_F(Preflight, AScannerWhosePlaceNobodyTellsIsNamed) {
    EXPECT_FALSE(has(Kind::ScannerUnplaced));
    facts.robots.front().view.unplaced = {"livox_frame"};
    expect(Kind::ScannerUnplaced, CheckState::Attention);
}

TEST_F(Preflight, OfAStockRobotIsSaidWhatStopIsToItAndThatOthersMayDriveIt) {
    EXPECT_FALSE(has(Kind::NotBound));
    facts.robots.front().robot.streams.clear();
    expect(Kind::NotBound, CheckState::Note);
    EXPECT_FALSE(has(Kind::LockHeard) || has(Kind::LockUnheard));
    StreamDescription lock;
    lock.role = StreamRole::StopLock;
    lock.topic = "/rover/lock";
    facts.robots.front().robot.streams.push_back(lock);
    expect(Kind::LockUnheard, CheckState::Attention);
    facts.robots.front().view.stop.lockHeard = true;
    expect(Kind::LockHeard, CheckState::Ok);
    EXPECT_FALSE(has(Kind::StopServices) || has(Kind::StopServicesMissing));
    facts.robots.front().view.stop.services = {{.title = "E-stop", .offered = true}, {.title = "Goals"}};
    expect(Kind::StopServices, CheckState::Ok);
    expect(Kind::StopServicesMissing, CheckState::Attention);
    facts.robots.front().view.drive.drivable = false;
    EXPECT_FALSE(has(Kind::NotBound)) << "nobody drives it";
}

TEST_F(Preflight, WhatIsAMatterOfTasteIsNotLoud) {
    facts.gamepad.clear();
    facts.secured = false;
    facts.strangers = {"rover"};
    facts.environment = {"ROS_DOMAIN_ID=7"};
    EXPECT_EQ(worstOf(preflight(facts)), CheckState::Note) << "neither wrong nor ticked as in order";
    expect(Kind::GamepadNone, CheckState::Note);
    expect(Kind::Open, CheckState::Note);
    expect(Kind::Stranger, CheckState::Note);
    expect(Kind::Environment, CheckState::Note);
    EXPECT_TRUE(has(Kind::GamepadNone) && has(Kind::Open) && has(Kind::Stranger) && has(Kind::Environment));
}

}  // namespace
}  // namespace leitstand::test
