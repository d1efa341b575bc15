// Files of the home that an earlier program left: what is read of them, and that nothing of them is lost when
// they are written again.
#include <filesystem>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <QApplication>
#include <QMainWindow>
#include <QSettings>

#include "app/services/layouts/layout_book.h"
#include "app/services/pad/pad_memory.h"
#include "app/services/station/last_station.h"
#include "app/window/scans/scans_window.h"
#include "core/event/station_samples.h"
#include "core/io/pad/pad_file.h"
#include "core/io/robot/brake_file.h"
#include "core/io/robot/robot_file.h"
#include "core/io/robot/shipped_robots.h"
#include "core/io/settings/alarm_file.h"
#include "core/io/settings/last_station_file.h"
#include "core/io/settings/layout_file.h"
#include "core/io/settings/score_file.h"
#include "core/io/settings/station_file.h"
#include "tests/compat/compat_home.h"
#include "tests/compat/lines.h"
#include "tests/compat/open_window.h"

namespace leitstand::test {
namespace {

namespace fs = std::filesystem;

class CompatFiles : public CompatHome {
protected:
    /// "key = value" of each setting.
    [[nodiscard]] static std::map<std::string, std::string> settings() {
        const QSettings file(QString::fromStdString((config() / "leitstand.ini").string()),
                             QSettings::IniFormat);
        std::map<std::string, std::string> found;
        for (const QString& key : file.allKeys()) {
            const QVariant value = file.value(key);
            QString text = value.toString();
            if (value.typeId() == QMetaType::QByteArray)
                text = QString::fromLatin1(value.toByteArray().toBase64());
            if (value.typeId() == QMetaType::QStringList) text = value.toStringList().join(u'|');
            found[key.toStdString()] = text.toStdString();
        }
        return found;
    }
    [[nodiscard]] std::string writtenTo(const std::string& name) const { return readText(m_folder / name); }
};

TEST_F(CompatFiles, EverySettingIsReadAndWritten) {
    const auto before = settings();
    const WindowState state = loadWindowState();
    fs::remove(config() / "leitstand.ini");  // what was not read is not there any more
    saveWindowState(state);
    const auto after = settings();
    for (const auto& [key, value] : before) {
        ASSERT_TRUE(after.contains(key)) << "the setting " << key << " is lost";
        EXPECT_EQ(after.at(key), value) << "the setting " << key;
    }
    std::vector<std::string> keys;
    for (const auto& [key, value] : after) keys.push_back(key);
    EXPECT_THAT(goneFrom("settings-keys.txt", keys), testing::IsEmpty()) << "gone, though the list has it";
}

TEST_F(CompatFiles, NoSettingIsTheDefault) {
    const auto changed = settings();
    saveWindowState(WindowState{});
    const auto defaults = settings();
    for (const auto& [key, value] : changed) {
        if (key == "window/version") continue;  // is what it is
        EXPECT_NE(defaults.at(key), value) << key << " would not be missed";
    }
}

TEST_F(CompatFiles, TheScansWindowTakesAllSettingsAndGivesThemBack) {
    const auto before = settings();
    const auto run = [] {
        showScansWindow({}, loadWindowState());
        return QApplication::exec();
    };
    ASSERT_EQ(whileOpen(run, [](QMainWindow&) {}), 0);
    const auto after = settings();
    for (const auto& [key, value] : before) {
        if (key.starts_with("window/")) continue;  // tells the screen, too
        EXPECT_EQ(after.at(key), value) << key;
    }
}

TEST_F(CompatFiles, LayoutsAreReadAndWrittenTheSame) {
    std::vector<std::string> errors;
    const auto layouts = LayoutBook().all(errors);
    EXPECT_THAT(errors, testing::IsEmpty());
    std::vector<std::string> titles;
    for (const WindowLayout& layout : layouts) titles.push_back(layout.title);
    EXPECT_THAT(titles, testing::IsSupersetOf({"Bench, left desk", "Swapped", "Plan überall", "Jury"}));
    int files = 0;
    for (const auto& entry : fs::directory_iterator(config() / "layouts")) {
        const auto layout = readLayout(entry.path());
        ASSERT_TRUE(layout) << layout.error().text;
        EXPECT_EQ(writeLayout(*layout), readText(entry.path())) << entry.path();
        ++files;
    }
    EXPECT_EQ(files, 4);
    const WindowLayout bench = LayoutBook().find("bench-left-desk").value();
    EXPECT_EQ(bench.pad.at("y"), "view.swap");
}

TEST_F(CompatFiles, PadsAreReadAndWrittenTheSame) {
    const PadMemory pads(config() / "pads");
    std::string warning;
    const std::string xbox = "030000005e0400008e02000010010000", plain = "0300000079000000";
    const PadBindings bindings = pads.bindings(xbox, PadLayout::Standard, warning);
    EXPECT_EQ(warning, "");
    EXPECT_EQ(padText(bindings, "Xbox 360 Controller"), readText(kept("pads/" + xbox + ".yaml")));
    EXPECT_EQ(padText(pads.bindings(plain, PadLayout::Plain, warning), "Plain joystick"),
              readText(kept("pads/" + plain + ".yaml")));
    EXPECT_EQ(warning, "");
    EXPECT_EQ(bindings.deadZone, 0.2);
    EXPECT_EQ(controlOf(bindings, "view.swap"), padButton(9));
}

TEST_F(CompatFiles, RobotsAreReadAndWrittenTheSame) {
    const auto file = findRobotFile("tb9");
    ASSERT_TRUE(file) << file.error().text;
    EXPECT_EQ(*file, config() / "robots/tb9.yaml") << "the operator's own folder";
    const auto robot = readRobot(*file);
    ASSERT_TRUE(robot) << robot.error().text;
    EXPECT_EQ(robot->title, "My TurtleBot");
    EXPECT_EQ(writeRobot(*robot), readText(*file));
    for (const auto& entry : fs::directory_iterator(m_mission / "robots")) {
        const auto kept = readRobot(entry.path());
        ASSERT_TRUE(kept) << kept.error().text;
        EXPECT_EQ(writeRobot(*kept), readText(entry.path())) << entry.path();
    }
}

TEST_F(CompatFiles, StationBrakesAndLastStationAreReadAndWrittenTheSame) {
    const auto station = parseStation(readText(config() / "station.yaml"));
    ASSERT_TRUE(station);
    EXPECT_THAT(readText(config() / "station.yaml"), testing::HasSubstr("station: " + station->id + "\n"));
    EXPECT_EQ(station->held.size(), 1U);
    EXPECT_EQ(station->held.front().id.kind, GrantSample::Kind::Map);
    ASSERT_TRUE(writeBrakes(m_folder / "brakes.yaml", readBrakes(config() / "brakes.yaml")));
    EXPECT_EQ(writtenTo("brakes.yaml"), readText(kept("brakes.yaml")));
    const auto last = lastStation(config() / "live.yaml");
    ASSERT_TRUE(last);
    rememberStation(m_folder / "live.yaml", *last);
    EXPECT_EQ(writtenTo("live.yaml"), readText(kept("live.yaml")));
}

TEST_F(CompatFiles, LimitsOfAlarmsAndScoresAreRead) {
    const auto limits = readAlarmLimits(config() / "alarms.yaml");
    ASSERT_TRUE(limits) << limits.error().text;
    EXPECT_DOUBLE_EQ(limits->gas, 900.0);
    EXPECT_DOUBLE_EQ(limits->attitude, 0.61);
    EXPECT_DOUBLE_EQ(limits->attitudeAct, 0.81);
    EXPECT_DOUBLE_EQ(limits->batteryMinutes, 12.0);
    EXPECT_DOUBLE_EQ(limits->batteryMinutesAct, 4.0);
    EXPECT_DOUBLE_EQ(limits->batteryShare, 0.25);
    EXPECT_DOUBLE_EQ(limits->batteryShareAct, 0.09);
    EXPECT_DOUBLE_EQ(limits->unanswered, 3.0);
    EXPECT_DOUBLE_EQ(limits->frozen, 2.5);
    EXPECT_DOUBLE_EQ(limits->clock, 1.5);
    const ScoreProfiles profiles = scoreProfiles();
    EXPECT_THAT(profiles.problems, testing::IsEmpty());
    const ScoreProfile* const club = profiles.find("club");
    ASSERT_NE(club, nullptr);
    EXPECT_EQ(club->name, "club");
}

}  // namespace
}  // namespace leitstand::test
