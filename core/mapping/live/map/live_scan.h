#pragma once

#include <cstdint>

#include <Eigen/Core>

#include "core/base/pose.h"
#include "core/cloud/scan.h"
#include "core/mapping/motion/turn_assembler.h"

namespace leitstand {

/// A scan that ScanCutter makes of slices, and that LiveMapper takes.
struct LiveScan {
    ScanPtr scan;  ///< never null; sensorInOdom is level by the inertial unit if there is one
    Pose sensorInBase = Pose::Identity();
    Eigen::Vector3d up = Eigen::Vector3d::UnitZ();  ///< against gravity, in the scan's frame
    bool levelKnown = false;                        ///< whether an inertial unit or the odometry measures up
    bool levelByUnit = false;                       ///< whether an inertial unit measures up
    bool plane = false;                             ///< of a plane laser: isPlaneScan()
    TurnEnd end = TurnEnd::Turn;
    bool extrapolated = false;  ///< odometry was late: the motion at the end of the scan is guessed
    bool bridged = false;       ///< odometry is missing within the scan
    double guessed = 0.0;       ///< share of its motion that is extrapolated, 0 to 1
    int odometryFrame = 0;  ///< number of the odometry; with another number, sensorInOdom has another origin
    double way = 0.0,
           turn = 0.0;         ///< of the robot since the end of the scan before, in total [m, rad]
    bool motionKnown = false;  ///< whether velocity and yawRate are known
    /// Velocity of the base by odometry, in the base: the mean over the scan [m/s, rad/s].
    Eigen::Vector2d velocity = Eigen::Vector2d::Zero();
    double yawRate = 0.0;
    Eigen::Vector3d began = Eigen::Vector3d::Zero();  ///< TurnAssembler::began()
    int slices = 0;                                   ///< number of its slices

    /// Returns whether the robot's motion within it was not measured; a few guessed points at its end do not
    /// count.
    [[nodiscard]] bool isGuessed() const { return bridged || guessed > 0.5; }
};

}  // namespace leitstand
