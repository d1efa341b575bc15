#pragma once

#include <array>
#include <vector>

#include <Eigen/Core>

#include "robots/simulation/world/body.h"

namespace leitstand::simulation {

/// A contact with an obstacle, in base_link's plane.
struct Push {
    Eigen::Vector2d at = Eigen::Vector2d::Zero();       ///< position [m]
    Eigen::Vector2d normal = Eigen::Vector2d::UnitX();  ///< direction out of the obstacle, unit length
    double depth = 0.0;                                 ///< how far the point is inside the obstacle [m]
};

/// What acts on a robot during a step.
struct DriveInput {
    double leftVoltage = 0.0, rightVoltage = 0.0;  ///< share of the full voltage, -1 to 1
    bool brake = false;
    Eigen::Vector2d gravity = Eigen::Vector2d::Zero();        ///< component along base_link's x and y [m/s2]
    double leftLoad = 0.0, rightLoad = 0.0, bellyLoad = 0.0;  ///< forces normal to the ground [N]
    double leftSlip = 0.0, rightSlip = 0.0;                   ///< share of the wheels' speed that is lost
};

/// Speeds of a robot in base_link, and of its wheels.
struct DriveState {
    Eigen::Vector2d linear = Eigen::Vector2d::Zero();  ///< [m/s]
    double turn = 0.0;                                 ///< [rad/s]
    double left = 0.0, right = 0.0;                    ///< speeds of the wheels [m/s]
};

/// Changes a robot's speeds by the forces of its motors, the ground and obstacles. Each constraint gets an
/// impulse within its limit of friction, computed by projected Gauss-Seidel (Catto 2005). A robot at a
/// standstill does not creep.
class DriveTrain {
public:
    explicit DriveTrain(const BodySpec& spec);

    void step(DriveState& state, const DriveInput& input, const std::vector<Push>& pushes, double seconds);
    /// Returns the current of a motor [A] at @p voltage (-1 to 1) and @p speed [m/s].
    [[nodiscard]] double current(double voltage, double speed) const;
    /// Returns whether an obstacle stopped the robot in the last step.
    [[nodiscard]] bool held() const { return m_held; }

private:
    enum Row { LeftGear, RightGear, LeftGround, RightGround, Across, Skid, RowCount };

    MotorSpec m_motor;
    double m_mass, m_inertia, m_track, m_grip, m_skidTorque, m_reach;
    /// Impulses of the last step, from which the next step starts.
    std::array<double, RowCount> m_impulses = {};
    bool m_held = false;
};

}  // namespace leitstand::simulation
