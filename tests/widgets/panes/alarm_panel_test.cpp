#include "widgets/alarms/alarm_panel.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <QListView>
#include <QSignalSpy>
#include <QTest>
#include <QToolButton>

#include "core/event/motion_samples.h"
#include "tests/widgets/panes/shown.h"
#include "widgets/drive/drive_strip.h"
#include "widgets/painting/theme.h"

namespace leitstand::test {
namespace {

std::vector<Alarm> alarms() {
    Alarm link, battery, gas, bump;
    link.cause = {{"kurt3d", alarm_key::LinkLost, ""}, AlarmSeverity::Act, 4.2};
    battery.cause = {{"crawler", alarm_key::Battery, ""}, AlarmSeverity::Attention, 7.0, "minutes"};
    gas.cause = {{"kurt3d", alarm_key::Gas, ""}, AlarmSeverity::Attention, 2'345.0};
    gas.acknowledged = true;
    bump.cause = {{"kurt3d", alarm_key::Bump, "front_left"}, AlarmSeverity::Attention, 1.0};
    link.since = at(-4);
    battery.since = at(-130);
    gas.since = at(-45);
    bump.since = at(-9);
    bump.ended = at(-3);
    return {link, battery, gas, bump};
}
std::vector<AlarmLine> lines() {
    return alarmLinesOf(alarms(), {{"kurt3d", "K", "Kurt3D", 0}, {"crawler", "C", "Crawler", 1}}, at(0));
}

class AlarmPanes : public testing::TestWithParam<Theme> {
protected:
    void SetUp() override { useTheme(GetParam()); }
    [[nodiscard]] QString named(const char* what) const {
        return QStringLiteral("alarms_%1_%2")
            .arg(QString::fromLatin1(what),
                 GetParam() == Theme::Dark ? QStringLiteral("dark") : QStringLiteral("light"));
    }
};

TEST_P(AlarmPanes, NothingIsColouredWhileAllIsCalm) {
    AlarmPanel panel;
    panel.show({}, {});
    const QImage calm = pictureOf(panel, {380, 190}, named("calm"));
    EXPECT_EQ(countOf(calm, coloursOf(GetParam()).attention), 0);
    EXPECT_EQ(countOf(calm, coloursOf(GetParam()).act), 0);
    EXPECT_FALSE(panel.findChild<QToolButton*>("acknowledge")->isEnabled());
}

TEST_P(AlarmPanes, AnAlarmIsToldByShapeColourAndWords) {
    AlarmPanel panel;
    panel.show(lines(), QStringLiteral("muted for 48 s"));
    const QImage loud = pictureOf(panel, {380, 190}, named("loud"));
    EXPECT_GT(countOf(loud, coloursOf(GetParam()).act), 40);
    EXPECT_GT(countOf(loud, coloursOf(GetParam()).attention), 40);
    static_cast<void>(pictureOf(panel, {380, 190}, named("loud_2x"), 2.0));
    EXPECT_TRUE(textFaults(panel).isEmpty()) << textFaults(panel).join('\n').toStdString();
    EXPECT_THAT(panel.findChild<QToolButton*>("mute")->text().toStdString(), testing::HasSubstr("48 s"));
}

TEST_P(AlarmPanes, AChosenOneIsAcknowledgedByReturnTheNewestByTheButton) {
    AlarmPanel panel;
    panel.show(lines(), {});
    panel.resize(380, 190);
    panel.QWidget::show();
    QSignalSpy one(&panel, &AlarmPanel::acknowledged), newest(&panel, &AlarmPanel::newestAcknowledged),
        mute(&panel, &AlarmPanel::muteToggled);
    auto* list = panel.findChild<QListView*>("alarms");
    list->setCurrentIndex(list->model()->index(1, 0));
    QTest::keyClick(list, Qt::Key_Return);
    ASSERT_EQ(one.count(), 1);
    EXPECT_EQ(one.at(0).at(0).value<AlarmId>().robot, "crawler");
    QTest::mouseClick(panel.findChild<QToolButton*>("acknowledge"), Qt::LeftButton);
    QTest::mouseClick(panel.findChild<QToolButton*>("mute"), Qt::LeftButton);
    EXPECT_EQ(newest.count(), 1);
    EXPECT_EQ(mute.count(), 1);
}

TEST_P(AlarmPanes, TheStripTellsChainsCapAndOverride) {
    SampleRobot crawler = sampleRobot("C", "Crawler", 1);
    crawler.description.drive = DriveType::Tracked;
    crawler.view.joints = trackSpeeds({0.41, 0.40});
    crawler.view.jointsAge = 0.1;
    crawler.view.drive.sight = {.factor = 0.0, .reason = SightReason::FrozenPicture, .age = 2.4};
    DriveStrip strip;
    strip.show(driveStateOf(crawler));
    for (const auto& [size, name] :
         {std::pair(QSize(900, 190), "strip"), std::pair(QSize(820, 190), "small")}) {
        static_cast<void>(pictureOf(strip, size, named(name)));
        EXPECT_TRUE(textFaults(strip).isEmpty()) << textFaults(strip).join('\n').toStdString();
    }
    crawler.view.drive.sight.overridden = true;
    crawler.view.joints = trackSpeeds({0.0, 0.4});
    strip.show(driveStateOf(crawler));
    static_cast<void>(pictureOf(strip, {900, 190}, named("override")));
}

INSTANTIATE_TEST_SUITE_P(Themes, AlarmPanes, testing::Values(Theme::Dark, Theme::Light),
                         [](const auto& one) { return one.param == Theme::Dark ? "Dark" : "Light"; });

}  // namespace
}  // namespace leitstand::test
