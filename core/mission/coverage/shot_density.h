#pragma once

#include <array>

#include <Eigen/Core>

#include "core/cloud/scan.h"

namespace leitstand {

/// How densely the points of a scan lie in each direction about its scanner: by bins of 5 degrees.
class ShotDensity {
public:
    [[nodiscard]] static ShotDensity of(const Scan& scan);

    /// Points for each steradian about @p direction (scan's frame, of any length).
    [[nodiscard]] double about(const Eigen::Vector3d& direction) const;

private:
    static constexpr int Around = 72, Rings = 36;
    static int columnOf(const Eigen::Vector3d& direction);
    static int ringOf(const Eigen::Vector3d& direction);

    /// About the middle of each bin: that one and its neighbours [1/sr].
    std::array<float, static_cast<std::size_t>(Around* Rings)> m_densities = {};
};

}  // namespace leitstand
