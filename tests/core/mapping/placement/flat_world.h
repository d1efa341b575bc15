#pragma once

#include <vector>

#include <Eigen/Core>

#include "core/event/cloud_sample.h"
#include "core/mapping/live/map/local_map.h"
#include "core/mapping/motion/motion_buffer.h"
#include "core/mapping/placement/laser_view.h"

namespace leitstand::test {

/// Walls on a level floor, as a map and as a laser sees them.
class FlatWorld {
public:
    struct Wall {
        Eigen::Vector2d from, to;  ///< [m]
    };
    explicit FlatWorld(std::vector<Wall> walls) : m_walls(std::move(walls)) {}
    /// A cell of a maze with a nook: 3 m by 2.4 m.
    [[nodiscard]] static FlatWorld nook();
    /// Two walls 2 m apart without an end in sight.
    [[nodiscard]] static FlatWorld corridor();

    /// Walls 1 m high and the floor at z = -0.5, as thinned clouds have them.
    [[nodiscard]] LocalMap map() const;
    /// A turn of a laser at 0.2 m over the floor: 240 degrees, 4 m, noise of 1 cm; from @p baseInMap on,
    /// while the robot turns at @p turning [rad/s].
    [[nodiscard]] RangesSample ranges(const Pose& baseInMap, Time stamp, double turning = 0.0) const;
    /// base_link on the floor.
    [[nodiscard]] static Pose at(double x, double y, double heading);
    [[nodiscard]] static Pose laserInBase() { return poseFrom({0.14, 0, 0.2}, 0, 0, 0); }
    [[nodiscard]] LaserView view(const Pose& baseInMap, Time stamp = Time(std::chrono::seconds(1000))) const;

private:
    std::vector<Wall> m_walls;
};

}  // namespace leitstand::test
