#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <QListView>
#include <QRegularExpression>
#include <QToolButton>

#include "app/language/language.h"
#include "core/station/alarms/log_format.h"
#include "tests/widgets/panes/shown.h"
#include "widgets/alarms/alarm_panel.h"

namespace leitstand::test {
namespace {

const std::vector<RobotFace>& team() {
    static const std::vector<RobotFace> faces = {{"kurt3d", "K", "Kurt3D", 0},
                                                 {"crawler", "C", "Crawler", 1}};
    return faces;
}

/// Alarms of every kind, with the longest figures and words that they have.
std::vector<Alarm> everyAlarm() {
    using Severity = AlarmSeverity;
    std::vector<AlarmCause> causes = {
        {{"kurt3d", alarm_key::Attitude, ""}, Severity::Attention, 0.97, ""},
        {{"kurt3d", alarm_key::RollOver, ""}, Severity::Act, 3.1, ""},
        {{"kurt3d", alarm_key::LinkLost, ""}, Severity::Act, 98.0, ""},
        {{"kurt3d", alarm_key::Battery, ""}, Severity::Attention, 10.0, "minutes"},
        {{"crawler", alarm_key::Battery, ""}, Severity::Act, 0.18, "share"},
        {{"crawler", alarm_key::Gas, ""}, Severity::Attention, 12'345.0, ""},
        {{"crawler", alarm_key::Bump, "front_left"}, Severity::Attention, 0.3, ""},
        {{"kurt3d", alarm_key::WheelsSpin, ""}, Severity::Attention, 98.7, ""},
        {{"kurt3d", alarm_key::Diagnostics, "motor_driver"}, Severity::Act, 0.0, "hot, 87 degrees"},
        {{"kurt3d", alarm_key::StopUnanswered, ""}, Severity::Act, 98.0, ""},
        {{"kurt3d", alarm_key::FrozenPicture, "left"}, Severity::Attention, 98.0, ""},
        {{"crawler", alarm_key::FrozenPicture, "ir"}, Severity::Attention, 98.0, ""},
        {{"kurt3d", alarm_key::GrantLost, ""}, Severity::Attention, 0.0, "Second station"},
        {{"kurt3d", alarm_key::ClockOffset, ""}, Severity::Attention, 3'600.4, ""},
        {{"crawler", alarm_key::ClockOffset, ""}, Severity::Attention, -3'600.4, ""},
        {{"", alarm_key::UncertainScan, ""}, Severity::Attention, 12.0, ""},
    };
    const std::string reasons[] = {"round trip 380 ms", "left pictures 2.0 s late", "odometry 1.4 s old"};
    for (const std::string& reason : reasons)
        causes.push_back({{"kurt3d", alarm_key::LinkDegraded, reason}, Severity::Attention, 0.0, reason});
    for (const LogPhrase& phrase : log_format::All) {
        const QString note =
            QString::fromUtf8(phrase.words).replace(QStringLiteral("{}"), QStringLiteral("128.5"));
        causes.push_back({{"", alarm_key::Log, phrase.code}, Severity::Act, 0.0, note.toStdString()});
    }
    std::vector<Alarm> alarms;
    for (const AlarmCause& cause : causes) {
        Alarm one;
        one.cause = cause;
        one.since = at(-3'700);
        alarms.push_back(one);
    }
    return alarms;
}

QString withoutBlanks(QString text) {
    return text.remove(QRegularExpression(QStringLiteral("\\s")));
}

class AlarmRows : public testing::TestWithParam<const char*> {
protected:
    void SetUp() override {
        useTheme(Theme::Dark);
        useLanguage(QLatin1String(GetParam()));
    }
    void TearDown() override { useLanguage(QStringLiteral("en")); }
};

/// 270 pixels: the pane of layout Drive in a window of 1280.
TEST_P(AlarmRows, AreToldToTheirEndInANarrowPane) {
    QWidget dock;  // which asks the pane for nothing
    AlarmPanel panel(&dock);
    const std::vector<AlarmLine> lines = alarmLinesOf(everyAlarm(), team(), at(0));
    panel.show(lines, muteText(at(48), at(0)), muteBrief(at(48), at(0)));
    dock.resize(270, 1'700);
    panel.setGeometry(dock.rect());
    dock.show();
    static_cast<void>(pictureOf(dock, {270, 1'700}, QStringLiteral("alarms_%1").arg(GetParam())));
    EXPECT_EQ(textFaults(dock).join("; ").toStdString(), "");
    EXPECT_TRUE(panel.findChild<QToolButton*>("mute")->text().contains(QStringLiteral("48")));
    QString painted;
    for (const PaintedText& one : paintedTexts(*panel.findChild<QListView*>("alarms"))) painted += one.text;
    painted = withoutBlanks(painted);
    for (const AlarmLine& line : lines) {
        EXPECT_TRUE(painted.contains(withoutBlanks(line.text))) << line.text.toStdString();
        EXPECT_TRUE(painted.contains(withoutBlanks(line.since))) << line.since.toStdString();
    }
}

TEST_P(AlarmRows, AreOneLineWhereThereIsRoom) {
    AlarmPanel panel;
    panel.show(alarmLinesOf({everyAlarm()[3], everyAlarm()[8]}, team(), at(0)), {});
    panel.QWidget::show();
    const auto* const list = panel.findChild<QListView*>("alarms");
    const auto height = [&](int width) {
        panel.resize(width, 200);
        static_cast<void>(paintedTexts(panel));
        return list->visualRect(list->model()->index(1, 0)).height();
    };
    const int narrow = height(240);
    EXPECT_GT(narrow, height(700)) << "the rows follow the pane's width";
    EXPECT_EQ(height(240), narrow);
}

INSTANTIATE_TEST_SUITE_P(Languages, AlarmRows, testing::Values("en", "de", "ja"),
                         [](const auto& one) { return std::string(one.param); });

}  // namespace
}  // namespace leitstand::test
