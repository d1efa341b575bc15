#pragma once

#include <cstdint>

#include <Eigen/Core>

#include "core/base/pose.h"
#include "core/cloud/scan.h"
#include "core/mapping/motion/turn_assembler.h"

namespace leitstand {

/// What ScanCutter makes of slices, and what LiveMapper takes.
struct LiveScan {
    ScanPtr scan;  ///< never null; sensorInOdom is level by the inertial unit where there is one
    Pose sensorInBase = Pose::Identity();
    Eigen::Vector3d up = Eigen::Vector3d::UnitZ();  ///< against gravity, in the scan's frame
    bool levelKnown = false;                        ///< whether an inertial unit or the odometry tells up
    bool levelByUnit = false;                       ///< an inertial unit does
    TurnEnd end = TurnEnd::Turn;
    bool extrapolated = false;  ///< odometry was not there in time: the end of the scan's motion is guessed
    bool bridged = false;       ///< odometry is missing within the scan
    double guessed = 0.0;       ///< share of its motion that is extrapolated, 0 to 1
    int odometryFrame = 0;      ///< sensorInOdom of scans of another number has another origin
    double way = 0.0, turn = 0.0;  ///< of the robot since the end of the scan before, to and fro [m, rad]
    bool motionKnown = false;      ///< whether the following is
    /// Of the base, by odometry, in the base: the mean over the scan [m/s, rad/s].
    Eigen::Vector2d velocity = Eigen::Vector2d::Zero();
    double yawRate = 0.0;
    Eigen::Vector3d began = Eigen::Vector3d::Zero();  ///< TurnAssembler::began()
    int slices = 0;                                   ///< that it is made of

    /// Nobody measured how the robot moved within it; a few guessed points at its end do not count.
    [[nodiscard]] bool isGuessed() const { return bridged || guessed > 0.5; }
};

}  // namespace leitstand
