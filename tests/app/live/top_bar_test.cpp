// STOP, all robots and warnings are in sight: with many robots, in small windows, in every language.
#include <map>
#include <memory>
#include <string>
#include <vector>

#include <QAbstractButton>
#include <QAction>
#include <QApplication>
#include <QDockWidget>
#include <QLabel>
#include <QListView>
#include <QMenuBar>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "app/language/language.h"
#include "app/services/station/safety/station_brakes.h"
#include "app/window/commands/command_table.h"
#include "app/window/input/selection.h"
#include "app/window/layouts/layout_feature.h"
#include "core/event/stream_role.h"
#include "core/io/robot/brake_file.h"
#include "tests/app/cut_texts.h"
#include "tests/app/live/live_page.h"
#include "tests/support/places.h"
#include "tests/widgets/panes/shown.h"
#include "widgets/painting/theme.h"
#include "widgets/preflight/preflight_page.h"
#include "widgets/robots/robot_chip_button.h"

namespace leitstand::test {
namespace {

using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;

constexpr int Smallest = 1024;  ///< width of the smallest window [px]

/// @p count robots of the two kinds that are shipped, each with a name, a letter and topics of its own.
std::vector<RobotDescription> team(int count) {
    static const std::vector<std::string> titles = {"Kurt3D", "Crawler", "Dozer",   "Eagle Eye on the Roof",
                                                    "Ferret", "Gecko",   "Hauler",  "Ibis",
                                                    "Jumper", "Lizard",  "Mole",    "Newt",
                                                    "Otter",  "Panther", "Quetzal", "Rover"};
    std::vector<RobotDescription> robots;
    for (int i = 0; i < count; ++i) {
        RobotDescription robot = shippedRobot(i % 2 == 0 ? "kurt3d" : "crawler");
        const std::string old = "/" + robot.name + "/";
        if (i > 1) robot.name = "robot" + std::to_string(i + 1);
        robot.title = titles[static_cast<std::size_t>(i)];
        robot.letter = robot.title.substr(0, 1);
        for (StreamDescription& stream : robot.streams) {
            if (stream.topic.starts_with(old)) stream.topic.replace(0, old.size(), "/" + robot.name + "/");
        }
        robots.push_back(robot);
    }
    return robots;
}

/// What a robot may be like.
enum class As {
    Calm,
    NotReceived,
    Degraded,
    Lost,
    Sent,
    Unanswered,
    Moves,
    MotionUnknown,
    Standing,
    Releasing,
    Zeros
};

constexpr As Everything[] = {As::Calm,     As::NotReceived, As::Degraded, As::Lost,
                             As::Sent,     As::Unanswered,  As::Moves,    As::MotionUnknown,
                             As::Standing, As::Releasing,   As::Zeros};

RobotView viewOf(As as) {
    RobotView view;
    view.link.state = LinkState::Connected;
    view.link.roundTrip = RoundTripStatus{.last = 0.021, .median = 0.022};
    view.link.streams.resize(1);
    view.grant.mine = true;
    if (as == As::NotReceived) view.link.state = LinkState::NeverSeen;
    if (as == As::Lost) view.link.state = LinkState::Lost, view.link.silence = 4.2;
    if (as == As::Degraded) {
        view.link.state = LinkState::Degraded;
        view.link.reasons = {{LinkReason::Kind::Loss, 0.41, StreamRole::Picture, "left", "/left"}};
    }
    StopStatus& stop = view.stop;
    stop.sent = as >= As::Sent;
    if (as == As::Unanswered) stop.unanswered = std::chrono::milliseconds(4200);
    stop.acknowledged = stop.stopped = as > As::Unanswered;
    stop.standingKnown = as != As::MotionUnknown && as != As::Zeros;
    stop.standing = as == As::Standing || as == As::Releasing;
    stop.releasing = as == As::Releasing;
    stop.supported = as != As::Zeros;
    return view;
}

/// The live window on robots that are not there, which are shown as a test wants.
class TopBar : public testing::TestWithParam<int> {
protected:
    explicit TopBar(int robots = GetParam(), const std::map<std::string, BrakeResult>& brakes = {})
        : m_live((remember(brakes),
                  openLiveStation(m_folder.path().toStdString(), m_domain.number(), team(robots)))) {
        EXPECT_TRUE(QTest::qWaitForWindowActive(&window()));
    }
    ~TopBar() override {
        m_live.window.reset();
        useLanguage(QStringLiteral("en"));
    }

    /// What the station knows of brake tests of before.
    void remember(const std::map<std::string, BrakeResult>& brakes) const {
        ASSERT_TRUE(writeBrakes(m_folder.filePath(QStringLiteral("brakes.yaml")).toStdString(), brakes));
    }
    /// As the application does when the window asks for another language.
    void speak(const char* language) {
        m_live.window.reset();
        ASSERT_TRUE(useLanguage(QLatin1String(language)));
        const std::string layouts = m_folder.filePath(QStringLiteral("layouts")).toStdString();
        m_live.window = std::make_unique<LiveWindow>(
            *m_live.bridge, MapViewSettings{}, LayoutBook(layouts, sourceFolder() + "/resources/layouts"));
        window().show();
        ASSERT_TRUE(QTest::qWaitForWindowActive(&window()));
    }
    void resizeTo(int width) {
        window().resize(width, width == Smallest ? 768 : 1080);
        QApplication::processEvents();
    }
    /// All robots, or robot @p which alone with the others calm; until the event loop goes on.
    void show(As as, int which = -1) {
        LiveMoment moment = m_live.bridge->moment();
        const auto& robots = window().selection().robots();
        for (std::size_t i = 0; i < robots.size(); ++i)
            moment.robots[robots[i].name] = viewOf(which < 0 || which == static_cast<int>(i) ? as : As::Calm);
        emit m_live.bridge->ticked(moment);
        QCoreApplication::sendPostedEvents(nullptr, QEvent::LayoutRequest);
    }
    [[nodiscard]] LiveWindow& window() const { return *m_live.window; }
    [[nodiscard]] QWidget& stop() const { return *window().findChild<QWidget*>(QStringLiteral("stop")); }
    [[nodiscard]] QRect placeOf(const QWidget& one) const {
        return {one.mapTo(&window(), QPoint()), one.size()};
    }
    /// Where everything is that an operator reaches for: buttons of the bar, menus, panes.
    [[nodiscard]] std::map<const QObject*, QRect> places() const {
        std::map<const QObject*, QRect> places;
        for (const QAbstractButton* button : window().findChildren<QAbstractButton*>()) {
            bool inPane = false;
            for (const QWidget* in = button; in != nullptr; in = in->parentWidget())
                inPane = inPane || qobject_cast<const QDockWidget*>(in) != nullptr;
            if (!inPane && button->isVisible()) places[button] = placeOf(*button);
        }
        for (const QDockWidget* dock : window().findChildren<QDockWidget*>())
            if (dock->isVisible()) places[dock] = placeOf(*dock);
        for (QAction* menu : window().menuBar()->actions())
            places[menu] = window().menuBar()->actionGeometry(menu);
        return places;
    }
    /// What is elsewhere than it was in @p before.
    [[nodiscard]] std::vector<std::string> moved(const std::map<const QObject*, QRect>& before) const {
        std::vector<std::string> moved;
        for (const auto& [what, place] : places()) {
            const auto was = before.find(what);
            if (was != before.end() && was->second != place)
                moved.push_back(what->objectName().toStdString() + " by " +
                                std::to_string(place.x() - was->second.x()) + " px, " +
                                std::to_string(was->second.width()) + " wide before, " +
                                std::to_string(place.width()) + " after");
        }
        return moved;
    }
    /// Texts that are cut. An alarm ends in dots after some lines: on a busy computer the disk is one.
    [[nodiscard]] QStringList cut() const {
        QString alarms;
        const auto* const list = window().findChild<QListView*>(QStringLiteral("alarms"));
        for (int row = 0; row < list->model()->rowCount(); ++row)
            alarms += list->model()->index(row, 0).data().toString() + QLatin1Char('\n');
        QStringList cut = cutTexts(window());
        cut.removeIf([&](const QString& text) {
            const QString painted = text.section(QStringLiteral(": "), 1).section(QChar(0x2026), 0, 0);
            return alarms.contains(painted.trimmed());
        });
        return cut;
    }
    void keep(const QString& name) const {
        const QString folder = qEnvironmentVariable("LEITSTAND_PICTURES");
        if (!folder.isEmpty()) window().grab().save(folder + "/bar_" + name + ".png");
    }

    const TestDomain m_domain;
    const QTemporaryDir m_folder;
    LiveStation m_live;
};

TEST_P(TopBar, StopIsWholeAndAtOnePlaceInEveryLanguageAndTheSmallestWindow) {
    for (const char* language : {"en", "de", "ja"}) {
        ASSERT_NO_FATAL_FAILURE(speak(language));
        for (const int width : {Smallest, 1280, 1920}) {
            resizeTo(width);
            show(As::Calm);
            EXPECT_LE(window().minimumSizeHint().width(), Smallest) << language;
            ASSERT_EQ(window().width(), width) << language;
            const QRect place = placeOf(stop());
            EXPECT_TRUE(window().rect().contains(place)) << language << ' ' << width;
            EXPECT_LE(width - place.right(), 12) << "in the corner";
            EXPECT_GE(place.width(), stop().sizeHint().width()) << language;
            for (const RobotChipButton* robot : window().findChildren<RobotChipButton*>())
                EXPECT_TRUE(QRect(0, 0, place.left(), window().height()).contains(placeOf(*robot)))
                    << "eight robots fit without scrolling: " << language << ' ' << width;
            for (const As as : Everything) {
                show(as);
                EXPECT_LE(window().minimumSizeHint().width(), Smallest) << language << static_cast<int>(as);
                EXPECT_EQ(placeOf(stop()), place) << language << ' ' << width << ' ' << static_cast<int>(as);
            }
            window().repaint();
            EXPECT_GT(countOf(window().grab(place).toImage(), coloursOf(presentTheme()).stop, 2),
                      place.width() * place.height() / 2);
        }
    }
}

TEST_P(TopBar, NothingMovesWhateverRobotsAreLike) {
    for (const char* language : {"en", "de", "ja"}) {
        ASSERT_NO_FATAL_FAILURE(speak(language));
        for (const int width : {Smallest, 1280, 1920}) {
            resizeTo(width);
            show(As::Calm);
            const auto before = places();
            EXPECT_GT(before.size(), 8U + static_cast<std::size_t>(GetParam()));
            for (const As as : Everything) {
                show(as);
                EXPECT_THAT(moved(before), IsEmpty())
                    << language << ' ' << width << ' ' << static_cast<int>(as);
                show(as, GetParam() - 1);
                EXPECT_THAT(moved(before), IsEmpty())
                    << language << ' ' << width << ' ' << static_cast<int>(as);
            }
            window().showMessage(QString(300, QLatin1Char('x')));
            EXPECT_THAT(moved(before), IsEmpty()) << "a long message";
        }
    }
}

TEST_P(TopBar, WhatItSaysIsWholeInEveryState) {
    for (const char* language : {"en", "de", "ja"}) {
        ASSERT_NO_FATAL_FAILURE(speak(language));
        for (const int width : {Smallest, 1280, 1920}) {
            resizeTo(width);
            for (const As as : Everything) {
                show(as);
                const QRect bar(0, placeOf(stop()).top() - 8, width, stop().height() + 16);
                QStringList inside;
                for (const PaintedText& one : paintedTexts(window()))
                    if (bar.contains(one.box.center().toPoint())) inside += one.text;
                EXPECT_THAT(inside.join(QLatin1Char('|')).toStdString(), Not(HasSubstr("…")))
                    << language << ' ' << width << ' ' << static_cast<int>(as);
                QStringList cut = cutTexts(window()).filter(QStringLiteral("menus"));
                EXPECT_THAT(cut.join(QLatin1Char('|')).toStdString(), "") << language << ' ' << width;
                keep(QStringLiteral("%1_%2_%3_%4")
                         .arg(GetParam())
                         .arg(width)
                         .arg(QLatin1String(language))
                         .arg(static_cast<int>(as)));
            }
        }
    }
}

INSTANTIATE_TEST_SUITE_P(Robots, TopBar, testing::Values(1, 3, 4, 6, 8));

TEST_P(TopBar, EveryLayoutFitsIntoTheSmallestWindow) {
    for (const char* language : {"en", "de", "ja"}) {
        ASSERT_NO_FATAL_FAILURE(speak(language));
        for (const char* layout : {"drive", "explore", "map", "review", "link", "report"}) {
            ASSERT_TRUE(window().layouts().use(QLatin1String(layout)));
            resizeTo(Smallest);
            show(As::Unanswered);
            EXPECT_LE(window().minimumSizeHint().width(), Smallest) << language << ' ' << layout;
            EXPECT_EQ(window().width(), Smallest) << language << ' ' << layout;
            EXPECT_EQ(cut().join(QStringLiteral("; ")).toStdString(), "") << language << ' ' << layout;
            keep(QStringLiteral("%1_%2_%3")
                     .arg(GetParam())
                     .arg(QLatin1String(language), QLatin1String(layout)));
        }
    }
}

TEST_P(TopBar, ThePreflightPageLeavesStopAndRobotsInSight) {
    for (const int width : {Smallest, 1280}) {
        resizeTo(width);
        window().commands().trigger("preflight.open");
        const auto* const page = window().findChild<PreflightPage*>();
        ASSERT_TRUE(QTest::qWaitFor([&] { return page->isVisible(); }));
        const QRect dialog = page->window()->frameGeometry();
        EXPECT_FALSE(dialog.intersects(placeOf(stop()).translated(window().mapToGlobal(QPoint())))) << width;
        for (const RobotChipButton* robot : window().findChildren<RobotChipButton*>())
            EXPECT_FALSE(dialog.intersects(placeOf(*robot).translated(window().mapToGlobal(QPoint()))))
                << width;
        page->window()->close();
    }
}

/// The corner beside the menus.
class MenuCorners : public TopBar {
protected:
    MenuCorners() : TopBar(8, {{"kurt3d", failed()}, {"crawler", failed()}}) {}
    static BrakeResult failed() { return {.verdict = BrakeResult::Verdict::Failed, .seconds = 3.0}; }
    /// How much of the badge @p name is seen in a picture of the window: pixels of the colour of warnings.
    [[nodiscard]] int seen(const char* name) const {
        const auto* const badge = window().findChild<QLabel*>(QLatin1String(name));
        if (badge == nullptr || !badge->isVisible()) return 0;
        const QImage all = window().grab().toImage();
        return countOf(all.copy(placeOf(*badge)), coloursOf(presentTheme()).attention, 40);
    }
    void override(bool on) {
        for (const char* robot : {"kurt3d", "crawler"})
            m_live.bridge->station().brakes().setOverridden(robot, on);
    }
};

TEST_F(MenuCorners, ShowThinLinkAndNoWatchdogBesideEachOtherAndBesideAnyMessage) {
    for (const char* language : {"en", "de", "ja"}) {
        ASSERT_NO_FATAL_FAILURE(speak(language));
        for (const int width : {Smallest, 1280}) {
            resizeTo(width);
            const auto before = places();
            EXPECT_EQ(seen("thinBadge"), 0);
            EXPECT_EQ(seen("brakeBadge"), 0);
            window().commands().trigger("link.thin");
            override(true);
            ASSERT_TRUE(QTest::qWaitFor([&] { return seen("brakeBadge") > 0; }, 10'000)) << language;
            for (const QString& message : {QStringLiteral("short"), QString(400, QLatin1Char('m'))}) {
                window().showMessage(message);
                QApplication::processEvents();
                EXPECT_GT(seen("thinBadge"), 200) << language << ' ' << width;
                EXPECT_GT(seen("brakeBadge"), 300) << language << ' ' << width;
            }
            const auto* const thin = window().findChild<QLabel*>(QStringLiteral("thinBadge"));
            const auto* const brake = window().findChild<QLabel*>(QStringLiteral("brakeBadge"));
            EXPECT_FALSE(placeOf(*thin).intersects(placeOf(*brake)));
            EXPECT_THAT(brake->text().toStdString(), HasSubstr("K C"));
            EXPECT_THAT(brake->toolTip().toStdString(), HasSubstr("Kurt3D, Crawler"));
            EXPECT_EQ(cutTexts(window()).filter(QStringLiteral("adge")).join("; ").toStdString(), "");
            EXPECT_EQ(cutTexts(window()).filter(QStringLiteral("menus")).join("; ").toStdString(), "")
                << language;
            EXPECT_THAT(moved(before), IsEmpty());
            keep(QStringLiteral("corner_%1_%2").arg(width).arg(QLatin1String(language)));
            // Either goes without the other.
            const QRect place = placeOf(*brake);
            window().commands().trigger("link.thin");
            EXPECT_TRUE(QTest::qWaitFor([&] { return seen("thinBadge") == 0 && seen("brakeBadge") > 300; }));
            EXPECT_EQ(placeOf(*brake), place) << "it stays where it is";
            override(false);
            EXPECT_TRUE(QTest::qWaitFor([&] { return seen("brakeBadge") == 0; }, 10'000));
        }
    }
}

}  // namespace
}  // namespace leitstand::test
