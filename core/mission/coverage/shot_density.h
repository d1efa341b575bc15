#pragma once

#include <array>

#include <Eigen/Core>

#include "core/cloud/scan.h"

namespace leitstand {

/// The density of a scan's points by direction from its scanner, in bins of 5 degrees.
class ShotDensity {
public:
    [[nodiscard]] static ShotDensity of(const Scan& scan);

    /// Returns points per steradian around @p direction (scan's frame; any length).
    [[nodiscard]] double about(const Eigen::Vector3d& direction) const;

private:
    static constexpr int Around = 72, Rings = 36;
    static int columnOf(const Eigen::Vector3d& direction);
    static int ringOf(const Eigen::Vector3d& direction);

    /// Mean over each bin and its neighbours [1/sr].
    std::array<float, static_cast<std::size_t>(Around* Rings)> m_densities = {};
};

}  // namespace leitstand
