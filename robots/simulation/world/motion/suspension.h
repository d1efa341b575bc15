#pragma once

#include <array>
#include <vector>

#include <Eigen/Core>

#include "core/base/pose.h"
#include "robots/simulation/scene/scene.h"
#include "robots/simulation/world/body.h"

namespace leitstand::simulation {

/// How a robot stands.
struct Footing {
    bool supported = false;                                   ///< false: the robot falls
    double leftLoad = 0.0, rightLoad = 0.0, bellyLoad = 0.0;  ///< forces normal to the ground [N]
    bool tips = false;                                        ///< whether nothing holds it upright any more
    std::vector<int> victims;  ///< victims on which it stands, as elements of the arena
};

/// Lets a robot rest on the ground. The contacts of wheels and chains determine height, roll and pitch.
class Suspension {
public:
    explicit Suspension(const BodySpec& spec);

    /// Moves @p pose by one step: the ground lifts it quickly (25 ms); otherwise it falls with gravity.
    Footing step(const Scene& scene, Pose& pose, double seconds);
    /// Lowers @p pose onto the ground at once.
    Footing settle(const Scene& scene, Pose& pose);
    /// Returns whether the last step moved nothing. A robot that stands still then needs no further step.
    [[nodiscard]] bool resting() const { return m_resting; }

private:
    void feel(const Scene& scene, const Pose& pose);
    Footing footingOf(const Pose& pose, double seconds, Pose& next);

    const BodySpec& m_spec;
    std::vector<Eigen::Vector3d> m_under;  ///< points of the underside, contacts first [m]
    /// Ground below each point, relative to base_link's origin; its height minus that of the point [m].
    std::vector<Eigen::Vector3d> m_ground;
    std::vector<int> m_victims;  ///< victim below each point, as an element of the arena; -1: none
    std::vector<Ray> m_rays;
    std::vector<Hit> m_hits;
    std::array<int, 3> m_feet = {0, 1, 2};
    std::array<double, 3> m_falling = {};  ///< downward speed of three places around base_link [m/s]
    bool m_resting = false;
};

/// Returns a pose at @p position with the heading @p yaw [rad], on a plane with the upward normal @p normal.
[[nodiscard]] Pose poseOnPlane(const Eigen::Vector3d& position, double yaw, const Eigen::Vector3d& normal);

}  // namespace leitstand::simulation
