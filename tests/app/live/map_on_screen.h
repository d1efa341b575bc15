#pragma once

#include <algorithm>
#include <optional>
#include <string>

#include <QAction>
#include <QMouseEvent>
#include <QTemporaryDir>

#include <gtest/gtest.h>

#include "app/services/log/live_mission.h"
#include "app/services/station/station_mapping.h"
#include "app/window/commands/command_table.h"
#include "app/window/layouts/layout_feature.h"
#include "core/base/pose.h"
#include "core/event/station_topics.h"
#include "core/event/status_samples.h"
#include "core/mission/state/decision.h"
#include "core/mission/state/mission_state.h"
#include "tests/app/live/live_page.h"
#include "tests/support/temporary_folder.h"
#include "widgets/map_view/map_view.h"
#include "widgets/map_view/scene/points/map_colours.h"

namespace leitstand::test {

/// Pixels of @p view in the hue of what a scan's points would become.
inline int countViolet(MapView& view) {
    const Rgba wanted = mapColours(view.settings().theme).scanInQuestion;
    const QImage image = view.grab().toImage();
    int count = 0;
    for (int y = 0; y < image.height(); ++y) {
        for (int x = 0; x < image.width(); ++x) {
            const QRgb pixel = image.pixel(x, y);
            count += qRed(pixel) == wanted.r && qGreen(pixel) == wanted.g && qBlue(pixel) == wanted.b ? 1 : 0;
        }
    }
    return count;
}

/// The live map with real robot processes.
class LiveMapOnScreen : public LivePage {
protected:
    LiveMapOnScreen() : LiveMapOnScreen(QStringLiteral("yellow")) {}
    /// @p arena: a grade, or a file.
    explicit LiveMapOnScreen(const QString& arena) : LivePage(Robots::None) {
        startRobots(arena);
        m_window->layouts().use("map");
        EXPECT_TRUE(soon([&] { return place("kurt3d").placed; })) << "no scan was registered";
    }
    [[nodiscard]] RobotInMap place(const std::string& name) const {
        const RobotsInMapPtr robots = station().mapping().robots();
        for (const RobotInMap& robot : *robots) {
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
        const MissionStatePtr mission = station().mission();
        for (const Decision& one : *mission->decisions) {
            const auto* poses = std::get_if<ScanPosesSample>(&one.content);
            if (poses != nullptr && poses->cause == ScanPosesSample::Cause::Operator && !one.undone) ++count;
        }
        return count;
    }
    /// What Kurt3D says of itself, for a failure's text.
    [[nodiscard]] std::string reported() const {
        const auto reported = station().mission()->robots.at("kurt3d");
        const std::string mode =
            reported->mode ? reported->mode->sample.mode + ", " + reported->mode->sample.reason : "no mode";
        return mode + (robot().stop.standing ? ", stopped, " : ", ") + std::to_string(speed()) + " m/s";
    }
    [[nodiscard]] MapView& map() const { return m_window->mapView(); }
    /// Presses the map at @p place and lets go 0.6 m ahead of it, once both are to be seen.
    void draw(const Pose& place) {
        const Eigen::Vector3d ahead = place * Eigen::Vector3d(0.6, 0, 0);
        ASSERT_TRUE(soon([&] {
            const auto at = map().project(place.translation()), to = map().project(ahead);
            return at && to && map().rect().contains(at->toPoint()) && map().rect().contains(to->toPoint()) &&
                   map().settled();
        }));
        const QPoint from = map().project(place.translation())->toPoint();
        const QPoint to = map().project(ahead)->toPoint();
        QTest::mousePress(&map(), Qt::LeftButton, {}, from);
        QMouseEvent drag(QEvent::MouseMove, to, map().mapToGlobal(to), Qt::NoButton, Qt::LeftButton, {});
        QCoreApplication::sendEvent(&map(), &drag);
        QTest::mouseRelease(&map(), Qt::LeftButton, {}, to);
        EXPECT_FALSE(map().drawing());
    }
    /// The station says, as it begins anew, that the newest scan may see what the first one saw, @p off from
    /// where it lies [m]. Returns the link that is asked about.
    Link askWhetherItMeetsItself(const Eigen::Vector3d& off) {
        const auto scans = station().mapping().scans()->scans;
        ScanLinksSample question{Time(std::chrono::seconds(1'800'000'000)), "us", {Link{}}};
        Link& link = question.links.front();
        link.id = 90'000;
        link.from = scans.front().id;
        link.to = scans.back().id;
        link.kind = LinkKind::Loop;
        link.active = false;
        link.information *= 1e4;
        link.pose = scans.front().pose.scanInMap.inverse() * scans.back().pose.scanInMap;
        link.pose.translation() += off;
        restart([&] {
            LiveMissionSettings settings;
            settings.folder = m_folder.path().toStdString() + "/mission";
            settings.robots = {shippedRobot("kurt3d"), shippedRobot("crawler")};
            auto mission = LiveMission::open(settings).value();
            ASSERT_TRUE(mission->record(question, station_topic::ScanLinks).ok());
            ASSERT_TRUE(mission->close());
        });
        return link;
    }
    /// What it does once there are enough scans: it is stopped, or waits in a mode in which it is driven.
    enum class Then { IsStopped, Waits };
    /// Kurt3D goes until the map has two scans that count, and stands.
    void mapTwoScans(Then then = Then::IsStopped) {
        station().requestGrant("kurt3d");
        ASSERT_TRUE(soon([&] { return robot().grant.mine; }));
        ASSERT_TRUE(station().setMode("kurt3d", "explore").ok());
        ASSERT_TRUE(soon([&] {
            const auto scans = station().mapping().scans()->scans;
            return std::count_if(scans.begin(), scans.end(), [](const auto& one) { return one.counts(); }) >=
                   2;
        })) << "it moved not: "
            << reported();
        if (then == Then::Waits) {
            ASSERT_TRUE(station().setMode("kurt3d", "teleoperation").ok());
            ASSERT_TRUE(soon([&] {
                return station().mission()->robots.at("kurt3d")->mode->sample.mode == "teleoperation" &&
                       std::abs(speed()) < 0.01;
            })) << reported();
            return;
        }
        station().stopAll();
        ASSERT_TRUE(soon([&] { return robot().stop.standing; }));
    }
};

/// An empty hall: nothing warm is more important to a robot than where it was sent.
class LiveMapOfAHall : public LiveMapOnScreen {
protected:
    LiveMapOfAHall() : LiveMapOnScreen(hall()) {}

private:
    static QString hall() {
        static const QTemporaryDir folder;
        QString file = folder.filePath(QStringLiteral("hall.yaml"));
        writeText(file.toStdString(), R"(name: empty_hall
from: [-3, -2]
to: [9, 2]
starts:
  kurt3d: {position: [-1.8, 0.6, 0]}
  crawler: {position: [-1.8, -0.6, 0]}
elements:
  - {kind: floor, position: [3, 0, 0], size: [12, 4, 0.1]}
  - {kind: wall, name: north, position: [3, 2, 0], size: [12, 0.05, 1.2]}
  - {kind: wall, name: south, position: [3, -2, 0], size: [12, 0.05, 1.2]}
  - {kind: wall, name: east, position: [9, 0, 0], turn: [0, 0, 90], size: [4, 0.05, 1.2]}
  - {kind: wall, name: west, position: [-3, 0, 0], turn: [0, 0, 90], size: [4, 0.05, 1.2]}
)");
        return file;
    }
};

}  // namespace leitstand::test
