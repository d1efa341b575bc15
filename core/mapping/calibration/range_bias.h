#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "core/base/pose.h"
#include "core/cloud/scan.h"

namespace leitstand {

/// A value that was estimated, and how far it may be off (one deviation).
struct Estimated {
    double value = 0.0, deviation = 0.0;
};

/// Estimates by how much all ranges of a scanner are too long, from pairs of its scans that overlap. A
/// surface seen from two places then lies too far off in two directions. Each pair yields the pose of one
/// scan in the other. It also yields how much nearer to their scanners the points of both must be for their
/// surfaces to meet (point to plane, with one more unknown).
class RangeBias {
public:
    /// Adds a pair of scans: @p scan and @p other, with normals, each in its scanner's frame; @p scanInOther:
    /// as registered. Returns false when the pair holds no information: too few points meet, or all from the
    /// same side.
    bool add(const PointCloud& scan, const PointCloud& other, const Pose& scanInOther);

    [[nodiscard]] std::size_t pairs() const { return m_reported.size(); }
    /// Returns by how much ranges are too long [m], with the deviation by the scatter of the pairs. Empty
    /// before there are enough pairs.
    [[nodiscard]] std::optional<Estimated> estimate() const;

private:
    std::vector<double> m_reported;  ///< bias by each pair [m]
};

}  // namespace leitstand
