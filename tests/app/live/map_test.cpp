#include <algorithm>
#include <chrono>
#include <cmath>
#include <optional>

#include <QAction>
#include <QComboBox>
#include <QFrame>
#include <QLabel>
#include <QTableView>

#include <gtest/gtest.h>

#include "app/services/log/live_mission.h"
#include "app/services/station/station_mapping.h"
#include "app/window/commands/command_table.h"
#include "app/window/input/selection.h"
#include "app/window/layouts/layout_feature.h"
#include "core/base/pose.h"
#include "core/event/station_topics.h"
#include "core/event/stream_role.h"
#include "core/mapping/placement/placement.h"
#include "core/mission/state/mission_state.h"
#include "tests/app/live/map_on_screen.h"
#include "widgets/models/map/robots/robot_mark.h"

namespace leitstand::test {
namespace {

TEST_F(LiveMapOfAHall, GoesToAPlaceThatWasClicked) {
    ASSERT_TRUE(soon([&] { return m_window->missing().isEmpty(); })) << m_window->missing().toStdString();
    trigger("map.followAbove");
    const Pose before = place("kurt3d").baseInMap;
    const Eigen::Vector3d goal = before * Eigen::Vector3d(0.9, 0, 0);
    ASSERT_TRUE(soon([&] {
        const auto at = map().project(goal);
        return at && map().rect().contains(at->toPoint()) && map().settled();
    }));
    trigger("map.goTo");
    EXPECT_TRUE(map().drawing());
    QTest::mouseClick(&map(), Qt::LeftButton, {}, map().project(goal)->toPoint());
    EXPECT_FALSE(map().drawing());
    EXPECT_FALSE(m_window->commands().find("map.goTo")->isChecked());
    const auto mode = [&] { return station().mission()->robots.at("kurt3d")->mode; };
    EXPECT_TRUE(soon([&] { return mode() && mode()->sample.mode == "explore"; }));
    EXPECT_TRUE(soon([&] {
        const auto streams = station().mission()->robots.at("kurt3d")->streams;
        const auto goals = streams.find("/kurt3d/goal_pose");
        return goals != streams.end() && goals->second.events == 1;
    })) << "the goal is on the wire and in the log";
    const auto away = [&] { return (place("kurt3d").baseInMap.translation() - goal).head<2>().norm(); };
    // It stops a quarter of a metre before the place at the latest.
    EXPECT_TRUE(soon([&] { return away() < 0.4; }))
        << "it is " << away() << " m away, " << mode()->sample.mode << ": " << mode()->sample.reason;
    EXPECT_GT((place("kurt3d").baseInMap.translation() - before.translation()).head<2>().norm(), 0.4);
    lookAt("map_went");
}

/// Kurt3D takes no goals, and the Crawler was not heard yet.
class NobodyGoes : public LivePage {
protected:
    NobodyGoes() : LivePage(Robots::None, {withoutGoals(), shippedRobot("crawler")}) {}

private:
    static RobotDescription withoutGoals() {
        RobotDescription robot = shippedRobot("kurt3d");
        std::erase_if(robot.streams,
                      [](const StreamDescription& one) { return one.role == StreamRole::GoalPose; });
        return robot;
    }
};

TEST_F(NobodyGoes, ADoubleClickSaysWhy) {
    const auto says = [&](const char* robot, const char* why) {
        m_window->selection().select(QLatin1String(robot));
        emit m_window->mapView().groundActivated({1.0, 0.0, 0.0});
        EXPECT_EQ(m_window->newest().toStdString(), why);
    };
    says("kurt3d", "Kurt3D takes no goals");
    EXPECT_FALSE(m_window->commands().find(QStringLiteral("map.goTo"))->isEnabled());
    says("crawler", "Crawler is not in the map yet");
    EXPECT_TRUE(m_window->commands().find(QStringLiteral("map.goTo"))->isEnabled());
}

TEST_F(LiveMapOnScreen, SpaceTakesBackAGoalThatWasNotSentYet) {
    ASSERT_TRUE(soon([&] { return m_window->missing().isEmpty(); })) << m_window->missing().toStdString();
    trigger("map.followAbove");
    const Eigen::Vector3d goal = place("kurt3d").baseInMap * Eigen::Vector3d(0.9, 0, 0);
    ASSERT_TRUE(soon([&] {
        const auto at = map().project(goal);
        return at && map().rect().contains(at->toPoint()) && map().settled();
    }));
    m_window->setDriving(true);
    trigger("map.goTo");
    // Before the window's next tick, which would send it.
    QTest::mouseClick(&map(), Qt::LeftButton, {}, map().project(goal)->toPoint());
    press(Qt::Key_Space);
    const auto word = [&] { return m_window->recent().join("; "); };
    EXPECT_TRUE(soon([&] { return word().contains("not sent"); })) << word().toStdString();
    // Some scans later it still was not.
    const Time received = place("kurt3d").stamp;
    EXPECT_TRUE(soon([&] { return place("kurt3d").stamp > received + std::chrono::seconds(2); }));
    const MissionStatePtr reported = station().mission();
    const auto& streams = reported->robots.at("kurt3d")->streams;
    const auto goals = streams.find("/kurt3d/goal_pose");
    EXPECT_TRUE(goals == streams.end() || goals->second.events == 0);
}

TEST_F(LiveMapOnScreen, RejectRewindAndUndoChangeMapAndLog) {
    ASSERT_NO_FATAL_FAILURE(mapTwoScans());
    const auto scans = [&] { return station().mapping().scans()->scans; };
    const auto aside = [&] {
        const auto all = scans();
        return std::count_if(all.begin(), all.end(),
                             [](const auto& one) { return one.pose.trust == ScanTrust::SetAside; });
    };
    auto* table = m_window->findChild<QTableView*>("keyScans");
    ASSERT_NE(table, nullptr);
    const auto title = [&] { return m_window->findChild<QLabel*>("mapTitle")->text(); };
    ASSERT_TRUE(soon([&] { return table->model()->rowCount() >= 2; }));
    table->selectRow(table->model()->rowCount() - 1);
    QAction* const undo = m_window->commands().find("scan.undo");
    EXPECT_FALSE(undo->isEnabled()) << "nothing was decided";
    trigger("scan.rewind");
    EXPECT_TRUE(soon([&] { return title().contains(" 1 key scan "); })) << title().toStdString();
    EXPECT_TRUE(soon([&] { return operatorDecisions() == 1; }));
    EXPECT_TRUE(soon([&] { return undo->text().contains("set aside"); })) << undo->text().toStdString();
    EXPECT_TRUE(undo->toolTip().contains("set aside") && undo->toolTip().contains("Ctrl+Z"));
    trigger("scan.undo");
    EXPECT_TRUE(soon([&] { return aside() == 0 && operatorDecisions() == 0; }));
    EXPECT_TRUE(soon([&] { return title().contains("key scans"); })) << title().toStdString();
    trigger("scan.reject");
    EXPECT_TRUE(soon([&] { return aside() == 1 && operatorDecisions() == 1; }));
    EXPECT_TRUE(soon([&] {
        return table->model()->index(table->model()->rowCount() - 1, 1).data().toString() == "set aside";
    }));
    trigger("scan.undo");
    EXPECT_TRUE(soon([&] { return aside() == 0 && operatorDecisions() == 0; }));
    trigger("scan.redo");
    EXPECT_TRUE(soon([&] { return aside() == 1 && operatorDecisions() == 1; }));
    trigger("scan.accept");
    EXPECT_TRUE(soon([&] { return aside() == 0; }));
    lookAt("map_decisions");
}

TEST_F(LiveMapOnScreen, AScanIsTriedAgainWithAnotherSearchAndFromAPoseThatIsDrawn) {
    ASSERT_NO_FATAL_FAILURE(mapTwoScans());
    auto* const table = m_window->findChild<QTableView*>("keyScans");
    auto* const schedules = m_window->findChild<QComboBox*>("retrySchedule");
    ASSERT_TRUE(table != nullptr && schedules != nullptr);
    ASSERT_TRUE(soon([&] { return table->model()->rowCount() >= 2; }));
    // The newest that was registered and fits; the list begins with the newest.
    const auto all = station().mapping().scans()->scans;
    const auto chosen = std::find_if(all.rbegin(), all.rend(), [](const LiveKeyScan& one) {
        return one.matched != 0 && one.pose.trust == ScanTrust::Certain;
    });
    ASSERT_NE(chosen, all.rend()) << "no scan fits";
    const LiveKeyScan before = *chosen;
    const auto now = [&] {
        const auto scans = station().mapping().scans()->scans;
        return *std::find_if(scans.begin(), scans.end(),
                             [&](const auto& one) { return one.id == before.id; });
    };
    const auto off = [&] {
        return (now().pose.scanInMap.translation() - before.pose.scanInMap.translation()).norm();
    };
    ASSERT_TRUE(soon([&] { return table->model()->rowCount() == static_cast<int>(all.size()); }));
    table->selectRow(static_cast<int>(chosen - all.rbegin()));
    schedules->setCurrentIndex(schedules->count() - 1);
    trigger("scan.retry");
    ASSERT_TRUE(soon([&] { return operatorDecisions() == 1; })) << m_window->newest().toStdString();
    EXPECT_EQ(now().pose.trust, ScanTrust::Certain);
    EXPECT_LT(off(), 0.05) << "it is where it was found at first";

    schedules->setCurrentIndex(0);
    trigger("map.followAbove");
    const Pose was = before.pose.scanInMap * before.sensorInBase.inverse();
    trigger("scan.retryFromPose");
    ASSERT_NO_FATAL_FAILURE(draw(was * poseFrom({0.25, 0.15, 0}, 0, 0, degrees(10))));
    ASSERT_TRUE(soon([&] { return operatorDecisions() == 2; })) << m_window->newest().toStdString();
    EXPECT_EQ(now().pose.trust, ScanTrust::Certain);
    EXPECT_LT(off(), 0.05) << "it finds back from where it was drawn";
}

TEST_F(LiveMapOnScreen, TheCrawlerIsPlacedWhereItIsDrawn) {
    ASSERT_TRUE(soon([&] { return m_window->missing().isEmpty(); })) << m_window->missing().toStdString();
    ASSERT_TRUE(soon([&] { return place("crawler").certain; })) << "it was not found beside Kurt3D";
    m_window->selection().select("crawler");
    trigger("map.followAbove");
    // Away from where it is and turned, farther than its laser is matched about a drawn place.
    const Pose before = place("crawler").baseInMap;
    const Pose drawn = before * poseFrom(Eigen::Vector3d(0.5, 0.3, 0), 0, 0, degrees(60));
    const auto reported = [&] { return station().mission()->robots.at("crawler")->place; };
    ASSERT_TRUE(reported() != nullptr);
    ASSERT_NE(reported()->sample.cause, RobotPlaceSample::Cause::Operator) << "it was placed by itself";
    trigger("map.placeRobot");
    ASSERT_NO_FATAL_FAILURE(draw(drawn));
    // Its laser may go on to look for it: what the operator did is told first.
    std::optional<RobotPlaceSample> placed;
    ASSERT_TRUE(soon([&] {
        if (reported()->sample.cause == RobotPlaceSample::Cause::Operator) placed = reported()->sample;
        return placed.has_value();
    }));
    const double off = (placed->baseInMap.translation() - drawn.translation()).head<2>().norm();
    const double turned = std::abs(std::remainder(headingOf(placed->baseInMap) - headingOf(drawn), 2 * M_PI));
    const PlacementSettings laser;
    EXPECT_LT(off, 0.1 + (placed->certain ? 1.5 * laser.dragged.distance : 0.0)) << placed->how;
    EXPECT_LT(turned, degrees(5) + (placed->certain ? laser.dragged.angle : 0.0)) << placed->how;
    EXPECT_EQ(placed->robot, "crawler");
    lookAt("map_placed");
}

TEST_F(LiveMapOnScreen, WhatBelongsIntoTheMapIsUndoneAndRestoredAfterARestart) {
    ASSERT_TRUE(soon([&] { return m_window->missing().isEmpty() && map().settled(); }));
    trigger("map.area");
    for (const QPoint corner : {QPoint(60, 60), QPoint(300, 60), QPoint(300, 200), QPoint(60, 200)})
        QTest::mouseClick(&map(), Qt::LeftButton, {}, corner);
    QTest::mouseDClick(&map(), Qt::LeftButton, {}, {60, 200});
    const auto corners = [&] { return station().mapping().crop().polygon.size(); };
    EXPECT_TRUE(soon([&] { return corners() >= 3; }));
    EXPECT_TRUE(soon([&] { return station().mission()->crop != nullptr; }));
    trigger("scan.undo");
    EXPECT_TRUE(soon([&] { return corners() == 0; }));
    trigger("scan.redo");
    EXPECT_TRUE(soon([&] { return corners() >= 3; }));
    const auto kept = station().mapping().crop().polygon;
    restart();
    EXPECT_EQ(station().mapping().crop().polygon, kept);
    QAction* const everything = m_window->commands().find("map.everywhere");
    ASSERT_TRUE(soon([&] { return everything->isEnabled(); })) << "the station has the map again";
    ASSERT_TRUE(soon([&] {
        everything->trigger();
        return corners() == 0;
    }));
    EXPECT_TRUE(soon([&] { return !everything->isEnabled(); }));
}

TEST_F(LiveMapOnScreen, APlaceWhereTheMapMayMeetItselfIsAskedAboutAnsweredAndTakenBack) {
    ASSERT_NO_FATAL_FAILURE(mapTwoScans());
    // What the station itself says where the map erred more than it should have.
    const Link link = askWhetherItMeetsItself({0.3, 0.4, 0.0});
    m_window->layouts().use("explore");
    auto* const asked = m_window->findChild<QFrame*>("loopQuestion");
    ASSERT_NE(asked, nullptr);
    ASSERT_TRUE(soon([&] { return asked->isVisible(); }));
    EXPECT_TRUE(asked->accessibleName().contains("0.50 m")) << asked->accessibleName().toStdString();
    EXPECT_TRUE(soon([&] { return asked->accessibleName().contains("Scans moved: "); }))
        << asked->accessibleName().toStdString();
    EXPECT_TRUE(asked->parentWidget()->rect().contains(asked->geometry())) << "nothing of it is cut";
    EXPECT_TRUE(soon([&] { return countViolet(m_window->mapView()) > 100; })) << "the ghost of the map";
    lookAt("map_question");
    m_window->layouts().use("drive");
    EXPECT_TRUE(soon([&] {
        const QRect map = asked->parentWidget()->rect();
        return asked->isVisible() && map.contains(asked->geometry()) && 4 * asked->height() < map.height();
    })) << "one drives by the small map: it takes "
        << asked->height() << " of " << asked->parentWidget()->height();
    lookAt("map_question_drive");
    m_window->layouts().use("explore");
    trigger("loop.refuse");
    EXPECT_TRUE(soon([&] { return !asked->isVisible(); }));
    QAction* const undo = m_window->commands().find("scan.undo");
    EXPECT_TRUE(soon([&] { return undo->text().contains("kept apart"); })) << undo->text().toStdString();
    trigger("scan.undo");
    EXPECT_TRUE(soon([&] { return asked->isVisible(); })) << "it is asked again";
    const auto seam = [&] {
        const auto now = station().mapping().scans()->scans;
        const auto at = [&](std::uint64_t id) {
            return std::find_if(now.begin(), now.end(), [id](const auto& one) { return one.id == id; })
                ->pose.scanInMap;
        };
        return distanceBetween(at(link.from) * link.pose, at(link.to));
    };
    const double before = seam();
    EXPECT_NEAR(before, 0.5, 0.05);
    trigger("loop.close");
    EXPECT_TRUE(soon([&] { return !asked->isVisible() && seam() < before - 0.05; })) << seam();
    trigger("loop.undo");
    EXPECT_TRUE(soon([&] { return std::abs(seam() - before) < 0.02; })) << seam() << ", before " << before;
    EXPECT_TRUE(soon([&] { return asked->isVisible(); })) << "the answer is taken back: it is asked again";
}

}  // namespace
}  // namespace leitstand::test
