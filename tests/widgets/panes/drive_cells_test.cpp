#include <chrono>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "app/language/language.h"
#include "core/event/motion_samples.h"
#include "core/event/status_samples.h"
#include "tests/support/latest.h"
#include "tests/widgets/panes/shown.h"
#include "widgets/drive/drive_strip.h"
#include "widgets/drive/energy_cell.h"
#include "widgets/drive/mode_cell.h"
#include "widgets/models/live/texts/stop_line.h"
#include "widgets/robots/robot_chip_button.h"

namespace leitstand::test {
namespace {

using testing::Contains;
using testing::HasSubstr;

/// The strip of layout Drive in a window of 1280 x 800.
constexpr QSize StripAtReference(655, 178);

std::vector<std::string> textsOf(QWidget& widget) {
    std::vector<std::string> texts;
    for (const PaintedText& one : paintedTexts(widget)) texts.push_back(one.text.toStdString());
    return texts;
}

SampleRobot trackedRobot(double left, double right) {
    SampleRobot robot = sampleRobot("C", "Crawler", 1);
    robot.description.drive = DriveType::Tracked;
    robot.view.drive.velocity = {0.25, 0.0, 0.0};
    robot.view.joints = trackSpeeds({left, right});
    robot.view.jointsAge = 0.1;
    return robot;
}

class DriveCells : public testing::TestWithParam<Theme> {
protected:
    void SetUp() override { useTheme(GetParam()); }
    [[nodiscard]] const ThemeColours& colours() const { return coloursOf(GetParam()); }
};

TEST_P(DriveCells, ChainsAreToldInTheStripOfTheReferenceSize) {
    DriveStrip strip;
    strip.show(driveStateOf(trackedRobot(0.21, 0.24)));
    static_cast<void>(pictureOf(strip, StripAtReference, "chains"));
    EXPECT_EQ(textFaults(strip).join("; ").toStdString(), "");
    EXPECT_THAT(textsOf(strip), Contains(HasSubstr("0.21 of 0.25")));
    EXPECT_THAT(textsOf(strip), Contains("nearest")) << "captions have room too";
    strip.show(driveStateOf(trackedRobot(0.0, 0.24)));
    static_cast<void>(pictureOf(strip, StripAtReference, "chain_stuck"));
    EXPECT_EQ(textFaults(strip).join("; ").toStdString(), "");
    EXPECT_THAT(textsOf(strip), Contains("the left chain does not follow"));
    const auto* const mode = strip.findChild<ModeCell*>();
    EXPECT_THAT(mode->accessibleDescription().toStdString(), HasSubstr("the left chain does not follow"));
    EXPECT_THAT(mode->accessibleDescription().toStdString(), HasSubstr("0.00 of 0.25"));
}

TEST_P(DriveCells, AChainThatDoesNotFollowIsToldInTheSmallestStripToo) {
    DriveStrip strip;
    SampleRobot robot = trackedRobot(0.0, 0.24);
    strip.show(driveStateOf(robot));
    static_cast<void>(pictureOf(strip, {655, 150}, "chain_stuck_low"));
    EXPECT_EQ(textFaults(strip).join("; ").toStdString(), "");
    EXPECT_THAT(textsOf(strip), Contains("the left chain does not follow"));
    robot.view.drive.needsNeutral = true;
    strip.show(driveStateOf(robot));
    EXPECT_THAT(textsOf(strip), Contains("sticks must be neutral first")) << "what has to be done goes first";
}

TEST_P(DriveCells, TheTimeLeftOfABatteryIsToldAtEveryHeight) {
    const SampleRobot robot = sampleRobot();
    EnergyCell cell;
    cell.show(driveStateOf(robot));
    for (const int height : {150, 169, 178, 240}) {
        for (const int width : {140, 260}) {
            static_cast<void>(pictureOf(cell, {width, height}, "battery"));
            EXPECT_THAT(textsOf(cell), Contains(HasSubstr("38 min"))) << width << " x " << height;
            EXPECT_EQ(textFaults(cell).join("; ").toStdString(), "") << width << " x " << height;
        }
    }
}

TEST_P(DriveCells, HowMuchIsLostOnTheLinkIsToldWholeInEveryLanguage) {
    SampleRobot robot = sampleRobot();
    robot.view.link.state = LinkState::Degraded;
    robot.view.link.roundTrip = RoundTripStatus{.last = 1.9, .median = 1.9};
    ASSERT_FALSE(robot.view.link.streams.empty());
    robot.view.link.streams.front().lossRatio = 0.88;
    robot.view.link.streams.front().stale = false;
    for (const auto& [language, word] :
         {std::pair("en", "loss"), std::pair("de", "Verlust"), std::pair("ja", "欠落")}) {
        useLanguage(QLatin1String(language));
        EnergyCell cell;
        cell.show(driveStateOf(robot));
        for (const int width : {136, 140, 156, 260}) {
            static_cast<void>(pictureOf(cell, {width, 150}, "loss"));
            EXPECT_THAT(textsOf(cell), Contains(HasSubstr(word))) << language << ", " << width;
            EXPECT_EQ(textFaults(cell).join("; ").toStdString(), "") << language << ", " << width;
        }
    }
    useLanguage(QStringLiteral("en"));
}

TEST_P(DriveCells, ABatteryWithFewMinutesIsLoudHoweverFullItIs) {
    SampleRobot robot = sampleRobot();
    editable(robot.reported.battery).sample.current = -60.0;  // 7 minutes
    EnergyCell cell;
    cell.show(driveStateOf(robot));
    EXPECT_GT(countOf(pictureOf(cell, {141, 178}, "few_minutes"), colours().attention, 20), 100);
}

TEST_P(DriveCells, HowLongAStopIsNotAnsweredIsToldInANarrowBar) {
    SampleRobot robot = sampleRobot();
    setStop(robot, false, false);
    robot.view.stop.unanswered = std::chrono::milliseconds(2'900);
    RobotChipButton button({});
    button.show(robotChipOf(robot.face, robot.view, robot.reported, at(0)),
                stopLineOf(robot.face, robot.view));
    static_cast<void>(pictureOf(button, {250, robot_bar::Height}, {}));
    EXPECT_THAT(textsOf(button), Contains("sent · no answer for 2.9 s"));
    static_cast<void>(pictureOf(button, {160, robot_bar::Height}, "stop_narrow"));
    EXPECT_THAT(textsOf(button), Contains("no answer for 2.9 s"));
    static_cast<void>(pictureOf(button, button.minimumSizeHint(), {}));
    EXPECT_THAT(textsOf(button), Contains("? 2.9 s")) << "words go before the number, and nothing is cut";
    EXPECT_EQ(textFaults(button).join("; ").toStdString(), "");
}

INSTANTIATE_TEST_SUITE_P(Themes, DriveCells, testing::Values(Theme::Dark, Theme::Light),
                         [](const auto& one) { return one.param == Theme::Dark ? "Dark" : "Light"; });

}  // namespace
}  // namespace leitstand::test
