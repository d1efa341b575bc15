#pragma once

#include <cstdint>

#include <Eigen/Core>

#include "core/base/pose.h"
#include "core/cloud/scan.h"
#include "core/mapping/motion/turn_assembler.h"

namespace leitstand {

/// A scan made from slices by ScanCutter, for LiveMapper.
struct LiveScan {
    ScanPtr scan;  ///< never null; sensorInOdom is levelled by the inertial unit if there is one
    Pose sensorInBase = Pose::Identity();
    Eigen::Vector3d up = Eigen::Vector3d::UnitZ();  ///< upward direction in the scan's frame
    bool levelKnown = false;   ///< whether the inertial unit or the odometry measures `up`
    bool levelByUnit = false;  ///< whether the inertial unit measures `up`
    bool plane = false;        ///< whether it is of a plane laser: isPlaneScan()
    TurnEnd end = TurnEnd::Turn;
    bool extrapolated = false;  ///< whether odometry was late: the motion at the end of the scan is guessed
    bool bridged = false;       ///< whether odometry is missing within the scan
    double guessed = 0.0;       ///< share of the scan's motion that is extrapolated, 0 to 1
    int odometryFrame = 0;      ///< number of the odometry; sensorInOdom of another number has another origin
    double way = 0.0,
           turn = 0.0;  ///< how far the robot drove and turned since the end of the previous scan [m, rad]
    bool motionKnown = false;  ///< whether velocity and yawRate are known
    /// Mean velocity of the base during the scan, by odometry, in the base's frame [m/s, rad/s].
    Eigen::Vector2d velocity = Eigen::Vector2d::Zero();
    double yawRate = 0.0;
    Eigen::Vector3d began = Eigen::Vector3d::Zero();  ///< TurnAssembler::began()
    int slices = 0;                                   ///< number of slices in the scan

    /// Returns whether the robot's motion during the scan was not measured. A few guessed points at the end
    /// do not matter.
    [[nodiscard]] bool isGuessed() const { return bridged || guessed > 0.5; }
};

}  // namespace leitstand
