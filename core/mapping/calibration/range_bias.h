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

/// By how much all ranges of a scanner are too long, from pairs of its scans that overlap: a surface that it
/// saw from two places lies twice too far off, in two directions. Each pair tells, beside the pose of one
/// scan in the other, how much nearer to their scanners the points of both have to be for their surfaces to
/// meet (point to plane, with one unknown more).
class RangeBias {
public:
    /// @p scan and @p other, with normals, each in its scanner's frame; @p scanInOther: as registered. False
    /// where they say nothing: too few points meet, or all from the same side.
    bool add(const PointCloud& scan, const PointCloud& other, const Pose& scanInOther);

    [[nodiscard]] std::size_t pairs() const { return m_told.size(); }
    /// Too long by so much [m]; empty before enough pairs told. The deviation is of their scatter.
    [[nodiscard]] std::optional<Estimated> estimate() const;

private:
    std::vector<double> m_told;  ///< by each pair [m]
};

}  // namespace leitstand
