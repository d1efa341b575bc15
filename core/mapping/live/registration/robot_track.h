#pragma once

#include <cstdint>
#include <optional>

#include <Eigen/Core>

#include "core/base/pose.h"
#include "core/base/time.h"
#include "core/mapping/live/registration/scanner_track.h"
#include "core/mapping/live/scan_cleaning.h"
#include "core/mapping/motion/odometry_scale.h"
#include "core/mapping/motion/spinning_wheels.h"

namespace leitstand {

/// What is known of a robot's motion.
struct RobotTrack {
    RobotBody body;
    bool known = false;  ///< whether the pose is known; otherwise the fields below are not valid
    Time stamp{};        ///< end of the newest scan, robot's clock
    Pose sensorInBase = Pose::Identity();
    Pose sensorInMap = Pose::Identity();  ///< pose at the newest scan
    Pose sensorInOdom = Pose::Identity();
    int odometryFrame = -1;        ///< number of its odometry; negative: from an earlier run of the station
    bool odometry = false;         ///< whether sensorInOdom was measured
    bool lost = false;             ///< whether the newest scan did not fit
    bool contradicted = false;     ///< whether a scan contradicted odometry since the last scan that fitted
    bool waited = false;           ///< whether the newest scan was left out, so that the next one enters
    double certainty = 0.0;        ///< RobotFix::certainty
    std::uint8_t doubts = 0;       ///< doubts of the newest scan
    double way = 0.0, turn = 0.0;  ///< how far it drove and turned since the last certain scan [m, rad]
    double openWay = 0.0;          ///< distance driven since surfaces held the robot in all directions [m]
    Eigen::Vector3d moved = Eigen::Vector3d::Zero();  ///< Step::moved
    OdometryScale scale;                              ///< scale of odometry's distances
    SpinningWheels wheels;
    ScannerTrack scanner;
    Pose keyInMap = Pose::Identity();  ///< pose of its newest key scan
    std::uint64_t key = 0;             ///< id of its newest key scan; 0: none
    Pose unspun = Pose::Identity();    ///< LiveKeyScan::unspun at present
    std::optional<Pose> placedInMap;   ///< where the operator placed base_link, for the next scan
    /// Whether it begins a part of the map with its next scan, if its pose is unknown then.
    bool beginsPart = false;
};

}  // namespace leitstand
