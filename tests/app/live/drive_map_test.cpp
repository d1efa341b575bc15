#include <cmath>

#include <QLineF>

#include <gtest/gtest.h>

#include "app/services/station/station_mapping.h"
#include "app/window/input/selection.h"
#include "app/window/layouts/layout_feature.h"
#include "tests/app/live/live_page.h"
#include "widgets/map_view/map_view.h"

namespace leitstand::test {
namespace {

/// The map of layout Drive, with real robot processes.
class LiveDriveMap : public LivePage {
protected:
    [[nodiscard]] RobotInMap place(const std::string& name) const {
        const RobotsInMapPtr robots = station().mapping().robots();
        for (const RobotInMap& one : *robots) {
            if (one.robot == name) return one;
        }
        return {};
    }
    /// Whether the robot is on screen, and what is before it straight above it there.
    [[nodiscard]] bool isHeadingUp(const std::string& name) const {
        const MapView& map = m_window->mapView();
        const Pose base = place(name).baseInMap;
        const auto here = map.project(base.translation()),
                   ahead = map.project(base * Eigen::Vector3d(0.8, 0, 0));
        if (!here || !ahead || !map.rect().contains(here->toPoint())) return false;
        const QLineF way(*here, *ahead);
        return way.length() > 10 && std::abs(std::remainder(way.angle() - 90.0, 360.0)) < 8.0;
    }
};

TEST_F(LiveDriveMap, IsTurnedAsTheSelectedRobot) {
    ASSERT_EQ(m_window->layouts().current().name, "drive");
    EXPECT_EQ(m_window->mapView().settings().look, MapLook::Top);
    EXPECT_EQ(m_window->mapView().settings().follow, MapFollow::Above);
    for (const char* name : {"kurt3d", "crawler"}) {
        ASSERT_TRUE(soon([&] { return place(name).placed; })) << name << " is not in the map";
        m_window->selection().select(QLatin1String(name));
        EXPECT_TRUE(soon([&] { return isHeadingUp(name); })) << name;
    }
    m_window->layouts().use("explore");
    EXPECT_EQ(m_window->mapView().settings().look, MapLook::Points);
    EXPECT_EQ(m_window->mapView().settings().follow, MapFollow::Free);
}

}  // namespace
}  // namespace leitstand::test
