#pragma once

#include <string>
#include <vector>

#include <Eigen/Core>

#include "core/base/pose.h"
#include "robots/simulation/arena/mesh.h"

namespace leitstand::simulation {

/// Motor and gear of one side of a robot. The force decreases from stall to 0 at full speed.
struct MotorSpec {
    double stallForce = 60.0;    ///< force on the ground at full voltage [N]
    double fullSpeed = 0.7;      ///< speed without load [m/s]
    double stallCurrent = 12.0;  ///< [A]
    double inertia = 4.0;        ///< inertia of motor and gear, as an equivalent mass on the ground [kg]
    double friction = 4.0;  ///< friction of the gear: holds against smaller forces, even without power [N]
};

/// Slip of skid steering: by which share the speed on the ground is less than that of the encoders.
struct SlipSpec {
    double mean = 0.03, deviation = 0.02;  ///< share of the speed; a new value is drawn every half second
    double onRamps = 0.10;                 ///< additional share uphill, per unit of slope (tan)
    double turning = 0.25;                 ///< share of the turn rate, since wheels are dragged sideways
};

/// Body of a robot. Frame: base_link, x forward, z up, its origin on the ground between the wheels.
struct BodySpec {
    std::string name;                                 ///< "kurt3d"
    double mass = 25.0;                               ///< [kg]
    Eigen::Vector3d centreOfMass = {0.0, 0.0, 0.15};  ///< [m]
    double trackWidth = 0.4;    ///< distance between the middles of left and right wheels [m]
    double wheelRadius = 0.08;  ///< radius of the wheels, or of the chains' ends [m]
    /// Points all over the underside of wheels or chains, including round ends [m]. The left motor drives
    /// those with y > 0.
    std::vector<Eigen::Vector3d> contacts;
    std::vector<Eigen::Vector3d> belly;    ///< points that carry weight but do not drive [m]
    std::vector<Eigen::Vector2d> outline;  ///< outline that hits obstacles, counter-clockwise [m]
    double bumpFrom = 0.03, bumpTo = 0.5;  ///< range of heights in which the outline hits obstacles [m]
    double maxClimb = 0.05;                ///< highest step that it climbs [m]
    double maxTilt = 0.96;    ///< with more tilt than this it falls over, whatever supports it [rad]
    double grip = 0.9;        ///< friction of wheels or chains on the ground
    double skidTorque = 8.0;  ///< torque to turn on the spot on flat ground [Nm]
    MotorSpec motor;          ///< motor of each side
    SlipSpec slip;
    Mesh shape;  ///< shape as other robots' sensors see it
};

/// Kurt3D: six wheels of 16 cm, two motors of 90 W, 0.6 m/s (paper, section 2; 45 x 33 cm, 0.56 m high with
/// the scanner). The scanner's head is a cylinder with a radius of 0.09 m around (0, 0, 0.48); its own rays
/// start inside.
[[nodiscard]] BodySpec kurt3dBody();
/// The Crawler: 40 x 26 cm, 7 kg, two chains, motors of 60 W (paper, section 3). Its laser is on a box of 5
/// cm below (0.14, 0, 0.195). The mirror of its omnidirectional camera is above (0, 0, 0.35).
[[nodiscard]] BodySpec crawlerBody();

}  // namespace leitstand::simulation
