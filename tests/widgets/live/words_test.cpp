#include <limits>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <QCoreApplication>
#include <QLocale>
#include <QTranslator>

#include "core/base/pose.h"
#include "core/event/motion_samples.h"
#include "core/event/status_samples.h"
#include "core/event/stream_role.h"
#include "tests/support/latest.h"
#include "tests/widgets/live/sample_robot.h"
#include "widgets/models/live/robots/drive_state.h"
#include "widgets/models/live/robots/robot_chip.h"
#include "widgets/models/live/texts/goal_text.h"
#include "widgets/models/live/texts/link_text.h"
#include "widgets/models/live/texts/sight_text.h"
#include "widgets/models/live/texts/stop_line.h"

namespace leitstand {
namespace {

using test::at;
using test::SampleRobot;
using test::sampleRobot;
using test::setMode;
using test::setStop;
using testing::HasSubstr;
using Choice = GrantFigures::Choice;

DriveState stateOf(const SampleRobot& robot, double now = 0.0) {
    return driveStateOf(robot.face, robot.description, robot.view, robot.reported, robot.gas, at(now));
}
ModeLabel labelOf(const SampleRobot& robot) {
    return modeLabelOf(robot.view, robot.reported.mode);
}

class LiveWords : public testing::Test {
protected:
    void SetUp() override { QLocale::setDefault(QLocale(QLocale::English, QLocale::UnitedStates)); }
    SampleRobot robot = sampleRobot();
};

TEST_F(LiveWords, ARobotWhoseLinkIsLostDrivesItselfAsLongAsItSaidSoAndNoStopStands) {
    EXPECT_FALSE(drivesItself(robot.view, robot.reported.mode)) << "it is driven";
    setMode(robot, "explore", true, "");
    EXPECT_TRUE(drivesItself(robot.view, robot.reported.mode));
    robot.view.link.state = LinkState::Lost;
    EXPECT_TRUE(drivesItself(robot.view, robot.reported.mode)) << "nobody can ask it, and it goes on";
    robot.view.stop.stopped = true;
    EXPECT_FALSE(drivesItself(robot.view, robot.reported.mode));
    robot.view.stop.stopped = false;
    setMode(robot, "stopped", false, "");
    EXPECT_FALSE(drivesItself(robot.view, robot.reported.mode));
    EXPECT_FALSE(drivesItself(robot.view, nullptr)) << "it never said";
}

TEST_F(LiveWords, AModeHasItsKind) {
    EXPECT_EQ(labelOf(robot), (ModeLabel{ModeKind::Teleoperation, "TELEOPERATION", {}, "TELEOP"}));
    setMode(robot, "victim_approach", true, "body heat in sight");
    EXPECT_EQ(labelOf(robot),
              (ModeLabel{ModeKind::Autonomous, "VICTIM APPROACH", "body heat in sight", "APPROACH"}));
    setMode(robot, "stopped");
    EXPECT_EQ(labelOf(robot).kind, ModeKind::Stopped);
    setMode(robot, "wall_following", true);
    EXPECT_EQ(labelOf(robot).text.toStdString(), "WALL FOLLOWING");
    robot.reported.mode.reset();
    EXPECT_EQ(labelOf(robot).kind, ModeKind::Teleoperation);
    robot.view.drive.driving = false;
    EXPECT_EQ(labelOf(robot).kind, ModeKind::Stopped);
}

TEST_F(LiveWords, ARobotWithoutModesIsNotSaidToHaveAnUnknownOne) {
    robot.reported.mode.reset();
    robot.view.drive.driving = false;
    auto& streams = robot.view.link.streams;
    streams.resize(1);
    streams.front().role = StreamRole::Mode;
    EXPECT_EQ(labelOf(robot).text.toStdString(), "MODE UNKNOWN");
    streams.front().role = StreamRole::Odometry;
    EXPECT_EQ(labelOf(robot).text.toStdString(), "NO MODES");
    EXPECT_EQ(labelOf(robot).kind, ModeKind::Stopped);
    robot.view.drive.driving = true;
    EXPECT_EQ(labelOf(robot).text.toStdString(), "TELEOPERATION");
}

/// Has one text of a robot.
class RobotInGerman final : public QTranslator {
public:
    using QTranslator::QTranslator;
    [[nodiscard]] bool isEmpty() const override { return false; }
    QString translate(const char* context, const char* text, const char* /*about*/,
                      int /*count*/) const override {
        if (qstrcmp(context, "leitstand::ModeLabel") == 0 && qstrcmp(text, "victim approach") == 0)
            return QStringLiteral("Opferanfahrt");
        const bool known =
            qstrcmp(context, "leitstand::RobotSays") == 0 && qstrcmp(text, "heat {} m ahead") == 0;
        return known ? QStringLiteral("Wärme {} m voraus") : QString();
    }
};

TEST_F(LiveWords, WhatRobotsSayIsInTheWindowsLanguage) {
    EXPECT_EQ(robotReasonText("heat 1.20 m ahead; not seen there yet").toStdString(),
              "heat 1.20 m ahead; not seen there yet");
    EXPECT_EQ(robotReasonText("victim_approach cannot be asked for").toStdString(),
              "victim approach cannot be asked for");
    int arguments = 0;
    const QCoreApplication application(arguments, nullptr);
    RobotInGerman german;
    QCoreApplication::installTranslator(&german);
    QLocale::setDefault(QLocale(QLocale::German));
    setMode(robot, "victim_approach", true, "heat 1.20 m ahead; läuft");
    EXPECT_EQ(labelOf(robot).reason.toStdString(), "Wärme 1,20 m voraus; läuft");
    EXPECT_EQ(labelOf(robot).text.toStdString(), "OPFERANFAHRT");
    EXPECT_THAT(robotChipOf(robot.face, robot.view, robot.reported, at(0)).modes.front().toStdString(),
                HasSubstr("Opferanfahrt"));
    QCoreApplication::removeTranslator(&german);
}

TEST_F(LiveWords, ALostLinkComesBeforeAStopAndAStopBeforeTheMode) {
    setStop(robot, true, true);
    EXPECT_EQ(labelOf(robot).kind, ModeKind::Stop);
    robot.view.link.state = LinkState::Lost;
    robot.view.link.silence = 4.2;
    EXPECT_EQ(labelOf(robot).kind, ModeKind::Lost);
    EXPECT_THAT(stateOf(robot).hint.toStdString(), HasSubstr("stop standing"));
    EXPECT_THAT(stateOf(robot).hint.toStdString(), HasSubstr("silent for 4.2 s"));
    EXPECT_EQ(stateOf(robot).nearest.value, QString(QChar(0x2013))) << "nothing is near that is not known";
    robot.view.link.state = LinkState::NeverSeen;
    EXPECT_EQ(labelOf(robot).kind, ModeKind::Stopped);
}

TEST_F(LiveWords, AStopGoesFromSentToStanding) {
    const auto line = [this] { return stopLineOf(robot.face, robot.view); };
    EXPECT_EQ(line().stage, StopStage::None);
    setStop(robot, false, false);
    EXPECT_EQ(line().stage, StopStage::Sent);
    EXPECT_FALSE(line().releasable);
    robot.view.stop.unanswered = std::chrono::milliseconds(1500);
    EXPECT_THAT(line().text.toStdString(), HasSubstr("no answer for 1.5 s"));
    EXPECT_EQ(line().tone, Tone::Act);
    robot.view.stop.unanswered = {};
    setStop(robot, true, false);
    EXPECT_EQ(line().stage, StopStage::Acknowledged);
    EXPECT_EQ(line().text.toStdString(), "confirmed · moves");
    robot.view.stop.standingKnown = false;
    EXPECT_EQ(line().text.toStdString(), "confirmed · motion unknown");
    setStop(robot, true, true);
    EXPECT_EQ(line().stage, StopStage::Standing);
    EXPECT_EQ(line().tone, Tone::Normal);
    EXPECT_TRUE(line().releasable);
    robot.view.stop.releasing = true;
    EXPECT_EQ(line().stage, StopStage::Releasing);
    EXPECT_FALSE(line().releasable);
}

TEST_F(LiveWords, OnlyTheHolderReleasesAndIsToldWhyNot) {
    setStop(robot, true, true);
    robot.view.grant.mine = false;
    EXPECT_FALSE(stopLineOf(robot.face, robot.view).releasable);
    EXPECT_THAT(stopLineOf(robot.face, robot.view).details.toStdString(), HasSubstr("drive control"));
    robot.view.grant.mine = true;
    robot.view.stop.sent = robot.view.stop.acknowledged = false;
    robot.view.stop.stoppedBy = "other";
    EXPECT_TRUE(stopLineOf(robot.face, robot.view).releasable);
    EXPECT_THAT(stopLineOf(robot.face, robot.view).details.toStdString(), HasSubstr("another station"));
    robot.view.stop.refused = "not the holder";
    EXPECT_THAT(stopLineOf(robot.face, robot.view).details.toStdString(), HasSubstr("not the holder"));
    robot.view.stop = {};
    robot.view.stop.supported = false;
    robot.view.stop.sent = true;
    EXPECT_EQ(stopLineOf(robot.face, robot.view).text.toStdString(), "held by zeros");
    EXPECT_TRUE(stopLineOf(robot.face, robot.view).releasable);
}

TEST_F(LiveWords, ARobotOnItsWayToAGoalDrivesItself) {
    robot.reported.mode = nullptr;
    NavigationView& navigation = robot.view.navigation;
    const auto label = [this] { return modeLabelOf(robot.view, robot.reported.mode); };
    robot.view.drive.driving = false;
    EXPECT_FALSE(drivesItself(robot.view, robot.reported.mode));
    navigation.stage = GoalStage::UnderWay;
    EXPECT_EQ(label().text.toStdString(), "TO ITS GOAL");
    EXPECT_EQ(label().reason.toStdString(), "drives to its goal");
    navigation.metresLeft = 3.21;
    navigation.secondsLeft = 12.4;
    navigation.recoveries = 2;
    EXPECT_THAT(label().reason.toStdString(), HasSubstr("3.2 m to go · 12"));
    EXPECT_THAT(label().reason.toStdString(), HasSubstr("stuck: 2"));
    EXPECT_TRUE(drivesItself(robot.view, robot.reported.mode));
    robot.view.link.state = LinkState::Lost;
    EXPECT_TRUE(drivesItself(robot.view, robot.reported.mode)) << "it goes on";
    robot.view.link.state = LinkState::Connected;
    for (const GoalStage stage : {GoalStage::None, GoalStage::Arrived, GoalStage::Cancelled,
                                  GoalStage::Failed, GoalStage::Refused, GoalStage::Unanswered}) {
        navigation.stage = stage;
        EXPECT_FALSE(drivesItself(robot.view, robot.reported.mode));
        EXPECT_EQ(goalEnd(stage).isEmpty(), stage == GoalStage::None);
    }
}

TEST_F(LiveWords, AStopBySeveralServicesSaysWhichLags) {
    using Stage = StopServiceStatus::Stage;
    StopStatus& stop = robot.view.stop;
    stop = {};
    stop.supported = false;
    stop.sent = true;
    stop.services = {{.title = "E-stop", .stage = Stage::Asked, .offered = true},
                     {.title = "Goals", .stage = Stage::Asked}};
    const auto details = [this] { return stopLineOf(robot.face, robot.view).details.toStdString(); };
    EXPECT_THAT(details(), HasSubstr("E-stop has not confirmed yet. Nobody offers Goals."));
    EXPECT_THAT(details(), HasSubstr("drive commands of zero"));
    stop.services[1].message = "no permission";
    EXPECT_THAT(details(), HasSubstr("Goals cannot be called: no permission."));
    stop.services[1].message.clear();
    stop.services[0].refused = true;
    stop.services[0].message = "fuse blown";
    EXPECT_THAT(details(), HasSubstr("E-stop refuses: fuse blown."));
    EXPECT_EQ(stopLineOf(robot.face, robot.view).tone, Tone::Act);
    for (StopServiceStatus& service : stop.services)
        service = {.title = service.title, .stage = Stage::Stopped};
    EXPECT_THAT(details(), HasSubstr("2 services confirmed it."));
    stop.services.pop_back();
    EXPECT_THAT(details(), HasSubstr("E-stop confirmed it."));
    stop.sent = false;
    stop.releasing = true;
    stop.services[0].stage = Stage::Releasing;
    EXPECT_EQ(stopLineOf(robot.face, robot.view).stage, StopStage::Releasing);
    EXPECT_THAT(details(), HasSubstr("E-stop has not released yet."));
    EXPECT_FALSE(stopLineOf(robot.face, robot.view).releasable);
}

TEST_F(LiveWords, TheHintSaysWhatKeepsItFromMoving) {
    EXPECT_EQ(stateOf(robot).hint.toStdString(), "you drive");
    robot.view.drive.needsNeutral = true;
    EXPECT_EQ(stateOf(robot).hint.toStdString(), "sticks must be neutral first");
    EXPECT_EQ(stateOf(robot).hintTone, Tone::Attention);
    robot.view.drive.focus = false;
    EXPECT_THAT(stateOf(robot).hint.toStdString(), HasSubstr("not on this robot"));
    robot.view.drive.listening = false;
    EXPECT_THAT(stateOf(robot).hint.toStdString(), HasSubstr("does not hear"));
    robot.view.drive.reachable = true;
    EXPECT_THAT(stateOf(robot).hint.toStdString(), HasSubstr("not on this robot"))
        << "nobody sends anything that it could hear";
    setMode(robot, "victim_approach", true, "body heat in sight");
    EXPECT_EQ(stateOf(robot).hint.toStdString(), "body heat in sight");
    EXPECT_EQ(stateOf(robot).hintTone, Tone::Muted);
    robot.view.drive.drivable = false;
    EXPECT_EQ(stateOf(robot).hint.toStdString(), "takes no drive commands");
    EXPECT_EQ(stateOf(robot).grant.choice, Choice::None);
}

TEST_F(LiveWords, TheCapOnTheSpeedIsSaidInWordsAndTheOverrideAllTheTime) {
    SightCap& sight = robot.view.drive.sight;
    EXPECT_EQ(sightNote(robot.view.drive).toStdString(), "full speed");
    sight = {.factor = 0.2, .reason = SightReason::OldPicture, .age = 0.6};
    EXPECT_EQ(stateOf(robot).hint.toStdString(), "creep speed: the picture is 600 ms old");
    EXPECT_EQ(sightNote(robot.view.drive).toStdString(), "creep speed");
    sight = {.factor = 0.0, .reason = SightReason::FrozenPicture, .age = 2.4};
    EXPECT_EQ(stateOf(robot).hint.toStdString(),
              "held: it is the same picture for 2.4 s · hold G to drive without eyes");
    EXPECT_EQ(stateOf(robot).hintTone, Tone::Attention);
    EXPECT_EQ(sightNote(robot.view.drive).toStdString(), "held");
    robot.view.drive.needsNeutral = true;
    EXPECT_THAT(stateOf(robot).hint.toStdString(), HasSubstr("same picture"))
        << "neutral sticks would not help";
    robot.view.drive.needsNeutral = false;
    sight.overridden = true;
    sight.factor = 1.0;
    EXPECT_THAT(stateOf(robot).hint.toStdString(), HasSubstr("override: driving without eyes"));
    EXPECT_EQ(labelOf(robot).text.toStdString(), "TELEOPERATION · OVERRIDE") << "in the picture too";
    EXPECT_EQ(sightNote(robot.view.drive).toStdString(), "override: driving without eyes");
    sight = {.factor = 1.0, .reason = SightReason::ScanAlone, .age = 4.0};
    EXPECT_EQ(stateOf(robot).hint.toStdString(), "the picture is 4.0 s old: drive by the virtual scan");
    sight = {.factor = 0.0, .reason = SightReason::NoPicture};
    EXPECT_THAT(stateOf(robot).hint.toStdString(), HasSubstr("there is no picture"));
    sight = {.factor = 1.0, .reason = SightReason::NoEyes};
    EXPECT_EQ(stateOf(robot).hintTone, Tone::Muted);
    robot.view.drive.focus = false;
    EXPECT_TRUE(sightNote(robot.view.drive).isEmpty());
}

TEST_F(LiveWords, ChainsAreToldMeasuredOfCommanded) {
    EXPECT_TRUE(stateOf(robot).tracks.text.isEmpty()) << "wheels";
    robot.description.drive = DriveType::Tracked;
    robot.view.drive.velocity = {0.25, 0.0, 0.0};
    robot.view.joints = test::trackSpeeds({0.21, 0.24});
    robot.view.jointsAge = 0.1;
    EXPECT_EQ(stateOf(robot).tracks.text.toStdString(), "chains 0.21 of 0.25 · 0.24 of 0.25 m/s");
    EXPECT_EQ(stateOf(robot).tracks.tone, Tone::Muted);
    robot.view.joints = test::trackSpeeds({0.01, 0.24});
    EXPECT_EQ(stateOf(robot).tracks.note.toStdString(), "the left chain does not follow");
    EXPECT_EQ(stateOf(robot).tracks.tone, Tone::Attention);
    robot.view.joints = test::trackSpeeds({0.0, -0.1});
    EXPECT_EQ(stateOf(robot).tracks.note.toStdString(), "the chains do not follow");
    robot.view.jointsAge = 2.0;
    EXPECT_TRUE(stateOf(robot).tracks.text.isEmpty());
    robot.view.jointsAge = 0.1;
    robot.view.joints = test::trackSpeeds({});
    EXPECT_TRUE(stateOf(robot).tracks.text.isEmpty()) << "not told";
}

TEST_F(LiveWords, AGrantIsAskedForGivenUpAndAnswered) {
    GrantView grant;
    EXPECT_EQ(grantFiguresOf(grant).text.toStdString(), "drive control: free");
    grant.mine = true;
    EXPECT_EQ(grantFiguresOf(grant).choice, Choice::GiveUp);
    grant.requestedBy = "b";
    grant.requestedByTitle = "Van";
    EXPECT_EQ(grantFiguresOf(grant).choice, Choice::Answer);
    EXPECT_EQ(grantFiguresOf(grant).text.toStdString(), "Van requests drive control");
    grant = {};
    grant.holder = "b";
    grant.holderTitle = "Van";
    EXPECT_EQ(grantFiguresOf(grant).choice, Choice::Ask);
    EXPECT_EQ(grantFiguresOf(grant).text.toStdString(), "Van drives");
    grant.silent = true;
    EXPECT_THAT(grantFiguresOf(grant).text.toStdString(), HasSubstr("silent"));
    grant.lostTo = "b";
    EXPECT_EQ(grantFiguresOf(grant).tone, Tone::Attention);
    grant.asked = true;
    EXPECT_EQ(grantFiguresOf(grant).choice, Choice::Asked);
    grant.refusedBy = "b";
    EXPECT_EQ(grantFiguresOf(grant).choice, Choice::Ask);
    EXPECT_EQ(grantFiguresOf(grant).text.toStdString(), "Van keeps it");
}

TEST_F(LiveWords, FiguresAreMutedOrGoneWhenTheyAreOld) {
    EXPECT_EQ(stateOf(robot).speed.value.toStdString(), "0.42");
    EXPECT_EQ(stateOf(robot).turn.value.toStdString(), "−8");
    EXPECT_EQ(stateOf(robot, 2.0).speed.value, QString(QChar(0x2013)));
    EXPECT_FALSE(stateOf(robot, 2.0).attitude.known);
    EXPECT_EQ(stateOf(robot).gas.value.tone, Tone::Normal);
    EXPECT_EQ(stateOf(robot, 6.0).gas.value.tone, Tone::Muted);
    EXPECT_EQ(stateOf(robot, 6.0).gas.caption.toStdString(), "no data for 6 s");
    EXPECT_EQ(stateOf(robot, 12.0).battery.left.toStdString(), "no data for 12 s");
}

TEST_F(LiveWords, WhatIsNoNumberIsADash) {
    const QString dash(QChar(0x2013));
    test::editable(robot.reported.odometry).sample = test::odometryOf(Unknown, Unknown, Unknown, Unknown);
    test::editable(robot.reported.gas).sample.ppm = Unknown;
    test::editable(robot.reported.battery).sample = {};
    robot.view.around->obstacles = {{Eigen::Vector2d(Unknown, 1.0), 0.0}};
    robot.view.drive.velocity = {Unknown, 0.0, Unknown};
    const DriveState state = stateOf(robot);
    EXPECT_EQ(state.speed.value, dash);
    EXPECT_EQ(state.turn.value, dash);
    EXPECT_EQ(state.nearest.value, dash);
    EXPECT_EQ(state.gas.value.value, dash);
    EXPECT_EQ(state.battery.charge.value, dash);
    EXPECT_FALSE(state.attitude.known);
}

TEST_F(LiveWords, AttitudeWarnsBeforeItsLimits) {
    const auto toneAt = [this](double roll, double pitch) {
        test::editable(robot.reported.odometry).sample =
            test::odometryOf(0, 0, degrees(roll), degrees(pitch));
        return stateOf(robot).attitude.tone;
    };
    EXPECT_EQ(toneAt(6, -3), Tone::Normal);
    EXPECT_EQ(stateOf(robot).attitude.text.toStdString(), "roll 6° · pitch −3°");
    EXPECT_EQ(toneAt(-18, 0), Tone::Attention);
    EXPECT_EQ(toneAt(0, 23), Tone::Act);
    // the inertial unit is asked first, and as it is mounted
    robot.description.streams.emplace_back().role = StreamRole::Imu;
    robot.description.streams.back().sensor = "imu";
    robot.description.sensors["imu"].sensorInBase = poseFrom({0, 0, 0.1}, degrees(90), 0, 0);
    ImuSample imu;
    imu.orientation = Eigen::Quaterniond(poseFrom({0, 0, 0}, degrees(10), 0, 0.3).linear() *
                                         poseFrom({0, 0, 0}, degrees(90), 0, 0).linear());
    robot.reported.imu = latestPtr(Latest<ImuSample>{9, at(0), imu});
    EXPECT_NEAR(stateOf(robot).attitude.roll, degrees(10), 1e-9);
    EXPECT_NEAR(stateOf(robot).attitude.pitch, 0.0, 1e-9);
}

TEST_F(LiveWords, GasRisesFallsAndRaisesItsVoice) {
    EXPECT_EQ(stateOf(robot).gas.arrow.toStdString(), "↑");
    EXPECT_EQ(stateOf(robot).gas.value.value.toStdString(), "1,180");
    ValueTrend falling;
    for (int i = 0; i < 30; ++i) falling.add(at(i - 30), 2000.0 - 20.0 * i);
    EXPECT_NEAR(falling.risePerMinute(), -1200.0, 1e-6);
    ValueTrend steady;
    for (int i = 0; i < 300; ++i) steady.add(at(i - 300), 500.0);
    EXPECT_NEAR(steady.risePerMinute(), 0.0, 1e-9);
    EXPECT_LE(steady.samples(at(0)).size(), 121u);
    steady.add(at(-400), 800.0);
    EXPECT_EQ(steady.samples(at(-400)).size(), 1u) << "a clock that went back begins anew";
    test::editable(robot.reported.gas).sample.ppm = 2400;
    EXPECT_EQ(stateOf(robot).gas.value.tone, Tone::Attention);
}

TEST_F(LiveWords, ALogDoesNotTellWhatWasLost) {
    LinkStatus link;
    EXPECT_TRUE(lossShareText(link).isEmpty());
    link.streams.resize(2);
    link.streams[0].lossRatio = link.streams[1].lossRatio = std::numeric_limits<double>::quiet_NaN();
    EXPECT_TRUE(lossShareText(link).isEmpty()) << lossShareText(link).toStdString();
    link.streams[1].lossRatio = 0.04;
    EXPECT_EQ(lossShareText(link).toStdString(), "4\u202f% loss");
    StreamStatus& silent = link.streams.emplace_back();
    silent.lossRatio = 1.0;
    silent.stale = true;
    EXPECT_EQ(lossShareText(link).toStdString(), "4\u202f% loss") << "a silent camera is not the link's loss";
    link.streams.pop_back();
    link.streams[1].lossRatio = 0.0;
    EXPECT_EQ(lossShareText(link).toStdString(), "0\u202f% loss");
}

TEST_F(LiveWords, LinksSayTheWorstReason) {
    EXPECT_EQ(stateOf(robot).link.join(u" · ").toStdString(), "22 ms · 0\u202f% loss");
    robot.view.link.state = LinkState::Degraded;
    robot.view.link.reasons = {{LinkReason::Kind::Stale, 1.4, StreamRole::Odometry, {}, {}},
                               {LinkReason::Kind::Slow, 0.38, StreamRole::Diagnostics, {}, {}}};
    EXPECT_EQ(stateOf(robot).linkReason.toStdString(), "odometry 1.4 s old");
    EXPECT_EQ(stateOf(robot).linkTone, Tone::Attention);
    EXPECT_EQ(linkReasonText({LinkReason::Kind::Loss, 0.12, StreamRole::Points, {}, {}}).toStdString(),
              "12\u202f% of 3D scans lost");
    EXPECT_EQ(linkReasonText({LinkReason::Kind::Late, 2.0, StreamRole::Picture, "left", {}}).toStdString(),
              "left pictures 2.0 s late");
    EXPECT_EQ(linkReasonText({LinkReason::Kind::NoAnswer, 3.1, StreamRole::Pong, {}, {}}).toStdString(),
              "no answer for 3.1 s");
    EXPECT_EQ(linkReasonText({LinkReason::Kind::Silent, 3.1, StreamRole::Pong, {}, {}}).toStdString(),
              "silent for 3.1 s");
}

TEST_F(LiveWords, ChipsLeaveOutWordsButNeverModeAndBatteryOfARobotThatTalks) {
    const RobotChip chip = robotChipOf(robot.face, robot.view, robot.reported, at(0));
    EXPECT_EQ(chip.figures.first().toStdString(), "22 ms · 0\u202f% loss · 71\u202f%");
    EXPECT_TRUE(chip.figures.contains("22 ms · 71\u202f%")) << "that nothing is lost is no news";
    EXPECT_EQ(chip.figures.last().toStdString(), "71\u202f%");
    for (qsizetype i = 1; i < chip.figures.size(); ++i)
        EXPECT_LT(chip.figures[i].size(), chip.figures[i - 1].size());
    EXPECT_EQ(chip.modes, QStringList({"teleoperation", "teleop"}));
    robot.view.link.streams[0].lossRatio = 0.04;
    const RobotChip lossy = robotChipOf(robot.face, robot.view, robot.reported, at(0));
    EXPECT_EQ(lossy.figures.first().toStdString(), "22 ms · 4\u202f% loss · 71\u202f%");
    robot.view.link.state = LinkState::Lost;
    robot.view.link.silence = 4.2;
    const RobotChip lost = robotChipOf(robot.face, robot.view, robot.reported, at(0));
    EXPECT_EQ(lost.tone, Tone::Attention);
    EXPECT_EQ(lost.figures, QStringList({"4.2 s · 71\u202f%", "4.2 s"})) << "what it said last is old";
    EXPECT_EQ(lost.modes, QStringList({"link lost", "lost"}));
    EXPECT_THAT(lost.details.toStdString(), HasSubstr("silent for 4.2 s"));
}

}  // namespace
}  // namespace leitstand
