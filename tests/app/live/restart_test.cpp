#include <algorithm>
#include <chrono>
#include <map>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "app/services/station/station_clock.h"
#include "app/services/station/station_mapping.h"
#include "app/window/frame/pane_docks.h"
#include "app/window/layouts/layout_feature.h"
#include "core/mission/state/mission_state.h"
#include "tests/app/live/live_page.h"

namespace leitstand::test {
namespace {

using LiveRestart = LivePage;

TEST_F(LiveRestart, MapRobotsGrantAndClockAreBackInTenSeconds) {
    ASSERT_TRUE(soon([&] { return m_window->missing().isEmpty(); })) << m_window->missing().toStdString();
    ASSERT_TRUE(station().clock().limit(std::chrono::minutes(20)).ok());
    m_window->setDriving(true);
    ASSERT_TRUE(soon([&] { return robot().grant.mine; }));
    const auto poses = [&] {
        std::map<std::uint64_t, Pose> found;
        const LiveMapPtr map = station().mapping().scans();
        for (const LiveKeyScan& scan : map->scans) found[scan.id] = scan.pose.scanInMap;
        return found;
    };
    const auto before = poses();
    ASSERT_FALSE(before.empty());
    const auto elapsed = station().clock().now().elapsed;
    ASSERT_GT(elapsed.count(), 0);

    const auto began = std::chrono::steady_clock::now();
    restart();
    const auto placed = [&] {
        const RobotsInMapPtr robots = station().mapping().robots();
        return std::any_of(robots->begin(), robots->end(), [](const RobotInMap& one) { return one.placed; });
    };
    ASSERT_TRUE(soon([&] { return m_window->missing().isEmpty() && robot().grant.mine && placed(); }))
        << m_window->missing().toStdString();
    const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - began).count();
    RecordProperty("seconds", std::to_string(seconds));
    std::printf("all is back after %.1f s\n", seconds);
    EXPECT_LT(seconds, 10.0);
    const auto after = poses();
    for (const auto& [scan, pose] : before) {
        ASSERT_TRUE(after.contains(scan)) << "scan " << scan << " is not in the map any more";
        EXPECT_TRUE(after.at(scan).isApprox(pose, 1e-6)) << "scan " << scan << " lies elsewhere";
    }
    EXPECT_TRUE(placed()) << "the robot has its place in the map";
    EXPECT_GE(station().clock().now().elapsed, elapsed) << "the mission's time does not begin anew";
    EXPECT_EQ(station().clock().now().limit, std::chrono::minutes(20));
    EXPECT_FALSE(m_window->driving()) << "motion does not resume by itself";
}

TEST_F(LiveRestart, LayoutsAreSavedAndLoaded) {
    LayoutFeature& layouts = m_window->layouts();
    PaneDocks& panes = m_window->panes();
    EXPECT_EQ(layouts.current().name, "drive");
    press(Qt::Key_F7);
    EXPECT_EQ(layouts.current().name, "map");
    EXPECT_FALSE(panes.isPaneVisible("camera"));
    ASSERT_TRUE(layouts.saveAs("Second screen"));
    EXPECT_EQ(layouts.current().name, "second-screen");
    press(Qt::Key_F5);
    EXPECT_TRUE(panes.isPaneVisible("camera"));
    restart();
    EXPECT_TRUE(m_window->panes().isPaneVisible("camera"));
    ASSERT_TRUE(m_window->layouts().use("second-screen"));
    EXPECT_FALSE(m_window->panes().isPaneVisible("camera"));
    EXPECT_TRUE(m_window->panes().isPaneVisible("map"));
    EXPECT_FALSE(m_window->layouts().use("nowhere"));
    EXPECT_THAT(m_window->newest().toStdString(), testing::HasSubstr("nowhere"));
}

}  // namespace
}  // namespace leitstand::test
