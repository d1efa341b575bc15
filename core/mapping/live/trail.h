#pragma once

#include <chrono>
#include <memory>
#include <vector>

#include <Eigen/Core>

namespace leitstand {

/// A place where a robot was.
struct TrailPlace {
    Eigen::Vector3f inMap = Eigen::Vector3f::Zero();  ///< base_link [m]
    bool afterGap = false;                            ///< nobody knows the way to it from the place before

    bool operator==(const TrailPlace&) const = default;
};

/// A robot's way through the map, oldest place first; immutable once shared.
using Trail = std::vector<TrailPlace>;
using TrailPtr = std::shared_ptr<const Trail>;

/// Whether nobody knows the way between two places of a robot that are @p away from each other [m]: nothing
/// was heard of it for @p unheard, 3 s and more, and it is half a metre away then; or it jumped by a metre.
/// @p apart: so far from each other are places of a way that is known [m].
[[nodiscard]] bool isGap(double away, std::chrono::nanoseconds unheard, double apart = 0.0);

}  // namespace leitstand
