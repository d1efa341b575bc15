#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <QLocale>

#include "core/event/status_samples.h"
#include "tests/support/latest.h"
#include "tests/widgets/live/sample_robot.h"
#include "widgets/models/live/robots/drive_state.h"
#include "widgets/models/live/robots/robot_chip.h"

namespace leitstand {
namespace {

using test::at;
using test::SampleRobot;
using test::sampleRobot;
using testing::HasSubstr;
using testing::Not;

class BatteryWords : public testing::Test {
protected:
    void SetUp() override { QLocale::setDefault(QLocale(QLocale::English, QLocale::UnitedStates)); }
    [[nodiscard]] DriveState state(double now = 0.0, const AlarmLimits& limits = {}) const {
        return driveStateOf(robot.face, robot.description, robot.view, robot.reported, robot.gas, at(now),
                            limits);
    }
    SampleRobot robot = sampleRobot();
};

TEST_F(BatteryWords, BatteryTellsMinutesAndWarnsWhenLow) {
    EXPECT_EQ(state().battery.charge.value.toStdString(), "71");
    EXPECT_EQ(state().battery.left.toStdString(), "38 min at this load");
    EXPECT_EQ(state().battery.leftBrief.toStdString(), "38 min");
    const auto toneOf = [this](double share, double current, const AlarmLimits& limits = {}) {
        test::editable(robot.reported.battery).sample.fraction = share;
        test::editable(robot.reported.battery).sample.current = current;
        return state(0.0, limits).battery.charge.tone;
    };
    EXPECT_EQ(toneOf(0.24, -1.0), Tone::Normal) << "as the alarms have it";
    EXPECT_EQ(toneOf(0.2, -1.0), Tone::Attention);
    EXPECT_EQ(toneOf(0.09, -0.1), Tone::Attention);
    EXPECT_EQ(toneOf(0.08, -0.1), Tone::Act);
    EXPECT_EQ(toneOf(0.5, -40.0), Tone::Attention) << "7 minutes are left";
    EXPECT_EQ(state().battery.leftTone, Tone::Attention);
    EXPECT_EQ(toneOf(0.5, -120.0), Tone::Act) << "of both, the worse counts";
    AlarmLimits own;
    own.batteryShare = 0.6;
    EXPECT_EQ(toneOf(0.5, -1.0, own), Tone::Attention) << "limits are the operator's";
    test::editable(robot.reported.battery).sample.current = Unknown;
    EXPECT_TRUE(state().battery.left.isEmpty());
    robot.reported.battery.reset();
    EXPECT_EQ(state().battery.left.toStdString(), "not reported");
}

TEST_F(BatteryWords, ABatteryThatIsNotToldAnyMoreIsADashInTheBarAndGreyInTheStrip) {
    const RobotChip fresh = robotChipOf(robot.face, robot.view, robot.reported, at(9.0));
    EXPECT_THAT(fresh.figures.first().toStdString(), HasSubstr("71\u202f%"));
    EXPECT_THAT(fresh.details.toStdString(), HasSubstr("battery 71\u202f%"));
    const RobotChip old = robotChipOf(robot.face, robot.view, robot.reported, at(12.0));
    for (const QString& text : old.figures) {
        EXPECT_THAT(text.toStdString(), Not(HasSubstr("71")));
        EXPECT_THAT(text.toStdString(), HasSubstr("–\u202f%"));
    }
    EXPECT_THAT(old.details.toStdString(), HasSubstr("battery 71\u202f%, no data for 12 s"));
    EXPECT_EQ(state(9.0).battery.charge.tone, Tone::Normal);
    EXPECT_EQ(state(12.0).battery.charge.tone, Tone::Muted);
    test::editable(robot.reported.battery).sample.fraction = 0.05;
    EXPECT_EQ(state(12.0).battery.charge.tone, Tone::Muted) << "not the alarm of now";
}

}  // namespace
}  // namespace leitstand
