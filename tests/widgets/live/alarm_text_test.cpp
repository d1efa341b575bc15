#include "widgets/models/live/texts/alarm_text.h"

#include <limits>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <QLocale>
#include <QSignalSpy>

#include "tests/widgets/live/sample_robot.h"
#include "widgets/models/live/alarm_list_model.h"

namespace leitstand {
namespace {

using test::at;

class AlarmWords : public testing::Test {
protected:
    void SetUp() override { QLocale::setDefault(QLocale(QLocale::English, QLocale::UnitedStates)); }
    [[nodiscard]] static std::string textOf(const char* key, double value, const char* detail = "",
                                            const char* note = "") {
        return alarmText({{"kurt3d", key, detail}, AlarmSeverity::Act, value, note, {}, "Kurt3D: in English"})
            .toStdString();
    }
    [[nodiscard]] static Alarm alarm(AlarmSeverity severity, const char* robot = "kurt3d") {
        Alarm one;
        one.cause = {{robot, alarm_key::LinkLost, ""}, severity, 4.4};
        one.since = at(-12.0);
        return one;
    }
    const std::vector<RobotFace> faces{{"kurt3d", "K", "Kurt3D", 0}, {"crawler", "C", "Crawler", 1}};
};

TEST_F(AlarmWords, NoKeyIsForgotten) {
    for (const std::string_view key : alarm_key::All) {
        const AlarmCause cause{
            {"kurt3d", std::string(key), "part"}, AlarmSeverity::Act, 1.0, "note", {}, "as logged"};
        EXPECT_NE(alarmText(cause), QStringLiteral("as logged")) << key << " has no words: alarm_text.cpp";
    }
}

TEST_F(AlarmWords, EachKeyHasItsOwn) {
    EXPECT_EQ(textOf(alarm_key::Attitude, 0.72), "tilted: 72 % of where it tips over");
    EXPECT_EQ(textOf(alarm_key::RollOver, 1.4835), "rolled over, tilted by 85°");
    EXPECT_EQ(textOf(alarm_key::LinkLost, 4.4), "link lost, silent for 4 s");
    EXPECT_EQ(textOf(alarm_key::LinkDegraded, 0, "", "round trip 380 ms"), "link: slow: 380 ms");
    EXPECT_EQ(textOf(alarm_key::LinkDegraded, 0, "", "left pictures 2.0 s late"),
              "link: left pictures 2.0 s late");
    EXPECT_EQ(textOf(alarm_key::LinkDegraded, 0, "", "degraded"), "link: degraded");
    EXPECT_EQ(textOf(alarm_key::Battery, 7.2, "", "minutes"), "battery: 7 min left");
    EXPECT_EQ(textOf(alarm_key::Battery, 0.18, "", "share"), "battery: 18 % left");
    EXPECT_EQ(textOf(alarm_key::Gas, 2345), "CO₂ 2,345 ppm");
    EXPECT_EQ(textOf(alarm_key::Reading, 46.26, "Air", "°C"), "Air: 46.3 °C");
    EXPECT_EQ(textOf(alarm_key::Reading, -std::numeric_limits<double>::infinity(), "Sonar", "m"),
              "Sonar: −∞ m");
    EXPECT_EQ(textOf(alarm_key::Bump, 0.3, "front_left"), "bumped: front left");
    EXPECT_EQ(textOf(alarm_key::WheelsSpin, 0.84), "wheels turned for 0.8 m, the map says it stands");
    EXPECT_EQ(textOf(alarm_key::Diagnostics, 0, "motor_driver", "hot"), "motor driver: hot");
    EXPECT_EQ(textOf(alarm_key::Diagnostics, 0, "motor_driver", ""), "motor driver") << "it says no more";
    EXPECT_EQ(textOf(alarm_key::StopUnanswered, 3.1), "does not answer STOP for 3 s");
    EXPECT_EQ(textOf(alarm_key::FrozenPicture, 12.9, "left"), "camera left repeats one picture for 12 s");
    EXPECT_EQ(textOf(alarm_key::GrantLost, 0, "", "Van"), "drive control was lost to Van");
    EXPECT_EQ(textOf(alarm_key::ClockOffset, -3.0), "its clock is 3.0 s behind");
    EXPECT_EQ(textOf(alarm_key::UncertainScan, 2), "uncertain scans to be decided on: 2");
    EXPECT_EQ(textOf(alarm_key::Log, 0, "disk_full", "the disk is full"), "log: the disk is full");
    EXPECT_EQ(textOf(alarm_key::Log, 0, "disk_slow", "/missions/a/a_0.db3: the disk does not keep up: 2 s"),
              "log: the disk does not keep up: 2 s");
    EXPECT_EQ(textOf("what_is_this", 0), "Kurt3D: in English");
}

TEST_F(AlarmWords, WhatARobotSaysStaysOnItsLineAndTurnsNothing) {
    Alarm reported = alarm(AlarmSeverity::Attention);
    reported.cause.id = {"kurt3d", alarm_key::Diagnostics, "motor"};
    reported.cause.note = "hot\nSTOP \u202ecold";
    const auto lines = alarmLinesOf({reported}, faces, at(0.0));
    ASSERT_EQ(lines.size(), 1U);
    EXPECT_EQ(lines[0].text.toStdString(), "motor: hot\\nSTOP \\u202ecold");
}

TEST_F(AlarmWords, TheDiskTellsItsFiguresAsTheLanguageWritesThem) {
    EXPECT_EQ(textOf(alarm_key::Log, 0, "disk_filling",
                     "/missions/a/a_0.db3: the disk is full in 8 minutes at 1234.5 MB/s"),
              "log: the disk is full in 8 minutes at 1,234.5 MB/s");
    EXPECT_EQ(textOf(alarm_key::Log, 0, "disk_slow",
                     "/a: the disk does not keep up: 2.1 s behind, 64 MB wait, 12345 pictures dropped"),
              "log: the disk does not keep up: 2.1 s behind, 64 MB wait, 12,345 pictures dropped");
    EXPECT_EQ(textOf(alarm_key::Log, 0, "events_lost", "/a: 1500 events that are no pictures are lost"),
              "log: 1,500 events that are no pictures are lost");
    EXPECT_EQ(textOf(alarm_key::Log, 0, "disk_full", "/a: there is space on the disk again"),
              "log: there is space on the disk again");
    EXPECT_EQ(textOf(alarm_key::Log, 0, "disk_filling", "/a: the disk is full in soon minutes at 1 MB/s"),
              "log: the disk is full in soon minutes at 1 MB/s");
    EXPECT_EQ(textOf(alarm_key::Log, 0, "log_failed", "/a: disk I/O error"), "log: disk I/O error");
    EXPECT_EQ(textOf(alarm_key::Log, 0, "log_failed"), "log: log failed");
    QLocale::setDefault(QLocale(QLocale::German, QLocale::Germany));
    EXPECT_EQ(textOf(alarm_key::Log, 0, "disk_full", "/a: the disk is full; 1512 MB wait in memory"),
              "log: the disk is full; 1.512 MB wait in memory");
    QLocale::setDefault(QLocale(QLocale::English, QLocale::UnitedStates));
}

TEST_F(AlarmWords, WithoutItsNumbersAnAlarmSaysWhatWasLogged) {
    constexpr double Nan = std::numeric_limits<double>::quiet_NaN();
    for (const char* key : {alarm_key::Attitude, alarm_key::RollOver, alarm_key::LinkLost, alarm_key::Battery,
                            alarm_key::Gas, alarm_key::StopUnanswered, alarm_key::FrozenPicture,
                            alarm_key::ClockOffset, alarm_key::UncertainScan, alarm_key::WheelsSpin,
                            alarm_key::LinkDegraded, alarm_key::Diagnostics, alarm_key::GrantLost})
        EXPECT_EQ(textOf(key, Nan), "in English") << key << ": the robot is named beside it";
    EXPECT_EQ(textOf("what_is_this", Nan), "Kurt3D: in English");
    EXPECT_EQ(alarmText({{"", alarm_key::LinkLost, ""}, AlarmSeverity::Act, Nan, "", {}, "link: gone"}),
              QStringLiteral("link: gone"));
    EXPECT_EQ(alarmText({{"kurt3d", alarm_key::LinkLost, ""}, AlarmSeverity::Act, Nan}),
              QStringLiteral("link lost"));
}

TEST_F(AlarmWords, ALineSaysWhoseHowLoudAndForHowLong) {
    auto lines = alarmLinesOf({alarm(AlarmSeverity::Act), alarm(AlarmSeverity::Attention, "")}, faces, at(0));
    ASSERT_EQ(lines.size(), 2u);
    EXPECT_EQ(lines[0].face.letter.toStdString(), "K");
    EXPECT_EQ(lines[0].since.toStdString(), "12 s");
    EXPECT_EQ(lines[0].tone, Tone::Act);
    EXPECT_EQ(lines[0].stage, AlarmStage::Standing);
    EXPECT_TRUE(lines[1].face.letter.isEmpty()) << "of the station";
    EXPECT_EQ(lines[1].tone, Tone::Attention);
    Alarm one = alarm(AlarmSeverity::Act);
    one.acknowledged = true;
    EXPECT_EQ(alarmLinesOf({one}, faces, at(0))[0].tone, Tone::Muted);
    one.acknowledged = false;
    one.ended = at(-3.0);
    lines = alarmLinesOf({one}, faces, at(0));
    EXPECT_EQ(lines[0].stage, AlarmStage::Over);
    EXPECT_EQ(lines[0].since.toStdString(), "over for 3 s");
    EXPECT_EQ(lines[0].tone, Tone::Normal) << "it waits to be acknowledged, but nothing burns";
}

TEST_F(AlarmWords, TheMuteCountsDown) {
    EXPECT_EQ(muteText(at(48), at(0.4)).toStdString(), "muted for 48 s");
    EXPECT_TRUE(muteText(at(48), at(48)).isEmpty());
    EXPECT_TRUE(muteText({}, at(0)).isEmpty());
}

TEST_F(AlarmWords, TheListKeepsItsRowsWhileNumbersChange) {
    AlarmListModel model;
    QSignalSpy reset(&model, &QAbstractItemModel::modelReset),
        changed(&model, &QAbstractItemModel::dataChanged);
    model.setLines(alarmLinesOf({alarm(AlarmSeverity::Act)}, faces, at(0)));
    EXPECT_EQ(reset.count(), 1);
    model.setLines(alarmLinesOf({alarm(AlarmSeverity::Act)}, faces, at(5)));
    EXPECT_EQ(reset.count(), 1);
    EXPECT_EQ(changed.count(), 1);
    EXPECT_EQ(model.index(0).data().toString().toStdString(), "link lost, silent for 4 s");
    EXPECT_EQ(model.index(0).data(Qt::AccessibleTextRole).toString().toStdString(),
              "Act · Kurt3D: link lost, silent for 4 s · 17 s");
    EXPECT_EQ(model.line(1), nullptr);
}

}  // namespace
}  // namespace leitstand
