#pragma once

#include <optional>
#include <vector>

#include <Eigen/Core>

namespace leitstand {

/// Bodies that a robot saw while it drove to another one and has not visited yet; the robot goes there next.
/// Places are in odom [m]. Pure.
class PassedHeat {
public:
    struct One {
        Eigen::Vector3d heat = Eigen::Vector3d::Zero();  ///< where it was seen
        Eigen::Vector3d from = Eigen::Vector3d::Zero();  ///< where the robot saw it from
        int pictures = 0;
    };
    /// Notes that a picture taken when the robot was at @p from showed a body's heat at @p heat.
    void see(const Eigen::Vector3d& heat, const Eigen::Vector3d& from);
    /// Returns the body nearest to @p here that was in at least four pictures; bodies on the same storey come
    /// first. Empty: there is none.
    [[nodiscard]] std::optional<One> next(const Eigen::Vector3d& here) const;
    /// Forgets bodies within @p radius of @p place [m], seen from above, on the same storey: the robot has
    /// been there.
    void forget(const Eigen::Vector3d& place, double radius);

private:
    std::vector<One> m_all;
};

}  // namespace leitstand
