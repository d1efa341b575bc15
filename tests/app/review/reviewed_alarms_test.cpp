#include <gtest/gtest.h>

#include "app/services/review/reviewed_robot.h"
#include "core/mission/state/session_state.h"
#include "tests/app/review/written_mission.h"

namespace leitstand::test {
namespace {

/// A mission in which each of @p reported was raised, the last one newest.
MissionState raised(const std::vector<AlarmSample>& reported) {
    MissionState state;
    std::uint64_t sequence = 0;
    for (const AlarmSample& alarm : reported)
        state.alarms.edit()[{alarm.station, alarm.robot, alarm.key}] = {++sequence, sequence, 1, alarm};
    return state;
}

AlarmSample sample(double seconds, const std::string& robot, const std::string& key, const std::string& text,
                   AlarmSample::State state = AlarmSample::State::Raised) {
    AlarmSample alarm;
    alarm.stamp = WrittenMission::at(seconds);
    alarm.station = "test";
    alarm.robot = robot;
    alarm.key = key;
    alarm.state = state;
    alarm.text = text;
    return alarm;
}

TEST(ReviewedAlarms, HaveWhatTheWindowsLanguageNeeds) {
    const auto alarms = reviewedAlarms(
        raised({sample(1.0, "kurt3d", "battery", "Kurt3D: battery 18 %, 7 min left"),
                sample(2.0, "kurt3d", "diagnostics/motor_driver", "Kurt3D: motor_driver: hot"),
                sample(3.0, "", "disk_full", "/m/a.db3: the disk is full; 64 MB wait in memory")}),
        WrittenMission::at(5.0));
    ASSERT_EQ(alarms.size(), 3U);
    EXPECT_EQ(alarms[0].cause.id, (AlarmId{"", alarm_key::Log, "disk_full"})) << "newest first";
    EXPECT_EQ(alarms[0].cause.note, "/m/a.db3: the disk is full; 64 MB wait in memory");
    EXPECT_EQ(alarms[1].cause.id, (AlarmId{"kurt3d", alarm_key::Diagnostics, "motor_driver"}));
    EXPECT_EQ(alarms[1].cause.note, "hot");
    EXPECT_EQ(alarms[2].cause.value, 7.0);
    EXPECT_EQ(alarms[2].cause.note, "minutes");
}

TEST(ReviewedAlarms, WhatEndedIsShownForAWhileWithWhatItSaidThen) {
    const MissionState state =
        raised({sample(3.0, "", "disk_slow", "/m/a.db3: the disk keeps up again; 9 pictures were dropped",
                       AlarmSample::State::Cleared)});
    const auto alarms = reviewedAlarms(state, WrittenMission::at(5.0));
    ASSERT_EQ(alarms.size(), 1U);
    EXPECT_TRUE(alarms[0].ended);
    EXPECT_EQ(alarms[0].cause.id.detail, "disk_slow");
    EXPECT_TRUE(reviewedAlarms(state, WrittenMission::at(60.0)).empty());
}

}  // namespace
}  // namespace leitstand::test
