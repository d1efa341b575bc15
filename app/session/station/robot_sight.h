#pragma once

#include <mutex>
#include <optional>

#include "app/session/scans/sensor_poses.h"
#include "core/mission/event.h"
#include "core/perception/virtual_scan.h"
#include "core/robot/link_status.h"

namespace leitstand {

/// What is around one robot: its virtual 2D scan out of what it said. Any thread.
class RobotSight {
public:
    explicit RobotSight(const RobotDescription& robot);

    void take(const Event& event);  ///< odometry, transforms, scans of this robot; others are passed by
    /// As seen from where the robot was by its newest odometry; ages run on while nothing comes. Empty before
    /// any odometry. Sectors' ages are on the robot's clock.
    [[nodiscard]] std::optional<VirtualScanView> view() const;

private:
    mutable std::mutex m_mutex;
    SensorPoses m_poses;
    VirtualScan m_scan;
    std::optional<Time> m_newest;    ///< odometry, robot's clock
    SteadyTime m_arrived = {};       ///< of it
    Pose m_base = Pose::Identity();  ///< in odom, then
};

}  // namespace leitstand
