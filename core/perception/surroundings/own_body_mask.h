#pragma once

#include <chrono>
#include <optional>
#include <vector>

#include <Eigen/Core>

#include "core/base/time.h"

namespace leitstand {

/// Directions in which a scanner sees its own robot. A shot close to such a direction may mix the robot's
/// edge with what is behind it. Its point then hangs in the air next to the robot and moves with it.
class OwnBodyMask {
public:
    /// Adds a shot that hit the robot. @p direction: from the scanner, along the axes of base_link.
    void add(const Eigen::Vector3d& direction, Time at);
    /// Whether a shot in @p direction or close to it hit the robot within the last 20 s.
    [[nodiscard]] bool isNear(const Eigen::Vector3d& direction, Time at) const;
    void clear() { m_metAt.clear(); }

private:
    std::vector<std::optional<Time>> m_metAt;  ///< newest hit, by azimuth and elevation
};

}  // namespace leitstand
