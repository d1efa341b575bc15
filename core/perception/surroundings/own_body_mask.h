#pragma once

#include <chrono>
#include <optional>
#include <vector>

#include <Eigen/Core>

#include "core/base/time.h"

namespace leitstand {

/// Directions in which a scanner sees its own robot. A shot beside one that met the robot may mix the robot's
/// edge with what is behind. Its point is in the air before the robot, and moves along with it.
class OwnBodyMask {
public:
    /// @p direction: of the shot that met the robot, from the scanner; in base_link.
    void add(const Eigen::Vector3d& direction, Time at);
    /// Whether the robot was met in that direction or beside it within the last 20 s.
    [[nodiscard]] bool isNear(const Eigen::Vector3d& direction, Time at) const;
    void clear() { m_metAt.clear(); }

private:
    std::vector<std::optional<Time>> m_metAt;  ///< by azimuth and elevation
};

}  // namespace leitstand
