// Names and words that others chose are shown as they are: never as HTML.
#include <QDialog>
#include <QLabel>
#include <QMessageBox>
#include <QToolTip>

#include <gmock/gmock.h>

#include "app/window/layouts/layout_feature.h"
#include "app/window/scans/main_window.h"
#include "core/event/station_topics.h"
#include "tests/app/plain_tips.h"
#include "tests/app/review/written_mission.h"
#include "tests/app/window/review_page.h"
#include "widgets/painting/plain_texts.h"

namespace leitstand::test {
namespace {

constexpr auto Hostile = "<b>x</b><img src=\"/etc/hostname\">";

/// A mission whose folder, stations, finds, notes and alarms have names that are HTML.
class HostileReview : public ReviewPage {
protected:
    void SetUp() override {
        const std::filesystem::path folder = m_folder / "<b>x<img src=a>";
        {
            WrittenMission mission(folder);
            writeMinute(mission);
            sayHostile(mission);
        }
        m_bridge = ReviewBridge::open(folder).value();
        openWindow();
    }

private:
    static void sayHostile(WrittenMission& mission) {
        const Time now = WrittenMission::at(61.0);
        FindSample victim;
        victim.stamp = victim.found = now;
        victim.station = victim.tag = victim.text = victim.situation = victim.area = Hostile;
        victim.number = 2;
        victim.robot = "kurt3d";
        victim.form = victim.motion = {.state = VictimSign::State::Present, .text = Hostile};
        victim.positionInMap = {1.0, 0.5, 0.3};
        for (const auto kind : {FindSample::Kind::Victim, FindSample::Kind::Code, FindSample::Kind::Object}) {
            victim.kind = kind;
            mission.publish(61.0, std::string(station_topic::Victims), victim);
        }
        mission.publish(61.0, std::string(station_topic::Notes),
                        NoteSample{.stamp = now, .station = Hostile, .robot = Hostile, .text = Hostile});
        AlarmSample alarm;
        alarm.stamp = now;
        alarm.station = alarm.robot = alarm.key = alarm.text = Hostile;
        mission.publish(61.0, std::string(station_topic::Alarms), alarm);
        MissionInfoSample info;
        info.stamp = now;
        info.station = info.competition = info.team = info.country = info.mission = info.area = info.profile =
            Hostile;
        mission.publish(61.0, std::string(station_topic::Mission), info);
        mission.publish(61.0, std::string(station_topic::Sessions),
                        SessionSample{.stamp = now,
                                      .station = Hostile,
                                      .title = Hostile,
                                      .start = true,
                                      .mission = Hostile,
                                      .version = Hostile});
    }
};

TEST_F(HostileReview, ShowsOthersWordsAsTheyAre) {
    goTo(61.0);
    int quoted = 0;
    for (const char* layout : {"review", "map", "drive", "explore", "link", "compare", "report"}) {
        ASSERT_TRUE(m_window->layouts().use(QString::fromLatin1(layout)));
        m_window->showMessage(QString::fromLatin1(Hostile));
        const QuotedHtml found = quotedHtml(*m_window);
        EXPECT_EQ(found.drawn.join(QStringLiteral("; ")).toStdString(), "") << layout;
        quoted += found.labels + found.tips;
    }
    EXPECT_GT(quoted, 20) << "the words were shown somewhere";
}

TEST_F(HostileReview, BoxesAndTooltipsOfWhateverShowThemToo) {
    QMessageBox box(QMessageBox::Question, QString::fromLatin1(Hostile), QString::fromLatin1(Hostile),
                    QMessageBox::Ok, m_window.get());
    box.setInformativeText(QString::fromLatin1(Hostile));
    box.open();
    QuotedHtml found = quotedHtml(box);
    EXPECT_EQ(found.labels, 2);
    EXPECT_EQ(found.drawn.join(QStringLiteral("; ")).toStdString(), "");
    box.close();
    QLabel label(QString::fromLatin1(Hostile), m_window.get());
    label.setToolTip(QString::fromLatin1(Hostile));
    label.show();
    found = quotedHtml(*m_window);
    EXPECT_GE(found.tips, 1);
    EXPECT_EQ(found.drawn.join(QStringLiteral("; ")).toStdString(), "");
}

TEST(PlainTexts, TooltipsOfManyWordsAreBrokenIntoLines) {
    EXPECT_EQ(inLines(QStringLiteral("one two three"), 8), QStringLiteral("one two\nthree"));
    EXPECT_EQ(inLines(QStringLiteral("a\nbb\n"), 8), QStringLiteral("a\nbb\n"));
    EXPECT_EQ(inLines(QStringLiteral("unbreakable"), 4), QStringLiteral("unbreakable"));
    EXPECT_EQ(inLines(QString(), 4), QString());
    for (const QString& line :
         inLines(QStringLiteral("ロボットが見つからないので止まります"), 6).split(u'\n'))
        EXPECT_LE(line.size(), 7);
}

}  // namespace
}  // namespace leitstand::test
