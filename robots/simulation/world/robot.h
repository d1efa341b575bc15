#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "robots/simulation/scene/scene.h"
#include "robots/simulation/world/body.h"
#include "robots/simulation/world/bump_counter.h"
#include "robots/simulation/world/motion/drive_train.h"
#include "robots/simulation/world/motion/feelers.h"
#include "robots/simulation/world/motion/suspension.h"
#include "robots/simulation/world/normal_draws.h"
#include "robots/simulation/world/pose_history.h"
#include "robots/simulation/world/world.h"

namespace leitstand::simulation {

/// A robot that drives in a scene, with the state that it keeps from one step to the next.
class Robot {
public:
    Robot(const BodySpec& spec, int body, std::uint64_t seed, const Pose& baseInArena);
    Robot(const Robot&) = delete;
    Robot& operator=(const Robot&) = delete;

    void setMotors(double left, double right);
    void setBrake(bool on) { m_brake = on; }
    void settle(const Scene& scene);  ///< lowers it onto the ground
    /// What a step needs to know about the world.
    struct Surroundings {
        const Scene& scene;
        std::span<const std::string> names;  ///< names of the scene's bodies
        Time now;
        bool othersNear = false;  ///< whether other robots may have come closer
    };
    /// Moves the robot for @p seconds. Returns new bumps.
    std::vector<Bump> step(const Surroundings& around, double seconds);
    void moveTo(const Pose& baseInArena, Time now);  ///< sets the pose of a ghost
    void remember(Time now) { m_history.add(now, m_state.baseInArena); }

    [[nodiscard]] const BodyState& state() const { return m_state; }
    [[nodiscard]] const BodySpec& spec() const { return m_spec; }
    [[nodiscard]] const PoseHistory& history() const { return m_history; }
    [[nodiscard]] bool moved() const { return m_moved; }  ///< whether it moved in the last step

private:
    void drawSlip(double seconds);
    void drive(double seconds);
    void stand(const Scene& scene, double seconds);
    void topple(double seconds);
    std::vector<Bump> lookForBumps(const Surroundings& around, double seconds);
    [[nodiscard]] double slipOf(double drawn, double speed) const;

    const BodySpec m_spec;
    const int m_body;
    NormalDraws m_draws;
    Suspension m_suspension;
    DriveTrain m_driveTrain;
    Feelers m_feelers;
    BumpCounter m_bumpCounter;
    PoseHistory m_history;

    BodyState m_state;
    DriveState m_speeds;
    Footing m_footing;
    std::vector<Push> m_pushes;
    double m_left = 0.0, m_right = 0.0;  ///< voltages
    bool m_brake = false;
    double m_leftSlip = 0.0, m_rightSlip = 0.0,
           m_slipFor = 0.0;  ///< present slips; time until new ones are drawn [s]
    /// Time since feelers were cast [s]; distance that is still free [m].
    double m_feltAgo = 1.0, m_freeWay = 0.0;
    struct Topple {
        Eigen::Vector3d pivot, axis;
        double speed = 0.3;  ///< [rad/s]
    };
    std::optional<Topple> m_topple;
    bool m_moved = true;
};

}  // namespace leitstand::simulation
