#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "core/base/pose.h"
#include "core/cloud/scan.h"

namespace leitstand {

/// An estimated value and its standard deviation, in the same unit.
struct Estimated {
    double value = 0.0, deviation = 0.0;
};

/// Estimates by how much all ranges of a scanner are too long, from pairs of its scans that overlap. Ranges
/// that are too long show one surface at two positions if it is seen from two sides. Each pair is registered
/// point to plane, with the error of the ranges as one more unknown. So it yields this error beside the pose
/// of one scan in the other.
class RangeBias {
public:
    /// Adds a pair of scans: @p scan and @p other, with normals, each in its scanner's frame; @p scanInOther:
    /// as registered. Returns false when the pair holds no information: too few points meet, or all from the
    /// same side.
    bool add(const PointCloud& scan, const PointCloud& other, const Pose& scanInOther);

    [[nodiscard]] std::size_t pairs() const { return m_reported.size(); }
    /// Returns by how much ranges are too long [m]; the standard deviation comes from the scatter of the
    /// pairs. Empty: not enough pairs yet.
    [[nodiscard]] std::optional<Estimated> estimate() const;

private:
    std::vector<double> m_reported;  ///< range error by each pair [m]
};

}  // namespace leitstand
