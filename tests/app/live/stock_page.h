#pragma once

#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "app/services/station/station_mapping.h"
#include "app/window/layouts/layout_feature.h"
#include "core/mapping/live/robot_in_map.h"
#include "tests/app/live/live_page.h"
#include "tests/support/child_process.h"
#include "tests/support/places.h"

namespace leitstand::test {

/// The live window, in layout Map, on the simulated stock robot "tracked", a process beside it.
class StockPage : public LivePage {
protected:
    /// @p described: the robot as the station opens it.
    explicit StockPage(RobotDescription described = shippedRobot("tracked"))
        : LivePage(Robots::None, {std::move(described)}) {
        m_robot = std::make_unique<ChildProcess>(
            program("leitstand-robot"),
            std::vector<std::string>{"stock", "tracked", "--domain", std::to_string(m_domain.number()),
                                     "--arena", "yellow", "--seed", "7"});
        m_window->layouts().use("map");
    }
    [[nodiscard]] bool isPlaced() const {
        const RobotsInMapPtr robots = station().mapping().robots();
        for (const RobotInMap& place : *robots)
            if (place.robot == "tracked" && place.placed) return true;
        return false;
    }

private:
    std::unique_ptr<ChildProcess> m_robot;
};

}  // namespace leitstand::test
