#pragma once

#include <chrono>
#include <memory>
#include <vector>

#include <Eigen/Core>

namespace leitstand {

/// A place on a robot's trail.
struct TrailPlace {
    Eigen::Vector3f inMap = Eigen::Vector3f::Zero();  ///< base_link [m]
    bool afterGap = false;                            ///< whether the path from the previous place is unknown

    bool operator==(const TrailPlace&) const = default;
};

/// A robot's path through the map, oldest place first; immutable once shared.
using Trail = std::vector<TrailPlace>;
using TrailPtr = std::shared_ptr<const Trail>;

/// Returns whether the path between two consecutive places of a trail is unknown. @p away: distance between
/// them [m]. @p apart: largest usual distance [m]. The path is unknown if the robot moved a metre farther
/// than that. Half a metre is enough if nothing was received from it for @p notReceived, if that is over 3 s.
[[nodiscard]] bool isGap(double away, std::chrono::nanoseconds notReceived, double apart = 0.0);

}  // namespace leitstand
