#include "widgets/models/live/preflight/preflight_list.h"

#include <set>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <QAbstractItemModelTester>
#include <QLocale>

namespace leitstand {
namespace {

using Kind = PreflightCheck::Kind;
using Verdict = BrakeResult::Verdict;

class PreflightListTest : public testing::Test {
protected:
    void SetUp() override { QLocale::setDefault(QLocale(QLocale::English, QLocale::UnitedStates)); }
};

TEST_F(PreflightListTest, EveryKindHasWordsAndWhatIsWrongARemedy) {
    for (int kind = 0; kind <= int(Kind::Versions); ++kind) {
        for (const CheckState state : {CheckState::Ok, CheckState::Attention, CheckState::Fail}) {
            const PreflightCheck check{Kind(kind), state, "kurt3d", "a detail", 0.31, 0.02};
            EXPECT_FALSE(checkText(check).isEmpty()) << kind;
        }
    }
    EXPECT_EQ(checkText({Kind::BrakePassed, CheckState::Ok, "k", {}, 0.31, 0.021}),
              "brake: stands after 310 ms and 2 cm without commands");
    EXPECT_EQ(checkText({Kind::ClockSteady, CheckState::Ok, "k", {}, -0.004}), "clock 4 ms behind ours");
    EXPECT_EQ(checkText({Kind::Disk, CheckState::Ok, {}, "/m", 18.2, 210e6}),
              "disk: room for 18 h, writes 210 MB/s");
    EXPECT_EQ(checkText({Kind::Versions, CheckState::Ok, {}, "Leitstand 0.4"}), "Leitstand 0.4");
    EXPECT_EQ(checkText({Kind::SoundNone, CheckState::Attention, {}, "no device"}), "no device");
    EXPECT_FALSE(remedyText({Kind::SoundNone, CheckState::Attention}).isEmpty());
    EXPECT_FALSE(remedyText({Kind::BrakeFailed, CheckState::Fail}).isEmpty());
    EXPECT_EQ(remedyText({Kind::ClockFar, CheckState::Attention, "k", {}, 1.2}),
              "It may drop every drive command as too old: set its clock (NTP)");
    EXPECT_TRUE(remedyText({Kind::BrakePassed, CheckState::Ok}).isEmpty());
}

TEST_F(PreflightListTest, StatesDifferByShapeAndWords) {
    EXPECT_NE(stateMark(CheckState::Ok), stateMark(CheckState::Fail));
    EXPECT_NE(stateMark(CheckState::Ok), stateMark(CheckState::Attention));
    EXPECT_NE(stateMark(CheckState::Note), stateMark(CheckState::Ok)) << "\"not secured\" is not ticked";
    EXPECT_EQ(verdictText({{Kind::Open, CheckState::Note}}), "All in order");
    EXPECT_EQ(verdictText({}), "All in order");
    EXPECT_EQ(verdictText({{Kind::Deaf, CheckState::Fail}, {Kind::BrakeUntested, CheckState::Attention}}),
              "1 to be mended, 1 to be looked at");
}

TEST_F(PreflightListTest, RowsNameTheirRobotOnce) {
    PreflightList list;
    const QAbstractItemModelTester tester(&list);
    list.setChecks({{Kind::RobotConnected, CheckState::Ok, "kurt3d", {}, 0.02},
                    {Kind::BrakeFailed, CheckState::Fail, "kurt3d"},
                    {Kind::Network, CheckState::Ok, {}, "wlan0 192.168.0.7"}},
                   {{"kurt3d", {"kurt3d", "K", "Kurt3D", 0}}});
    ASSERT_EQ(list.rowCount(), 3);
    const auto text = [&](int row, int column) { return list.data(list.index(row, column)).toString(); };
    EXPECT_EQ(text(0, PreflightList::Who), "Kurt3D");
    EXPECT_EQ(text(1, PreflightList::Who), "");
    EXPECT_EQ(text(2, PreflightList::Who), "Station");
    EXPECT_EQ(list.data(list.index(1, PreflightList::What), ToneRole).toInt(), int(Tone::Act));
    EXPECT_EQ(list.data(list.index(0, PreflightList::What), ToneRole).toInt(), int(Tone::Normal));
    EXPECT_EQ(list.data(list.index(1, 0), Qt::AccessibleTextRole).toString(), "Kurt3D: must be mended");
}

TEST_F(PreflightListTest, TheBrakeTestTellsHowItStands) {
    using Phase = BrakeTest::Phase;
    EXPECT_THAT(brakeText(Phase::Driving, {}).toStdString(), testing::HasSubstr("keep holding"));
    EXPECT_EQ(brakeText(Phase::Done, {.verdict = Verdict::Inconclusive,
                                      .cause = BrakeResult::Cause::NoRoom,
                                      .free = 0.34,
                                      .needed = 0.6}),
              "No result: only 0.3 m are free ahead, 0.6 m are needed");
    EXPECT_EQ(brakeText(Phase::Idle, {Verdict::Passed, 0.31, 0.02}), "Passed: stands after 310 ms and 2 cm");
}

TEST_F(PreflightListTest, TheWatchdogOfARobotIsTold) {
    using Phase = BrakeTest::Phase;
    BrakeResult brake{.verdict = Verdict::Passed, .seconds = 0.31, .metres = 0.02};
    brake.watchdog = BrakeResult::Watchdog::Stops;
    brake.brakesAfter = 0.2;
    EXPECT_EQ(brakeText(Phase::Idle, brake), "Passed: brakes after 200 ms, stands after 310 ms and 2 cm");
    PreflightCheck check{Kind::BrakePassed, CheckState::Ok, "k", {}, 0.31, 0.02};
    check.brake = brake;
    EXPECT_EQ(checkText(check), "brake: brakes after 200 ms, stands after 310 ms and 2 cm without commands");
    check.kind = Kind::BrakeFailed;
    check.brake.verdict = Verdict::Failed;
    EXPECT_EQ(checkText(check),
              "brake: FAILED, brakes after 200 ms, stands after 310 ms and 2 cm; driving is refused");
    check.brake.watchdog = BrakeResult::Watchdog::None;
    EXPECT_EQ(checkText(check),
              "brake: FAILED, still moves 310 ms after the last command; driving is refused");
}

TEST_F(PreflightListTest, TheGuardOfARobotIsTold) {
    PreflightCheck check{Kind::BrakeOverridden, CheckState::Attention, "k"};
    std::set<QString> texts = {checkText(check)};
    for (const auto state : {GuardView::State::Starting, GuardView::State::Ready, GuardView::State::Failed}) {
        check.guard = {state, "no such file"};
        texts.insert(checkText(check));
    }
    EXPECT_EQ(texts.size(), 4U);
    EXPECT_THAT(checkText(check).toStdString(), testing::HasSubstr("no guard: no such file"));
}

TEST_F(PreflightListTest, EveryCauseOfABrakeTestWithoutResultIsTold) {
    std::set<QString> texts;
    constexpr int Last = int(BrakeResult::Cause::OdometryEnded);
    for (int cause = 1; cause <= Last; ++cause) {
        PreflightCheck check{Kind::BrakeUnclear, CheckState::Attention, "k"};
        check.brake = {.verdict = Verdict::Inconclusive, .cause = BrakeResult::Cause(cause)};
        texts.insert(checkText(check));
        EXPECT_NE(checkText(check), "brake: no result (nothing tells why)") << cause;
    }
    EXPECT_EQ(texts.size(), std::size_t(Last)) << "each has words of its own";
}

TEST_F(PreflightListTest, WhatTheWireComplainsAboutAndADegradedLinkAreTold) {
    PreflightCheck wire{Kind::Wire, CheckState::Attention, "k"};
    wire.wire.topic = "/k/odom";
    constexpr int Last = int(WireProblem::Kind::Security);
    for (int kind = 0; kind <= Last; ++kind) {
        wire.wire.problems = {{WireProblem::Kind(kind), "best effort", "reliable"}};
        // English words are those of the log.
        EXPECT_EQ(checkText(wire).toStdString(), toString(wire.wire));
    }
    PreflightCheck link{Kind::RobotConnected, CheckState::Attention, "k"};
    link.reasons = {{.kind = LinkReason::Kind::Slow, .value = 0.38},
                    {.kind = LinkReason::Kind::NoAnswer, .value = 3.1}};
    EXPECT_EQ(checkText(link), "connected, but slow: 380 ms, no answer for 3.1 s");
}

}  // namespace
}  // namespace leitstand
