#include "widgets/models/live/preflight_list.h"

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
    EXPECT_FALSE(remedyText({Kind::BrakeFailed, CheckState::Fail}).isEmpty());
    EXPECT_EQ(remedyText({Kind::ClockFar, CheckState::Attention, "k", {}, 1.2}),
              "It may drop every drive command as too old: set its clock (NTP)");
    EXPECT_TRUE(remedyText({Kind::BrakePassed, CheckState::Ok}).isEmpty());
}

TEST_F(PreflightListTest, StatesDifferByShapeAndWords) {
    EXPECT_NE(stateMark(CheckState::Ok), stateMark(CheckState::Fail));
    EXPECT_NE(stateMark(CheckState::Ok), stateMark(CheckState::Attention));
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
    EXPECT_THAT(brakeText(Phase::Done, {Verdict::Inconclusive, 0, 0, "the key was let go"}).toStdString(),
                testing::HasSubstr("let go"));
    EXPECT_EQ(brakeText(Phase::Idle, {Verdict::Passed, 0.31, 0.02}), "Passed: stands after 310 ms and 2 cm");
}

}  // namespace
}  // namespace leitstand
