#include <algorithm>

#include <QAction>
#include <QLabel>
#include <QTableView>

#include <gtest/gtest.h>

#include "app/session/station/station_mapping.h"
#include "app/window/commands/command_table.h"
#include "app/window/live/layouts/layout_feature.h"
#include "app/window/live/selection.h"
#include "core/base/pose.h"
#include "core/mission/mission_state.h"
#include "tests/app/live/live_page.h"
#include "widgets/map_view/map_view.h"

namespace leitstand::test {
namespace {

/// The live map with real robot processes.
class LiveMapOnScreen : public LivePage {
protected:
    LiveMapOnScreen() {
        m_window->layouts().use("map");
        EXPECT_TRUE(soon([&] { return place("kurt3d").placed; })) << "no scan was registered";
    }
    [[nodiscard]] RobotInMap place(const std::string& name) const {
        for (const RobotInMap& robot : *station().mapping().robots()) {
            if (robot.robot == name) return robot;
        }
        return {};
    }
    void trigger(const char* id) {
        QAction* const action = m_window->commands().find(id);
        ASSERT_NE(action, nullptr) << id;
        EXPECT_TRUE(soon([&] { return action->isEnabled(); })) << id;
        action->trigger();
    }
    [[nodiscard]] std::size_t operatorDecisions() const {
        std::size_t count = 0;
        for (const Decision& one : *station().mission()->decisions) {
            const auto* poses = std::get_if<ScanPosesSample>(&one.content);
            if (poses != nullptr && poses->cause == ScanPosesSample::Cause::Operator && !one.undone) ++count;
        }
        return count;
    }
    /// What Kurt3D says of itself, for a failure's text.
    [[nodiscard]] std::string told() const {
        const auto said = station().mission()->robots.at("kurt3d");
        const std::string mode =
            said->mode ? said->mode->sample.mode + ", " + said->mode->sample.reason : "no mode";
        return mode + (robot().stop.standing ? ", stopped, " : ", ") + std::to_string(speed()) + " m/s";
    }
    [[nodiscard]] MapView& map() const { return m_window->mapView(); }
};

TEST_F(LiveMapOnScreen, GoesToAPlaceThatWasClicked) {
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
        const auto& streams = station().mission()->robots.at("kurt3d")->streams;
        const auto goals = streams.find("/kurt3d/goal_pose");
        return goals != streams.end() && goals->second.events == 1;
    })) << "the goal is on the wire and in the log";
    const auto away = [&] { return (place("kurt3d").baseInMap.translation() - goal).head<2>().norm(); };
    // Warm bodies beside its way are more important to it.
    EXPECT_TRUE(soon([&] { return away() < 0.8 || mode()->sample.mode == "victim_approach"; }))
        << "it is " << away() << " m away, " << mode()->sample.mode << ": " << mode()->sample.reason;
    lookAt("map_went");
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
    const Time heard = place("kurt3d").stamp;
    EXPECT_TRUE(soon([&] { return place("kurt3d").stamp > heard + std::chrono::seconds(2); }));
    const MissionStatePtr said = station().mission();
    const auto& streams = said->robots.at("kurt3d")->streams;
    const auto goals = streams.find("/kurt3d/goal_pose");
    EXPECT_TRUE(goals == streams.end() || goals->second.events == 0);
}

TEST_F(LiveMapOnScreen, RejectRewindAndUndoChangeMapAndLog) {
    station().ask("kurt3d");
    ASSERT_TRUE(soon([&] { return robot().grant.mine; }));
    ASSERT_TRUE(station().setMode("kurt3d", "explore").ok());
    ASSERT_TRUE(soon([&] { return station().mapping().scans()->scans.size() >= 2; }))
        << "it moved not: " << told();
    station().stopAll();
    ASSERT_TRUE(soon([&] { return robot().stop.standing; }));
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

TEST_F(LiveMapOnScreen, TheCrawlerIsPlacedWhereItIsDrawn) {
    ASSERT_TRUE(soon([&] { return m_window->missing().isEmpty(); })) << m_window->missing().toStdString();
    ASSERT_TRUE(soon([&] { return place("kurt3d").placed; }));
    m_window->selection().select("crawler");
    trigger("map.followAbove");
    // Beside Kurt3D, whether it was found there by itself or not.
    const Pose before = place("kurt3d").baseInMap * poseFrom(Eigen::Vector3d(0, -0.8, 0), 0, 0, 0);
    const Eigen::Vector3d ahead = before * Eigen::Vector3d(0.5, 0, 0);
    ASSERT_TRUE(soon([&] {
        const auto at = map().project(ahead);
        return at && map().rect().contains(at->toPoint()) && map().settled();
    }));
    trigger("map.placeRobot");
    const QPoint from = map().project(before.translation())->toPoint(), to = map().project(ahead)->toPoint();
    QTest::mousePress(&map(), Qt::LeftButton, {}, from);
    QMouseEvent drag(QEvent::MouseMove, to, map().mapToGlobal(to), Qt::NoButton, Qt::LeftButton, {});
    QCoreApplication::sendEvent(&map(), &drag);
    QTest::mouseRelease(&map(), Qt::LeftButton, {}, to);
    EXPECT_FALSE(map().drawing());
    EXPECT_TRUE(soon([&] {
        const RobotInMap now = place("crawler");
        return now.placed && (now.baseInMap.translation() - before.translation()).head<2>().norm() < 0.3;
    }));
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
    EXPECT_TRUE(soon([&] { return station().mission()->crop.has_value(); }));
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

}  // namespace
}  // namespace leitstand::test
