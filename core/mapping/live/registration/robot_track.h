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
    bool known = false;  ///< whether its pose is known; else the fields below are not valid
    Time stamp{};        ///< end of the newest scan, robot's clock
    Pose sensorInBase = Pose::Identity();
    Pose sensorInMap = Pose::Identity();  ///< at the newest scan
    Pose sensorInOdom = Pose::Identity();
    int odometryFrame = -1;        ///< number of its odometry; negative: of an earlier run of the station
    bool odometry = false;         ///< whether sensorInOdom was measured
    bool lost = false;             ///< the newest scan did not fit
    bool contradicted = false;     ///< since the last scan that fitted, one contradicted odometry
    bool waited = false;           ///< the newest scan was left out, to let the next one enter
    double certainty = 0.0;        ///< RobotFix::certainty
    std::uint8_t doubts = 0;       ///< of the newest scan
    double way = 0.0, turn = 0.0;  ///< since the last certain scan [m, rad]
    double openWay = 0.0;          ///< since surfaces held it in all directions [m]
    Eigen::Vector3d moved = Eigen::Vector3d::Zero();  ///< Step::moved
    OdometryScale scale;                              ///< of odometry's distances
    SpinningWheels wheels;
    ScannerTrack scanner;
    Pose keyInMap = Pose::Identity();  ///< newest key scan
    std::uint64_t key = 0;             ///< id of its newest key scan; 0: none
    Pose unspun = Pose::Identity();    ///< LiveKeyScan::unspun at present
    std::optional<Pose> placedInMap;   ///< where the operator put base_link, for the next scan
    bool beginsPart = false;  ///< begins a part of the map with its next scan, unless its pose is known
};

}  // namespace leitstand
