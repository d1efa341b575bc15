#pragma once

#include <optional>
#include <vector>

#include <Eigen/Core>

namespace leitstand {

/// Bodies that a robot saw while it drove to another one, and has not been to: where it goes next. Places are
/// in odom [m]. Pure.
class PassedHeat {
public:
    struct One {
        Eigen::Vector3d heat = Eigen::Vector3d::Zero();  ///< as it was seen ...
        Eigen::Vector3d from = Eigen::Vector3d::Zero();  ///< ... by the robot from there
        int pictures = 0;
    };
    /// A picture that was taken when the robot was at @p from showed a body's heat at @p heat.
    void see(const Eigen::Vector3d& heat, const Eigen::Vector3d& from);
    /// The nearest to @p here that was in enough pictures, of the same storey first; empty: there is none.
    [[nodiscard]] std::optional<One> next(const Eigen::Vector3d& here) const;
    /// It has been to what is within @p radius of @p place [m], from above, on its storey.
    void forget(const Eigen::Vector3d& place, double radius);

private:
    std::vector<One> m_all;
};

}  // namespace leitstand
