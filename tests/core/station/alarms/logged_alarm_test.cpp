#include "core/station/alarms/logged_alarm.h"

#include <cmath>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/event/station_samples.h"
#include "core/station/alarms/log_format.h"

namespace leitstand {
namespace {

using testing::ElementsAre;

AlarmCause read(const std::string& key, const std::string& text) {
    AlarmSample reported;
    reported.robot = "kurt3d";
    reported.key = key;
    reported.text = text;
    return loggedCause(reported);
}

TEST(LoggedAlarm, FiguresComeFromTheText) {
    EXPECT_DOUBLE_EQ(read("link_lost", "Kurt3D: link lost, silent for 4 s").value, 4.0);
    EXPECT_DOUBLE_EQ(read("link_lost", "link lost, silent for 4 s").value, 4.0) << "nobody named";
    EXPECT_DOUBLE_EQ(read("attitude", "A: roll 18, pitch -3 degrees: 72 % of where it tips over").value,
                     0.72);
    EXPECT_DOUBLE_EQ(read("clock_offset", "A: its clock is 9.0 s behind the station's").value, -9.0);
    EXPECT_DOUBLE_EQ(read("uncertain_scan", "1 uncertain scan to be decided on").value, 1.0);
    EXPECT_DOUBLE_EQ(read("uncertain_scan", "2 uncertain scans to be decided on").value, 2.0);
    EXPECT_DOUBLE_EQ(read("wheels_spin", "A: its wheels turned for 0.8 m, the map says it stands").value,
                     0.8);
    const AlarmCause minutes = read("battery", "A: battery, 7 min left");
    EXPECT_DOUBLE_EQ(minutes.value, 7.0);
    EXPECT_EQ(minutes.note, "minutes");
}

TEST(LoggedAlarm, WhoItIsOfComesFromTheKey) {
    EXPECT_EQ(read("bump/front_left", "A: bumped: front_left").id,
              (AlarmId{"kurt3d", alarm_key::Bump, "front_left"}));
    EXPECT_EQ(read("diagnostics/drive/left", "A: drive/left: hot").id.detail, "drive/left");
    EXPECT_EQ(read("", "").id, (AlarmId{"kurt3d", "", ""}));
    EXPECT_EQ(read("/", "").id, (AlarmId{"kurt3d", "", ""}));
}

TEST(LoggedAlarm, APartMaySayItsOwnName) {
    EXPECT_EQ(read("diagnostics/motor", "A: motor: motor: 90 degrees").note, "motor: 90 degrees");
    EXPECT_EQ(read("diagnostics/motor", "A: something else").note, "");
}

TEST(LoggedAlarm, WhatCannotBeReadStaysUnknown) {
    const std::string huge(1'000'000, ':');
    std::string nearly;
    for (int i = 0; i < 100'000; ++i) nearly += "CO2 : ";
    for (const char* key : {"link_lost", "attitude", "roll_over", "battery", "gas", "stop_unanswered",
                            "frozen_picture/left", "clock_offset", "uncertain_scan", "what_is_this"}) {
        for (const std::string& text :
             {std::string(), std::string(": "), std::string("Kurt3D"), huge, nearly + "ppm",
              std::string("A: link lost, silent for nan s"), std::string("A: link lost, silent for inf s"),
              std::string("A: CO2  ppm"), std::string("A: battery nan %"), std::string("A: battery")}) {
            const AlarmCause cause = read(key, text);
            EXPECT_TRUE(std::isnan(cause.value)) << key << ": " << text.substr(0, 40);
            EXPECT_EQ(cause.note, "") << key;
            EXPECT_EQ(cause.text, text);
        }
    }
    for (const char* key : {"link_degraded", "grant_lost"}) EXPECT_EQ(read(key, huge).note, "");
}

TEST(LoggedAlarm, ThoseOfTheLogAreOfTheStation) {
    for (const char* key : {"disk_filling", "disk_slow", "disk_full", "events_lost", "log_failed"}) {
        EXPECT_TRUE(isAlarmOfLog(key));
        const AlarmCause cause = read(key, "/m/a.db3: disk I/O error");
        EXPECT_EQ(cause.id, (AlarmId{"", alarm_key::Log, key}));
        EXPECT_EQ(cause.note, "/m/a.db3: disk I/O error");
    }
    EXPECT_FALSE(isAlarmOfLog("link_lost"));
    EXPECT_FALSE(isAlarmOfLog(""));
}

TEST(LoggedAlarm, CodesAreReadAgain) {
    const AlarmCause battery = read("battery", "battery value=7.5 note=minutes percent=12");
    EXPECT_DOUBLE_EQ(battery.value, 7.5);
    EXPECT_EQ(battery.note, "minutes");
    EXPECT_EQ(read("diagnostics/motor", R"(diagnostics note="motor: \"hot\"")").note, "motor: \"hot\"");
    EXPECT_TRUE(std::isnan(read("gas", "gas value=nan").value));
    EXPECT_TRUE(std::isnan(read("gas", "battery value=7").value)) << "of another alarm";
    EXPECT_TRUE(std::isnan(read("gas", "gas value=\"7").value));
}

TEST(LogSays, NewsAreKnownAgainWithTheirFigures) {
    for (const LogPhrase& phrase : log_format::All) {
        const std::string old = withValues(phrase.words, {"1", "2.5", "3"});
        EXPECT_STREQ(log_format::newsIn("/a: b/c.db3: " + old).phrase->code, phrase.code);
        EXPECT_STREQ(log_format::newsIn(old).phrase->code, phrase.code);
    }
    EXPECT_THAT(log_format::newsIn("/a.db3: the disk is full in 8 minutes at 3.2 MB/s").values,
                ElementsAre("8", "3.2"));
    const std::string coded = log_format::about("/a b.db3", log_format::DiskFilling, "8", "3.2");
    EXPECT_EQ(coded, "disk_filling minutes=8 megabytes_per_second=3.2 file=\"/a b.db3\"");
    EXPECT_THAT(log_format::newsIn(coded).values, ElementsAre("8", "3.2"));
    EXPECT_EQ(log_format::message(coded), "/a b.db3: the disk is full in 8 minutes at 3.2 MB/s");
    EXPECT_EQ(log_format::message("/a.db3: disk I/O error"), "/a.db3: disk I/O error");
}

TEST(LogSays, OthersAreNone) {
    for (const char* reported : {"", "/a.db3", "/a.db3: disk I/O error", "/a.db3: the disk is full",
                                 "/a.db3: the disk is full in nan minutes at 1 MB/s",
                                 "/a.db3: the disk is full in 8 minutes at  MB/s", "disk_filling minutes=8",
                                 "disk_filling minutes=soon megabytes_per_second=1"})
        EXPECT_FALSE(log_format::newsIn(reported).phrase) << reported;
}

}  // namespace
}  // namespace leitstand
