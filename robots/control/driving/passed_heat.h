#pragma once

#include <optional>
#include <vector>

#include <Eigen/Core>

namespace leitstand {

/// Bodies that a robot saw while it drove to another body, and has not visited yet. The robot visits them
/// next. Places are in odom [m]. Pure.
class PassedHeat {
public:
    struct One {
        Eigen::Vector3d heat = Eigen::Vector3d::Zero();  ///< where it was seen
        Eigen::Vector3d from = Eigen::Vector3d::Zero();  ///< where the robot was when it saw it
        int pictures = 0;
    };
    /// Takes the place @p heat of a body's heat, from a picture that was taken when the robot was at @p from.
    void see(const Eigen::Vector3d& heat, const Eigen::Vector3d& from);
    /// Returns the body nearest to @p here that was seen in at least four pictures. Bodies on the same storey
    /// come first. Empty: there is none.
    [[nodiscard]] std::optional<One> next(const Eigen::Vector3d& here) const;
    /// Forgets bodies on the same storey within @p radius of @p place [m], seen from above, because the robot
    /// has been there.
    void forget(const Eigen::Vector3d& place, double radius);

private:
    std::vector<One> m_all;
};

}  // namespace leitstand
