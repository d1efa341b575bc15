#pragma once

#include <string>
#include <vector>

#include <Eigen/Core>

#include "core/base/pose.h"
#include "robots/simulation/arena/mesh.h"

namespace leitstand::simulation {

/// Motor and gear of one side of a robot. The force falls from stall to 0 at full speed.
struct MotorSpec {
    double stallForce = 60.0;    ///< at the ground, at full voltage [N]
    double fullSpeed = 0.7;      ///< without load [m/s]
    double stallCurrent = 12.0;  ///< [A]
    double inertia = 4.0;        ///< of motor and gear, as felt at the ground [kg]
    double friction = 4.0;       ///< of the gear: holds against smaller forces, also unpowered [N]
};

/// Slip of skid steering: the share of the encoders' speed that is missing at the ground.
struct SlipSpec {
    double mean = 0.03, deviation = 0.02;  ///< share of the speed, drawn again every half second
    double onRamps = 0.10;                 ///< additional share per unit of slope (tan), uphill
    double turning = 0.25;                 ///< share of the turn rate: wheels are dragged sideways
};

/// Body of a robot. Frame: base_link, x forward, z up, its origin on the ground between the wheels.
struct BodySpec {
    std::string name;                                 ///< "kurt3d"
    double mass = 25.0;                               ///< [kg]
    Eigen::Vector3d centreOfMass = {0.0, 0.0, 0.15};  ///< [m]
    double trackWidth = 0.4;                          ///< between the middles of left and right wheels [m]
    double wheelRadius = 0.08;                        ///< or of the chains' ends [m]
    /// Points all over the underside of wheels or chains, round ends too [m]. The left motor drives those
    /// left of the middle (y > 0).
    std::vector<Eigen::Vector3d> contacts;
    std::vector<Eigen::Vector3d> belly;    ///< points that carry and do not drive [m]
    std::vector<Eigen::Vector2d> outline;  ///< counter-clockwise; what bumps into obstacles [m]
    double bumpFrom = 0.03, bumpTo = 0.5;  ///< heights between which the outline bumps [m]
    double maxClimb = 0.05;                ///< highest step that it climbs [m]
    double maxTilt = 0.96;                 ///< beyond this it falls over, whatever carries it [rad]
    double grip = 0.9;                     ///< friction of wheels or chains on the ground
    double skidTorque = 8.0;               ///< torque to turn on the spot on flat ground [Nm]
    MotorSpec motor;                       ///< of each side
    SlipSpec slip;
    Mesh shape;  ///< as others see it
};

/// Kurt3D: six wheels of 16 cm, two motors of 90 W, 0.6 m/s (paper, section 2; 45 x 33 cm, 0.56 m high with
/// the scanner). The scanner's head is a cylinder of 0.09 m radius about (0, 0, 0.48); its own rays start
/// inside.
[[nodiscard]] BodySpec kurt3dBody();
/// The Crawler: 40 x 26 cm, 7 kg, two chains, motors of 60 W (paper, section 3). Its laser stands on a box of
/// 5 cm below (0.14, 0, 0.195). The mirror of its omnidirectional camera is above (0, 0, 0.35).
[[nodiscard]] BodySpec crawlerBody();

}  // namespace leitstand::simulation
