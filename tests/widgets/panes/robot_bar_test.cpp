// The bar of all robots: folds to letters, then scrolls, hides nothing without a sign.
#include "widgets/robots/robot_bar.h"

#include <QAbstractButton>
#include <QApplication>
#include <QHBoxLayout>
#include <QLineEdit>
#include <QSignalSpy>
#include <QTest>
#include <QWheelEvent>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "app/language/language.h"
#include "tests/widgets/panes/shown.h"
#include "widgets/painting/theme.h"
#include "widgets/robots/more_robots_button.h"
#include "widgets/robots/release_handle.h"
#include "widgets/robots/robot_chip_button.h"

namespace leitstand::test {
namespace {

using testing::Contains;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;

class RobotBars : public testing::Test {
protected:
    RobotBars() {
        useTheme(Theme::Dark);
        m_line.addWidget(&m_bar);
        m_line.addWidget(new QLineEdit(&m_window));
        m_line.setContentsMargins(0, 0, 0, 0);
        QObject::connect(&m_bar, &RobotBar::robotSelected, [this](const QString& name) {
            for (std::size_t i = 0; i < m_robots.size(); ++i)
                if (m_robots[i].face.name == name) m_selected = i;
            refresh();
        });
    }
    ~RobotBars() override { useLanguage(QStringLiteral("en")); }
    void addRobots(int count) {
        static const char* const titles[] = {"Kurt3D", "Crawler", "Dozer",  "Eagle",  "Ferret", "Gecko",
                                             "Hauler", "Ibis",    "Jumper", "Lizard", "Mole",   "Newt"};
        for (int i = 0; i < count; ++i)
            m_robots.push_back(sampleRobot(std::string(1, titles[i][0]), titles[i], i));
        refresh();
    }
    void refresh() {
        std::vector<RobotChip> chips;
        std::vector<StopLine> stops;
        for (const SampleRobot& robot : m_robots) {
            chips.push_back(robotChipOf(robot.face, robot.view, robot.reported, at(0)));
            stops.push_back(stopLineOf(robot.face, robot.view));
        }
        m_bar.show(chips, stops, m_robots[m_selected].face.name);
    }
    /// In a window, @p width wide.
    void show(int width) {
        m_window.resize(width + 200, 60);
        m_bar.setFixedWidth(width);
        m_window.show();
        m_window.activateWindow();
        ASSERT_TRUE(QTest::qWaitForWindowActive(&m_window));
        QApplication::processEvents();
        ASSERT_EQ(m_bar.width(), width);
    }
    [[nodiscard]] RobotChipButton& button(int i) const { return *m_bar.findChildren<RobotChipButton*>()[i]; }
    [[nodiscard]] bool isSeen(const QWidget& one) const {
        return one.isVisible() && m_bar.rect().contains(QRect(one.mapTo(&m_bar, QPoint()), one.size()));
    }
    /// The letters of robots in sight.
    [[nodiscard]] std::string letters() const {
        std::map<int, QString> byPlace;
        for (const RobotChipButton* one : m_bar.findChildren<RobotChipButton*>())
            if (isSeen(*one)) byPlace[one->x()] = one->chip().face.letter;
        QString all;
        for (const auto& [x, letter] : byPlace) all += letter;
        return all.toStdString();
    }
    [[nodiscard]] MoreRobotsButton& more(int side) const {
        return *m_bar.findChildren<MoreRobotsButton*>()[side];
    }
    [[nodiscard]] QStringList words() {
        QStringList words;
        for (const PaintedText& one : paintedTexts(m_bar)) words += one.text;
        return words;
    }
    [[nodiscard]] int folded(int count) const {
        return count * (RobotChipButton::foldedWidth(m_bar.font()) + 4) - 4;
    }

    std::vector<SampleRobot> m_robots;
    std::size_t m_selected = 0;
    QWidget m_window;
    QHBoxLayout m_line{&m_window};
    RobotBar m_bar;
};

TEST_F(RobotBars, FoldToLettersAndStillTellHowFarAStopIs) {
    addRobots(8);
    setStop(m_robots[0], true, true);
    setStop(m_robots[1], true, false);
    setStop(m_robots[2], false, false);
    m_robots[2].view.stop.unanswered = std::chrono::milliseconds(4200);
    setStop(m_robots[3], false, false);
    setStop(m_robots[4], true, true);
    m_robots[4].view.stop.releasing = true;
    for (const char* language : {"en", "de", "ja"}) {
        useLanguage(QLatin1String(language));
        refresh();
        ASSERT_NO_FATAL_FAILURE(show(folded(8)));
        EXPECT_EQ(letters(), "KCDEFGHI") << language;
        const QString all = words().join(QString());
        for (std::size_t i = 0; i < 5; ++i) {
            const StopLine stop = stopLineOf(m_robots[i].face, m_robots[i].view);
            EXPECT_TRUE(all.contains(stop.brief) || all.contains(stop.text))
                << language << ' ' << i << ": " << all.toStdString();
        }
        EXPECT_EQ(textFaults(m_bar).join("; ").toStdString(), "") << language;
        EXPECT_FALSE(all.contains(QChar(0x2026))) << all.toStdString();
        static_cast<void>(
            pictureOf(m_bar, m_bar.size(), QStringLiteral("robots_folded_%1").arg(QLatin1String(language))));
    }
}

TEST_F(RobotBars, TellTheWholeNameAndStateOfAFoldedRobotInTooltipsAndToScreenReaders) {
    addRobots(8);
    setStop(m_robots[1], true, false);
    refresh();
    ASSERT_NO_FATAL_FAILURE(show(folded(8)));
    EXPECT_THAT(words().join(' ').toStdString(), Not(HasSubstr("Crawler"))) << "it is folded";
    for (const QString& reported : {button(1).toolTip(), button(1).accessibleDescription()}) {
        for (const char* part :
             {"Crawler (C)", "battery 71", "connected", "22 ms", "STOP: confirmed · moves"})
            EXPECT_THAT(reported.toStdString(), HasSubstr(part));
    }
    EXPECT_EQ(button(1).accessibleName(), "Robot Crawler");
    EXPECT_THAT(button(1).toolTip().toStdString(), HasSubstr("2 selects"));
    const ReleaseHandle& handle = button(1).handle();
    EXPECT_EQ(handle.accessibleName(), "Release Crawler");
    EXPECT_THAT(handle.toolTip().toStdString(), HasSubstr("Crawler (C): confirmed · moves"));
    EXPECT_THAT(handle.toolTip().toStdString(), HasSubstr("Hold this button for one second"));
}

TEST_F(RobotBars, ScrollWhatHasNoRoomAndKeepTheSelectedOneInSight) {
    addRobots(8);
    ASSERT_NO_FATAL_FAILURE(show(folded(4) + 2 * (MoreRobotsButton::Width + 4)));
    EXPECT_EQ(letters(), "KCDE");
    EXPECT_FALSE(more(0).isEnabled());
    EXPECT_EQ(more(1).hidden().count, 4);
    button(0).setFocus(Qt::TabFocusReason);
    QTest::keyClick(&button(0), Qt::Key_7);
    EXPECT_TRUE(QTest::qWaitFor([&] { return letters() == "EFGH"; }))
        << "a key selects also one that is out of sight, and brings it into sight: " << letters();
    EXPECT_TRUE(button(6).isChecked());
    QTest::mouseClick(&more(0), Qt::LeftButton);
    EXPECT_EQ(letters(), "KCDH") << "scrolled, the selected one stays";
    EXPECT_FALSE(more(0).isEnabled());
    EXPECT_EQ(more(1).hidden().count, 4);
    const QRect stays = more(1).geometry();
    QWheelEvent wheel(QPointF(60, 20), m_bar.mapToGlobal(QPointF(60, 20)), {}, QPoint(0, -120), Qt::NoButton,
                      {}, Qt::NoScrollPhase, false);
    QApplication::sendEvent(&m_bar, &wheel);
    EXPECT_EQ(letters(), "CDEH");
    for (int i = 0; i < 6; ++i) QTest::mouseClick(&more(1), Qt::LeftButton);
    EXPECT_EQ(letters(), "FGHI");
    EXPECT_FALSE(more(1).isEnabled());
    EXPECT_EQ(more(1).geometry(), stays);
    m_selected = 0;
    refresh();
    EXPECT_EQ(letters(), "KCDE");
}

TEST_F(RobotBars, AreReachedByTabAlsoWhereTheyAreScrolledOut) {
    addRobots(8);
    setStop(m_robots[6], true, true);
    refresh();
    ASSERT_NO_FATAL_FAILURE(show(folded(3) + 2 * (MoreRobotsButton::Width + 4)));
    button(0).setFocus(Qt::TabFocusReason);
    QStringList order;
    for (int i = 0; i < 20; ++i) {
        QWidget* const now = QApplication::focusWidget();
        ASSERT_NE(now, nullptr);
        if (qobject_cast<QLineEdit*>(now) != nullptr) break;
        EXPECT_TRUE(isSeen(*now)) << now->accessibleName().toStdString();
        order += now->accessibleName();
        QTest::keyClick(now, Qt::Key_Tab);
    }
    EXPECT_THAT(order.join(QLatin1Char('|')).toStdString(),
                HasSubstr("Robot Kurt3D|Release Hauler|Robots to the right"))
        << "arrows choose among robots";
    button(0).setFocus(Qt::TabFocusReason);
    for (int i = 1; i < 8; ++i) {
        QTest::keyClick(QApplication::focusWidget(), Qt::Key_Right);
        EXPECT_EQ(QApplication::focusWidget(), &button(i));
        EXPECT_TRUE(isSeen(button(i))) << i;
        EXPECT_TRUE(button(i).isChecked()) << i;
    }
    for (int i = 6; i >= 0; --i) {
        QTest::keyClick(QApplication::focusWidget(), Qt::Key_Left);
        EXPECT_TRUE(isSeen(button(i)) && button(i).isChecked()) << i;
    }
}

TEST_F(RobotBars, SignWhatIsWorstOfRobotsOutOfSight) {
    addRobots(8);
    ASSERT_NO_FATAL_FAILURE(show(folded(3) + 2 * (MoreRobotsButton::Width + 4)));
    const auto coloured = [&](const QColor& colour) { return countOf(more(1).grab().toImage(), colour, 12); };
    const ThemeColours& colours = coloursOf(Theme::Dark);
    EXPECT_EQ(coloured(colours.attention), 0);
    setStop(m_robots[6], true, false);
    refresh();
    EXPECT_GT(coloured(colours.attention), 40) << "it moves";
    setStop(m_robots[7], false, false);
    m_robots[7].view.stop.unanswered = std::chrono::milliseconds(2400);
    refresh();
    EXPECT_GT(coloured(colours.act), 40) << "it does not answer";
    QStringList painted;
    for (const PaintedText& one : paintedTexts(more(1))) painted += one.text;
    EXPECT_TRUE(painted.contains(QStringLiteral("I"))) << "whose stop it is, not by colour alone";
    EXPECT_TRUE(painted.contains(QStringLiteral("5"))) << "how many";
    EXPECT_THAT(more(1).toolTip().toStdString(), HasSubstr("Ibis (I)"));
    EXPECT_THAT(more(1).accessibleDescription().toStdString(), HasSubstr("STOP: sent · no answer for 2.4 s"));
    EXPECT_EQ(textFaults(more(1)).join("; ").toStdString(), "");
    static_cast<void>(pictureOf(m_bar, m_bar.size(), QStringLiteral("robots_scrolled")));
}

TEST_F(RobotBars, AreOfOneSizeWhateverTheyShow) {
    addRobots(3);
    ASSERT_NO_FATAL_FAILURE(show(700));
    const QSize liked = m_bar.sizeHint(), least = m_bar.minimumSizeHint();
    std::vector<QRect> places;
    for (int i = 0; i < 3; ++i) places.push_back(button(i).geometry());
    EXPECT_EQ(places[0].width(), places[1].width());
    m_robots[0].face.title = QStringLiteral("A robot with a rather long name");
    m_robots[1].view.link.state = LinkState::Lost;
    setStop(m_robots[2], false, false);
    m_robots[2].view.stop.unanswered = std::chrono::minutes(59);
    refresh();
    QApplication::processEvents();
    EXPECT_EQ(m_bar.sizeHint(), liked);
    EXPECT_EQ(m_bar.minimumSizeHint(), least);
    for (int i = 0; i < 3; ++i) EXPECT_EQ(button(i).geometry(), places[static_cast<std::size_t>(i)]) << i;
}

TEST_F(RobotBars, AClickOnAStopThatCannotBeReleasedSelectsItsRobotAndOneThatCanDoesNot) {
    addRobots(2);
    for (SampleRobot& robot : m_robots) setStop(robot, true, true);
    m_robots[1].view.grant.mine = false;
    refresh();
    ASSERT_NO_FATAL_FAILURE(show(500));
    QSignalSpy selected(&m_bar, &RobotBar::robotSelected);
    QTest::mouseClick(&button(0).handle(), Qt::LeftButton);
    EXPECT_THAT(selected, IsEmpty()) << "it is held, not clicked";
    QTest::mouseClick(m_window.windowHandle(), Qt::LeftButton, {},
                      button(1).handle().mapTo(&m_window, button(1).handle().rect().center()));
    ASSERT_EQ(selected.size(), 1);
    EXPECT_EQ(selected[0][0].toString(), m_robots[1].face.name);
}

TEST_F(RobotBars, NameWhatARobotDoesByWordsAndBySigns) {
    addRobots(2);
    m_robots[1].view.link.state = LinkState::Lost;
    m_robots[1].view.link.silence = 4.2;
    refresh();
    ASSERT_NO_FATAL_FAILURE(show(500));
    EXPECT_THAT(words().join(QLatin1Char('|')).toStdString(), HasSubstr("teleoperation"));
    EXPECT_THAT(words().join(QLatin1Char('|')).toStdString(), HasSubstr("link lost"));
    EXPECT_THAT(words().join(QLatin1Char('|')).toStdString(), HasSubstr("4.2 s"));
    m_bar.setFixedWidth(folded(2));
    QApplication::processEvents();
    EXPECT_THAT(words().join(QLatin1Char('|')).toStdString(), HasSubstr("teleop"));
    EXPECT_THAT(words().join(QLatin1Char('|')).toStdString(), HasSubstr("lost"));
    EXPECT_EQ(textFaults(m_bar).join("; ").toStdString(), "");
}

}  // namespace
}  // namespace leitstand::test
