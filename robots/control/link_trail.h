#pragma once

#include <vector>

#include <Eigen/Core>

#include "core/base/pose.h"

namespace leitstand {

/// The way that a robot has driven since its link was good, so that it can drive back
/// (LinkLossRule::ReturnToLink; docs/design.md, "The wire").
class LinkTrail {
public:
    /// @p spacing: distance between remembered places [m].
    explicit LinkTrail(double spacing = 0.3) : m_spacing(spacing) {}

    /// Takes the robot's pose. @p linkGood: the trail begins again here. @p returning: the robot drives back
    /// along the trail.
    void moved(const Pose& baseInOdom, bool linkGood, bool returning);
    /// Returns the next place on the way back, in odom [m]; the last one is where the link was good.
    [[nodiscard]] Eigen::Vector3d next() const;
    [[nodiscard]] bool isBack() const { return m_places.size() <= 1 && m_atEnd; }

private:
    /// Compares places seen from above. Heights drift, so they only distinguish storeys.
    [[nodiscard]] bool isAt(const Eigen::Vector3d& place, const Eigen::Vector3d& here) const;

    double m_spacing;
    std::vector<Eigen::Vector3d> m_places;  ///< in odom [m]; the link was good at the first one
    bool m_atEnd = false;
};

}  // namespace leitstand
