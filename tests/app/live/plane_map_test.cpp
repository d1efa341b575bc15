// A stock robot that has a plane laser only: its map in the window.
#include <algorithm>
#include <filesystem>
#include <memory>
#include <string>

#include <gtest/gtest.h>

#include "app/services/log/live_mission.h"
#include "app/services/station/station_mapping.h"
#include "app/window/commands/command_table.h"
#include "core/cloud/labels.h"
#include "core/mapping/live/map/live_map.h"
#include "tests/app/live/live_page.h"
#include "tests/support/child_process.h"
#include "tests/support/places.h"
#include "widgets/drive/mode_cell.h"

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
    std::unique_ptr<ChildProcess> m_robot;
};

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

}  // namespace
}  // namespace leitstand::test
