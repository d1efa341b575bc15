// A stock robot that has a plane laser only: its map in the window.
#include <algorithm>
#include <cmath>
#include <csignal>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <QAction>
#include <QMenu>
#include <QStringList>

#include <gtest/gtest.h>

#include "app/services/log/live_mission.h"
#include "app/services/station/station_mapping.h"
#include "app/window/commands/command_table.h"
#include "app/window/input/selection.h"
#include "app/window/layouts/layout_feature.h"
#include "core/cloud/labels.h"
#include "core/event/map_samples.h"
#include "core/event/motion_samples.h"
#include "core/event/stream_role.h"
#include "core/mapping/live/map/live_map.h"
#include "core/mapping/live/robot_in_map.h"
#include "tests/app/live/live_page.h"
#include "tests/support/child_process.h"
#include "tests/support/places.h"
#include "tests/transport/dds/test_node.h"
#include "transport/convert/encode.h"
#include "widgets/drive/mode_cell.h"
#include "widgets/map_view/map_view.h"
#include "widgets/models/map/robots/robot_grid.h"
#include "widgets/painting/theme.h"

namespace leitstand::test {
namespace {

class TurtleBotPage : public LivePage {
protected:
    TurtleBotPage() : LivePage(Robots::None, {shippedRobot("turtlebot4")}) {
        m_robot = std::make_unique<ChildProcess>(
            program("leitstand-robot"),
            std::vector<std::string>{"stock", "turtlebot4", "--domain", std::to_string(m_domain.number()),
                                     "--arena", "yellow", "--seed", "7"});
    }
    [[nodiscard]] std::size_t keyScans() const {
        const LiveMapPtr map = station().mapping().scans();
        return map->scans.size();
    }
    [[nodiscard]] Pose baseInMap() const {
        for (const RobotInMap& place : *m_bridge->moment().places)
            if (place.robot == "turtlebot4" && place.placed) return place.baseInMap;
        return Pose::Identity();
    }
    [[nodiscard]] GoalStage stage() const { return station().robot("turtlebot4").navigation.stage; }
    /// Sends the robot @p ahead [m] by a double click on the map.
    [[nodiscard]] bool goesAhead(double ahead) {
        emit m_window->mapView().groundActivated(baseInMap() * Eigen::Vector3d(ahead, 0, 0));
        return soon([&] { return stage() == GoalStage::UnderWay; });
    }
    void trigger(const char* id) {
        QAction* const action = m_window->commands().find(id);
        ASSERT_NE(action, nullptr) << id;
        action->trigger();
    }
    [[nodiscard]] bool isSaid(const char* text) const {
        return !m_window->recent().filter(QLatin1String(text)).isEmpty();
    }
    /// Number of the map's pixels that are nearly in the colour of the robot.
    [[nodiscard]] int inItsColour() const {
        const QImage image = m_window->mapView().grab().toImage();
        const QColor robot = coloursOf(m_window->mapView().settings().theme).robot(0);
        int count = 0;
        for (int y = 0; y < image.height(); ++y) {
            for (int x = 0; x < image.width(); ++x) {
                const QColor pixel = image.pixelColor(x, y);
                const int off = std::abs(pixel.red() - robot.red()) +
                                std::abs(pixel.green() - robot.green()) +
                                std::abs(pixel.blue() - robot.blue());
                count += off < 90 ? 1 : 0;
            }
        }
        return count;
    }
    std::unique_ptr<ChildProcess> m_robot;
};

/// Returns the share of @p cloud, in the map's frame, that lies within 15 cm of an occupied cell of @p grid.
double shareOn(const RobotGrid& grid, const std::vector<Eigen::Vector3d>& cloud) {
    constexpr int Around = 3;  // [cells]
    const OccupancyGridSample& cells = grid.grid->sample;
    const auto isOn = [&](const Eigen::Vector3d& point) {
        const Eigen::Vector3d in = grid.gridInMap.inverse() * point / cells.resolution;
        const int x = int(std::floor(in.x())), y = int(std::floor(in.y()));
        for (int row = std::max(0, y - Around); row <= std::min(cells.height - 1, y + Around); ++row) {
            for (int column = std::max(0, x - Around); column <= std::min(cells.width - 1, x + Around);
                 ++column) {
                const auto at = std::size_t(row) * std::size_t(cells.width) + std::size_t(column);
                if (cells.cells[at] == OccupancyGridSample::Occupied) return true;
            }
        }
        return false;
    };
    return double(std::count_if(cloud.begin(), cloud.end(), isOn)) / double(cloud.size());
}

TEST_F(TurtleBotPage, ItsOwnMapLiesOnOursAndItsPlanIsDrawn) {
    ASSERT_TRUE(soon([&] { return keyScans() > 0 && m_window->missing().isEmpty(); })) << m_robot->out();
    const auto state = [&]() -> const RobotState& { return m_bridge->moment().reported("turtlebot4"); };
    const auto grid = [&]() -> std::optional<RobotGrid> {
        for (const RobotInMap& place : *m_bridge->moment().places)
            if (place.robot == "turtlebot4") return robotGridOf("/map", state(), place);
        return std::nullopt;
    };
    ASSERT_TRUE(soon([&] { return grid().has_value(); }))
        << state().grids.size() << state().framesAbove.size();
    const LiveMapPtr ours = station().mapping().scans();
    const LiveKeyScan& scan = ours->scans.front();
    std::vector<Eigen::Vector3d> cloud;
    for (const Eigen::Vector3f& point : scan.scan->points)
        cloud.emplace_back(scan.pose.scanInMap * point.cast<double>());
    ASSERT_GT(cloud.size(), 100U);
    EXPECT_GT(shareOn(*grid(), cloud), 0.9);
    RobotGrid turned = *grid();
    turned.gridInMap = poseFrom({0.0, 0.0, 0.0}, 0.0, 0.0, degrees(30)) * turned.gridInMap;
    EXPECT_LT(shareOn(turned, cloud), 0.6) << "as it would lie without tf";

    m_window->layouts().use("map");
    ASSERT_TRUE(soon([&] { return m_window->missing().isEmpty(); }));
    const int bare = inItsColour();
    trigger("map.robotGrid");
    EXPECT_TRUE(soon([&] { return isSaid("/map is shown over the map"); }));
    EXPECT_TRUE(soon([&] { return inItsColour() > bare + 500; })) << bare << ", " << inItsColour();
    lookAt("robot_grid");
    trigger("map.robotGrid");
    EXPECT_TRUE(soon([&] { return isSaid("no map of its own is shown"); }));
    EXPECT_TRUE(soon([&] { return inItsColour() < bare + 100; })) << bare << ", " << inItsColour();

    const auto node = nodeIn(m_domain);
    const StreamDescription plan = *shippedRobot("turtlebot4").stream(StreamRole::Path);
    const auto planner = must(node->publisher({plan.topic, plan.type, plan.qos}));
    PathSample path{{{}, "base_link"}, {}};
    for (int i = 0; i < 60; ++i) path.posesInFrame.push_back(poseFrom({0.05 * i, 0.0, 0.0}, 0.0, 0.0, 0.0));
    EXPECT_TRUE(soon([&] {
        (void)planner->write(must(encode(path, plan.type)));
        QTest::qWait(100);
        return inItsColour() > bare + 150;
    })) << bare
        << ", " << inItsColour();
    lookAt("robot_plan");
}

TEST_F(TurtleBotPage, IsMappedWhileItDrives) {
    ASSERT_TRUE(soon([&] { return keyScans() > 0; })) << m_robot->out();
    m_window->activateWindow();
    ASSERT_TRUE(soon([&] { return m_window->isActiveWindow(); }));
    press(Qt::Key_F2);
    const auto drives = [&] {
        return m_window->findChild<ModeCell*>()->accessibleDescription().toStdString();
    };
    ASSERT_TRUE(soon([&] { return mayDrive("turtlebot4"); })) << drives();
    QTest::keyPress(m_window.get(), Qt::Key_D);  // around on the spot
    EXPECT_TRUE(soon([&] { return keyScans() >= 12; })) << keyScans() << "; " << drives();
    QTest::keyRelease(m_window.get(), Qt::Key_D);
    const LiveMapPtr map = station().mapping().scans();
    const auto certain = std::count_if(map->scans.begin(), map->scans.end(),
                                       [](const LiveKeyScan& scan) { return scan.counts(); });
    EXPECT_GE(certain, static_cast<std::ptrdiff_t>(map->scans.size()) - 1);
    for (const LiveKeyScan& scan : map->scans) EXPECT_TRUE(isPlaneScan(scan.scan->points));
    lookAt("plane_map");
}

TEST_F(TurtleBotPage, IsSentByItsOwnNavigationUntilItArrivesOrIsStopped) {
    ASSERT_TRUE(soon([&] { return keyScans() > 0 && m_window->missing().isEmpty(); })) << m_robot->out();
    ASSERT_TRUE(soon([&] { return station().robot("turtlebot4").navigation.offered; }));
    m_window->layouts().use("map");
    m_window->selection().select("turtlebot4");
    ASSERT_TRUE(goesAhead(0.6)) << m_window->recent().join("; ").toStdString();
    ASSERT_TRUE(soon([&] { return std::isfinite(station().robot("turtlebot4").navigation.metresLeft); }));
    lookAt("navigation");
    EXPECT_TRUE(soon([&] { return isSaid("TurtleBot 4 has arrived"); }));

    ASSERT_TRUE(goesAhead(-0.6));
    station().stopAll();
    EXPECT_TRUE(soon([&] { return stage() == GoalStage::Cancelled; }));
    EXPECT_TRUE(soon([&] { return station().robot("turtlebot4").stop.standing; }));
    for (const StopServiceStatus& service : station().robot("turtlebot4").stop.services) {
        EXPECT_TRUE(service.offered) << service.title;
        EXPECT_EQ(service.stage, StopServiceStatus::Stage::Stopped) << service.title;
    }
    lookAt("navigation_stopped");
    EXPECT_FALSE(isSaid("was cancelled")) << "everybody knows why";
    ASSERT_TRUE(soon([&] { return station().release("turtlebot4").ok(); }));
    ASSERT_TRUE(soon([&] { return !station().robot("turtlebot4").stop.releasing; }));
    m_window->activateWindow();
    ASSERT_TRUE(soon([&] { return m_window->isActiveWindow(); }));
    press(Qt::Key_F2);
    ASSERT_TRUE(soon([&] { return mayDrive("turtlebot4"); }));
    ASSERT_TRUE(goesAhead(-0.6)) << "it may go again";
    QTest::keyPress(m_window.get(), Qt::Key_D);
    EXPECT_TRUE(soon([&] { return isSaid("its goal is cancelled, since you drive"); }))
        << m_window->recent().join("; ").toStdString();
    QTest::keyRelease(m_window.get(), Qt::Key_D);
    EXPECT_TRUE(soon([&] { return stage() == GoalStage::Cancelled; }));
}

TEST_F(TurtleBotPage, IsSentFromPlaceToPlaceAndBackToItsStart) {
    ASSERT_TRUE(soon([&] { return keyScans() > 0 && m_window->missing().isEmpty(); })) << m_robot->out();
    ASSERT_TRUE(soon([&] { return station().robot("turtlebot4").navigation.offered; }));
    m_window->layouts().use("map");
    m_window->selection().select("turtlebot4");
    const Pose start = baseInMap();
    const auto awayFrom = [&](const Eigen::Vector3d& place) {
        return (baseInMap().translation() - place).head<2>().norm();
    };
    const auto arrivals = [&] { return m_window->recent().filter("TurtleBot 4 has arrived").size(); };
    const Eigen::Vector3d first = start * Eigen::Vector3d(0.5, 0, 0),
                          second = start * Eigen::Vector3d(1.0, 0, 0);
    ASSERT_TRUE(goesAhead(0.5)) << m_window->recent().join("; ").toStdString();
    trigger("map.goToNext");
    emit m_window->mapView().poseDrawn({second, std::nullopt});
    QTest::qWait(200);
    lookAt("waypoints");
    EXPECT_TRUE(soon([&] { return arrivals() == 1; }));
    EXPECT_LT(awayFrom(first), 0.35);
    EXPECT_TRUE(soon([&] { return arrivals() == 2; })) << m_window->recent().join("; ").toStdString();
    EXPECT_LT(awayFrom(second), 0.35);
    trigger("map.returnToStart");
    EXPECT_TRUE(soon([&] { return arrivals() == 3; })) << m_window->recent().join("; ").toStdString();
    EXPECT_LT(awayFrom(start.translation()), 0.35);

    ASSERT_TRUE(goesAhead(0.6));
    trigger("map.goToNext");
    emit m_window->mapView().poseDrawn({second, std::nullopt});
    station().stopAll();
    EXPECT_TRUE(soon([&] { return stage() == GoalStage::Cancelled; }));
    ASSERT_TRUE(soon([&] { return station().robot("turtlebot4").stop.standing; }));
    ASSERT_TRUE(soon([&] { return station().release("turtlebot4").ok(); }));
    ASSERT_TRUE(soon([&] { return !station().robot("turtlebot4").stop.releasing; }));
    QTest::qWait(1500);
    EXPECT_EQ(stage(), GoalStage::Cancelled) << "it is not sent on after a stop";
    EXPECT_EQ(arrivals(), 3);
}

TEST_F(TurtleBotPage, ItsServicesAreCalledFromTheMenu) {
    ASSERT_TRUE(soon([&] { return m_window->missing().isEmpty(); })) << m_robot->out();
    m_window->selection().select("turtlebot4");
    const auto entry = [&](const char* name) -> QAction* {
        for (QMenu* const menu : m_window->findChildren<QMenu*>()) {
            if (!menu->title().contains("Se&rvices")) continue;
            emit menu->aboutToShow();
            return menu->findChild<QAction*>(QLatin1String(name));
        }
        return nullptr;
    };
    ASSERT_NE(entry("/oakd/stop_camera"), nullptr);
    EXPECT_EQ(entry("/e_stop"), nullptr) << "STOP calls it";
    ASSERT_TRUE(soon([&] { return entry("/oakd/stop_camera")->isEnabled(); }));
    const auto pictures = [&] {
        const auto state = station().mission()->robots.at("turtlebot4");
        const auto stream = state->streams.find("/oakd/rgb/preview/image_raw/compressed");
        return stream == state->streams.end() ? 0 : stream->second.events;
    };
    ASSERT_TRUE(soon([&] { return pictures() > 0; }));
    if (const QString folder = qEnvironmentVariable("LEITSTAND_PICTURES"); !folder.isEmpty()) {
        for (QMenu* const menu : m_window->findChildren<QMenu*>())
            if (menu->title().contains("Se&rvices")) menu->grab().save(folder + "/live_services_menu.png");
    }
    entry("/oakd/stop_camera")->trigger();
    ASSERT_TRUE(soon([&] { return isSaid("Stop camera: done"); }))
        << m_window->recent().join("; ").toStdString();
    QTest::qWait(500);
    const auto before = pictures();
    QTest::qWait(1000);
    EXPECT_EQ(pictures(), before);
    entry("/oakd/start_camera")->trigger();
    EXPECT_TRUE(soon([&] { return pictures() > before; }));
    m_robot->signal(SIGTERM);
    ASSERT_TRUE(soon([&] { return !entry("/oakd/stop_camera")->isEnabled(); }));
    EXPECT_FALSE(station().call("turtlebot4", "/oakd/stop_camera", true).ok());
    EXPECT_FALSE(station().call("turtlebot4", "/e_stop", true).ok()) << "it is not the operator's";
}

}  // namespace
}  // namespace leitstand::test
