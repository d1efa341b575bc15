#include "widgets/timeline/timeline_bar.h"

#include <chrono>

#include <gmock/gmock.h>
#include <QAction>
#include <QLabel>
#include <QSignalSpy>
#include <QTest>

#include "tests/widgets/panes/shown.h"
#include "widgets/painting/theme.h"
#include "widgets/timeline/transport_bar.h"

namespace leitstand {
namespace {

using namespace std::chrono_literals;
using Kind = TimelineMark::Kind;

Time at(double seconds) {
    return Time(1'750'000'000s) + std::chrono::nanoseconds(static_cast<std::int64_t>(seconds * 1e9));
}

class TimelineBarTest : public testing::Test {
protected:
    TimelineBarTest() {
        test::useTheme(Theme::Dark);
        const std::vector<TimelineMark> marks = {
            {.kind = Kind::Session, .at = at(0), .key = "start", .text = "Desk"},
            {.kind = Kind::Mode, .at = at(40), .key = "explore"},
            {.kind = Kind::Candidate, .at = at(180), .key = "told", .name = "victim", .candidate = 3},
            {.kind = Kind::Victim, .at = at(200), .key = "hypothesis", .name = "V1"},
            {.kind = Kind::Candidate, .at = at(240), .key = "dismissed", .name = "victim", .candidate = 4},
            {.kind = Kind::Alarm, .at = at(260), .key = "link_lost", .text = "link lost", .act = true},
            {.kind = Kind::Sighting, .at = at(300), .key = "heat"},
            {.kind = Kind::Note, .at = at(420), .text = "door"},
            {.kind = Kind::Decision, .at = at(500), .key = "poses"},
            {.kind = Kind::Victim, .at = at(560), .key = "confirmed", .name = "V12"},
            {.kind = Kind::Bump, .at = at(640), .key = "front", .act = true},
            {.kind = Kind::Session, .at = at(5'000), .key = "start", .text = "Desk"},
            {.kind = Kind::Alarm, .at = at(5'200), .key = "battery", .text = "battery: 12 min left"},
        };
        const TimelineAxis axis({{at(0), at(700)}, {at(5'000), at(5'500)}});
        m_bar.setMission(axis, glyphsOf(marks, axis, {}));
        m_bar.setPosition(at(330));
        m_bar.resize(1280, TimelineBar::Height);
        m_bar.show();
    }
    [[nodiscard]] QPoint trackAt(double seconds) const {
        return {static_cast<int>(m_bar.pixelOf(at(seconds))), 52};
    }
    TimelineBar m_bar;
};

TEST_F(TimelineBarTest, ShowsMarksGapsAndTheMoment) {
    const QImage picture = test::pictureOf(m_bar, {1280, TimelineBar::Height}, QStringLiteral("timeline"));
    EXPECT_GT(test::colouredPixels(picture), 500);
    EXPECT_TRUE(test::textFaults(m_bar).isEmpty()) << test::textFaults(m_bar).join('\n').toStdString();
    m_bar.setOpening(0.4);
    const QImage opening =
        test::pictureOf(m_bar, {1280, TimelineBar::Height}, QStringLiteral("timeline-opening"));
    EXPECT_NE(picture, opening);
}

TEST_F(TimelineBarTest, TheMouseGoesToMomentsAndMarks) {
    QSignalSpy sought(&m_bar, &TimelineBar::sought);
    QTest::mousePress(&m_bar, Qt::LeftButton, {}, trackAt(100));
    QTest::mouseMove(&m_bar, trackAt(150));
    QTest::mouseRelease(&m_bar, Qt::LeftButton, {}, trackAt(150));
    ASSERT_GE(sought.size(), 2);
    const auto near = [](Time found, double wanted) {
        return std::abs(std::chrono::duration<double>(found - at(wanted)).count()) < 1.5;
    };
    EXPECT_TRUE(near(sought.first().first().value<Time>(), 100));
    EXPECT_TRUE(near(sought.last().first().value<Time>(), 150));
    const auto count = sought.size();
    QTest::mouseMove(&m_bar, trackAt(300));
    EXPECT_EQ(sought.size(), count) << "the button is up";
    QTest::mouseClick(&m_bar, Qt::LeftButton, {}, QPoint(trackAt(203).x(), 14));
    EXPECT_EQ(sought.last().first().value<Time>(), at(200)) << "the victim's own moment";
    ASSERT_NE(m_bar.glyphAt(QPointF(trackAt(560).x(), 14)), nullptr);
    EXPECT_TRUE(
        m_bar.glyphAt(QPointF(trackAt(560).x(), 14))->details.endsWith(QStringLiteral("V12 confirmed")));
}

TEST_F(TimelineBarTest, NoAlarmBuriesAFind) {
    // Alarms one after the other, as a bad link makes them, about a victim.
    std::vector<TimelineMark> marks = {
        {.kind = Kind::Victim, .at = at(350), .key = "confirmed", .name = "V1"}};
    for (int i = 0; i < 100; ++i)
        marks.push_back({.kind = Kind::Alarm, .at = at(340 + 0.2 * i), .key = "link_lost", .act = true});
    const TimelineAxis axis(std::vector<TimelineStretch>{{at(0), at(700)}});
    m_bar.setMission(axis, glyphsOf(marks, axis, {}));
    const double x = m_bar.pixelOf(at(350));
    const TimelineGlyph* const find = m_bar.glyphAt(QPointF(x, 12));
    ASSERT_NE(find, nullptr);
    EXPECT_EQ(find->mark.kind, Kind::Victim);
    const TimelineGlyph* const alarm = m_bar.glyphAt(QPointF(x, 34));
    ASSERT_NE(alarm, nullptr);
    EXPECT_EQ(alarm->mark.kind, Kind::Alarm);
    const QImage picture =
        test::pictureOf(m_bar, {1280, TimelineBar::Height}, QStringLiteral("timeline-buried"));
    const QImage lane = picture.copy(static_cast<int>(x) - 8, 5, 16, 16);
    EXPECT_GT(test::countOf(lane, coloursOf(Theme::Dark).select, 30), 60) << "the victim is whole";
}

TEST_F(TimelineBarTest, TheKeysStepAndGoToTheEnds) {
    QSignalSpy stepped(&m_bar, &TimelineBar::stepped), sought(&m_bar, &TimelineBar::sought);
    QTest::keyClick(&m_bar, Qt::Key_Right);
    QTest::keyClick(&m_bar, Qt::Key_Left, Qt::ShiftModifier);
    ASSERT_EQ(stepped.size(), 2);
    EXPECT_EQ(stepped[0].first().toDouble(), 1.0);
    EXPECT_EQ(stepped[1].first().toDouble(), -10.0);
    QTest::keyClick(&m_bar, Qt::Key_End);
    QTest::keyClick(&m_bar, Qt::Key_Home);
    ASSERT_EQ(sought.size(), 2);
    EXPECT_EQ(sought[0].first().value<Time>(), at(5'500));
    EXPECT_EQ(sought[1].first().value<Time>(), at(0));
}

TEST_F(TimelineBarTest, TheTransportTellsMomentAndRate) {
    TransportBar transport;
    QAction play(QStringLiteral("Play"));
    transport.addCommand(play);
    transport.show(TimelineAxis({TimelineStretch{at(0), at(700)}}), at(271.5), -4.0);
    const QImage picture = test::pictureOf(transport, {1280, 36}, QStringLiteral("transport"));
    EXPECT_EQ(transport.findChild<QLabel*>(QStringLiteral("reviewRate"))->text(),
              QStringLiteral("backwards 4×"));
    EXPECT_TRUE(transport.findChild<QLabel*>(QStringLiteral("reviewTime"))
                    ->text()
                    .endsWith(QStringLiteral("4:31.5 of 11:40.0")));
    EXPECT_TRUE(test::textFaults(transport).isEmpty());
}

}  // namespace
}  // namespace leitstand
