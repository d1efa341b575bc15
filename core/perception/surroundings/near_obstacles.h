#pragma once

#include <vector>

#include <Eigen/Core>

#include "core/base/time.h"
#include "core/perception/surroundings/own_body_mask.h"

namespace leitstand {

/// Obstacles close to a robot, which its scanner no longer sees once they are beside its wheels. They stay
/// until a raw scan looks through their place, or for half a minute. Of more than a thousand, the newest
/// stay.
class NearObstacles {
public:
    struct One {
        Eigen::Vector2d where = Eigen::Vector2d::Zero();  ///< odometry's frame [m]
        double top = 0.0;                                 ///< height of its upper end [m]
        Time at{};
        Eigen::Vector3d shot =
            Eigen::Vector3d::Zero();  ///< from the scanner to it at that time; base_link's axes [m]
        double bottom = 0.0;          ///< height of its lower end: more for what hangs [m]
        double z = 0.0;               ///< of the measured point, odometry's frame [m]
        double rise = 0.0;            ///< ... over the robot's ground at that time [m]
    };
    void add(const One& one);
    /// A raw scan from @p origin to @p heading [rad] saw free ground from @p from to @p to [m] away.
    void lookThrough(const Eigen::Vector2d& origin, double heading, double from, double to, Time at);
    /// Forgets points that are mixed with the robot's own edges, which @p mask has learned since.
    void forgetMixed(const OwnBodyMask& mask, double within);
    template <class Is>
    void forgetWhere(Is is) {
        std::erase_if(m_all, is);
    }
    [[nodiscard]] const std::vector<One>& all() const { return m_all; }
    void clear() { m_all.clear(); }

private:
    std::vector<One> m_all;
};

}  // namespace leitstand
