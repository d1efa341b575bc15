#pragma once

#include <cstddef>
#include <vector>

#include "core/cloud/scan.h"

namespace leitstand {

/// Two directions within the surface at each point of an organised scan, as the scanner's grid gives them:
/// vectors of any length, zero where unknown.
struct GridTangents {
    std::vector<Eigen::Vector3f> alongRows;     ///< towards higher columns
    std::vector<Eigen::Vector3f> alongColumns;  ///< towards higher rows

    /// Returns the unit normal of the surface at the @p i-th point, which is at @p point in the sensor's
    /// frame. It points towards the sensor; zero unless both directions are known and span a plane.
    [[nodiscard]] Eigen::Vector3f normal(std::size_t i, const Eigen::Vector3f& point) const;
};

/// Returns the tangents of an organised @p scan, one pair a point; zero where there is too little surface.
/// Each tangent is fitted over at least 10 cm of surface, so that range noise does not decide, and never
/// across depth jumps. @p threads: 0 is one per core; the result does not depend on their number.
[[nodiscard]] GridTangents gridTangents(const Scan& scan, int threads = 1);

}  // namespace leitstand
