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

/// Returns whether the path between two places of a robot is unknown; they are @p away from each other [m].
/// Either nothing was received from it for @p notReceived, 3 s and more, and it is half a metre away then. Or
/// it jumped by a metre. @p apart: distance between places of a known path [m].
[[nodiscard]] bool isGap(double away, std::chrono::nanoseconds notReceived, double apart = 0.0);

}  // namespace leitstand
