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

/// Estimates by how much all ranges of a scanner are too long, from pairs of its scans that overlap. Such
/// ranges show a surface at two positions if it is seen from two sides. Each pair is registered point to
/// plane. The error of the ranges is one more unknown beside the pose of one scan in the other.
class RangeBias {
public:
    /// Adds a pair of scans with normals, each in its scanner's frame. @p scanInOther: pose by registration.
    /// Returns false when the pair shows nothing about the error: too few points meet, or all from the same
    /// side.
    bool add(const PointCloud& scan, const PointCloud& other, const Pose& scanInOther);

    [[nodiscard]] std::size_t pairs() const { return m_reported.size(); }
    /// Returns by how much ranges are too long [m]. Its standard deviation is computed from the scatter of
    /// the pairs. Empty: not enough pairs yet.
    [[nodiscard]] std::optional<Estimated> estimate() const;

private:
    std::vector<double> m_reported;  ///< range error that each pair shows [m]
};

}  // namespace leitstand
