#pragma once

#include <chrono>
#include <memory>
#include <vector>

#include <Eigen/Core>

namespace leitstand {

/// A place on a robot's trail.
struct TrailPlace {
    Eigen::Vector3f inMap = Eigen::Vector3f::Zero();  ///< base_link [m]
    bool afterGap = false;                            ///< the path to it from the place before is unknown

    bool operator==(const TrailPlace&) const = default;
};

/// A robot's path through the map, oldest place first; immutable once shared.
using Trail = std::vector<TrailPlace>;
using TrailPtr = std::shared_ptr<const Trail>;

/// Returns whether the path of a robot between two places, @p away [m] from each other, is unknown. On a
/// known path, places are up to @p apart [m] from each other. It is unknown if the robot went a metre farther
/// than that. Half a metre suffices if nothing was received from it for @p notReceived, more than 3 s.
[[nodiscard]] bool isGap(double away, std::chrono::nanoseconds notReceived, double apart = 0.0);

}  // namespace leitstand
