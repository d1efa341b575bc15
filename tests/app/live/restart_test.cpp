#include <chrono>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "app/session/station/station_clock.h"
#include "app/window/live/layouts/layout_feature.h"
#include "app/window/live/pane_docks.h"
#include "core/mission/mission_state.h"
#include "tests/app/live/live_page.h"

namespace leitstand::test {
namespace {

using LiveRestart = LivePage;

TEST_F(LiveRestart, MapRobotsGrantAndClockAreBackInTenSeconds) {
    ASSERT_TRUE(soon([&] { return m_window->missing().isEmpty(); })) << m_window->missing().toStdString();
    ASSERT_TRUE(station().clock().limit(std::chrono::minutes(20)).ok());
    m_window->setDriving(true);
    ASSERT_TRUE(soon([&] { return robot().grant.mine; }));
    const auto scans = [&] { return station().mission()->keyScans->size(); };
    const std::size_t before = scans();
    const auto elapsed = station().clock().now().elapsed;
    ASSERT_GT(elapsed.count(), 0);

    const auto began = std::chrono::steady_clock::now();
    restart();
    ASSERT_TRUE(soon([&] { return m_window->missing().isEmpty() && robot().grant.mine; }))
        << m_window->missing().toStdString();
    const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - began).count();
    RecordProperty("seconds", std::to_string(seconds));
    std::printf("all is back after %.1f s\n", seconds);
    EXPECT_LT(seconds, 10.0);
    EXPECT_GE(scans(), before);
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
