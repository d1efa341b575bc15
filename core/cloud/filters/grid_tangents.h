#pragma once

#include <cstddef>
#include <vector>

#include "core/cloud/scan.h"

namespace leitstand {

/// Two directions within the surface at each point of an organised scan, computed from the scanner's grid.
/// They are vectors of any length; zero: unknown.
struct GridTangents {
    std::vector<Eigen::Vector3f> alongRows;     ///< towards higher columns
    std::vector<Eigen::Vector3f> alongColumns;  ///< towards higher rows

    /// Returns the unit normal of the surface at point number @p i, which is at @p point in the sensor's
    /// frame. It points towards the sensor. Zero unless both directions are known and span a plane.
    [[nodiscard]] Eigen::Vector3f normal(std::size_t i, const Eigen::Vector3f& point) const;
};

/// Returns the tangents of an organised @p scan, one pair per point; zero where there is too little surface.
/// Each tangent is fitted over at least 10 cm of surface, so that noise of ranges has little effect, and
/// never across depth jumps. @p threads: 0 means one per core; the result does not depend on it.
[[nodiscard]] GridTangents gridTangents(const Scan& scan, int threads = 1);

}  // namespace leitstand
