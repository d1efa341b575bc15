#pragma once

#include <vector>

#include <Eigen/Core>

#include "core/base/time.h"
#include "core/perception/surroundings/own_body_mask.h"

namespace leitstand {

/// Obstacles close to a robot, which its scanner no longer sees when they are beside the wheels. An obstacle
/// is remembered for half a minute, or until a raw scan looks through its place, or until the scanner is 2 m
/// away. Of more than a thousand obstacles, only the newest are kept.
class NearObstacles {
public:
    struct One {
        Eigen::Vector2d where = Eigen::Vector2d::Zero();  ///< position in odometry's frame [m]
        double top = 0.0;                                 ///< height of its upper end [m]
        Time at{};
        /// Vector from the scanner to the obstacle when it was seen, along base_link's axes [m]; zero:
        /// forgetMixed() does not check it.
        Eigen::Vector3d shot = Eigen::Vector3d::Zero();
        double bottom = 0.0;  ///< height of its lower end [m]; above 0 for things that hang
        double z = 0.0;       ///< height of the measured point in odometry's frame [m] ...
        double rise = 0.0;    ///< ... and above the robot's ground when it was seen [m]
    };
    void add(const One& one);
    /// Call when a raw scan from @p origin towards @p heading [rad] saw free ground at distances @p from to
    /// @p to [m]. Removes the obstacles there, and those that are too old or too far away.
    void lookThrough(const Eigen::Vector2d& origin, double heading, double from, double to, Time at);
    /// Removes points that may be mixed with edges of the robot, which @p mask has learned since they were
    /// seen. Only points nearer to the scanner than @p within [m] are checked.
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
