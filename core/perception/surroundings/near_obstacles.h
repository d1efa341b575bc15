#pragma once

#include <vector>

#include <Eigen/Core>

#include "core/base/time.h"
#include "core/perception/surroundings/own_body_mask.h"

namespace leitstand {

/// Obstacles close to a robot. Its scanner no longer sees them once they are beside the wheels. They stay
/// until a raw scan looks through their place, for half a minute, or until the scanner is 2 m away. Of more
/// than a thousand, the newest stay.
class NearObstacles {
public:
    struct One {
        Eigen::Vector2d where = Eigen::Vector2d::Zero();  ///< odometry's frame [m]
        double top = 0.0;                                 ///< height of its upper end [m]
        Time at{};
        Eigen::Vector3d shot =
            Eigen::Vector3d::Zero();  ///< from the scanner to the obstacle at that time, base_link's axes
                                      ///< [m]; zero: not checked by forgetMixed()
        double bottom = 0.0;          ///< height of its lower end, above 0 for what hangs [m]
        double z = 0.0;               ///< height of the measured point in odometry's frame [m]
        double rise = 0.0;            ///< ... and over the robot's ground at that time [m]
    };
    void add(const One& one);
    /// Call when a raw scan from @p origin towards @p heading [rad] saw free ground from @p from to @p to [m]
    /// away. Drops the obstacles there, and those that are too old or too far away.
    void lookThrough(const Eigen::Vector2d& origin, double heading, double from, double to, Time at);
    /// Drops points that may be mixed with the robot's own edges, which @p mask has learned since: those
    /// nearer to the scanner than @p within [m].
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
