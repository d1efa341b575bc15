#pragma once

#include <vector>

#include <Eigen/Core>

#include "core/base/pose.h"
#include "core/base/time.h"
#include "core/perception/surroundings/virtual_scan_view.h"

namespace leitstand {

/// Obstacles that a robot feels but its scanner does not see: low things that it ran into, and ground that is
/// too steep for it. Each is remembered for five minutes.
class FeltObstacles {
public:
    /// Adds an obstacle at @p inBase [m], felt when the robot was at @p baseInOdom.
    void add(const Eigen::Vector2d& inBase, const Pose& baseInOdom, Time now);
    /// Adds the remembered obstacles to @p view, which was taken at @p baseInOdom.
    void addTo(VirtualScanView& view, const Pose& baseInOdom, Time now);
    [[nodiscard]] std::size_t count() const { return m_all.size(); }

private:
    struct One {
        Eigen::Vector2d where = Eigen::Vector2d::Zero();  ///< place in odom [m]
        Time at{};
    };
    std::vector<One> m_all;  ///< oldest first
};

}  // namespace leitstand
