#pragma once

#include <vector>

#include <Eigen/Core>

#include "core/base/pose.h"

namespace leitstand {

/// The way that a robot went since its link was good: to find back (link-loss rule "return to the last good
/// link", design section 4).
class LinkTrail {
public:
    /// @p spacing of the places that it remembers [m].
    explicit LinkTrail(double spacing = 0.3) : m_spacing(spacing) {}

    /// Where the robot is; @p linkGood: the trail begins anew here. @p returning: walks back along it.
    void moved(const Pose& baseInOdom, bool linkGood, bool returning);
    /// The place to go to next on the way back, in odom [m]; where the link was good when it is the last.
    [[nodiscard]] Eigen::Vector3d next() const;
    [[nodiscard]] bool isBack() const { return m_places.size() <= 1 && m_atEnd; }

private:
    /// From above: heights drift, and tell storeys only.
    [[nodiscard]] bool isAt(const Eigen::Vector3d& place, const Eigen::Vector3d& here) const;

    double m_spacing;
    std::vector<Eigen::Vector3d> m_places;  ///< in odom; the first is the good one [m]
    bool m_atEnd = false;
};

}  // namespace leitstand
