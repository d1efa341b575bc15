#pragma once

#include <cstdint>
#include <limits>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "core/base/pose.h"
#include "core/base/time.h"
#include "core/cloud/scan.h"
#include "core/event/scan_pose.h"

namespace leitstand {

/// A scan that entered the map, labelled and reduced, with its first pose.
struct KeyScanSample {
    Time stamp{};                          ///< station's clock
    std::uint64_t id = 0;                  ///< of the scan within the mission, from 1
    ScanPtr scan;                          ///< never null
    Pose sensorInBase = Pose::Identity();  ///< at the end of the sweep
    Pose scanInMap = Pose::Identity();     ///< when it entered the map; ScanPosesSample corrects it
    std::uint64_t matched = 0;             ///< id of the scan it was registered against; 0: none
};

/// Poses that a registration or a correction changed, all at once; also the operator's decisions on them.
struct ScanPosesSample {
    enum class Cause : std::uint8_t { Registration, LoopClosure, Operator };
    Time stamp{};  ///< station's clock
    std::string station;
    Cause cause = Cause::Registration;
    std::vector<ScanPose> poses;
};

/// The part of the world that belongs in the map from now on: the operator's decision.
struct MapCropSample {
    Time stamp{};  ///< station's clock
    std::string station;
    std::vector<Eigen::Vector2d> polygon;                      ///< corners, map frame [m]; empty: everything
    double ceiling = std::numeric_limits<double>::infinity();  ///< points above are left out, map frame [m]
};

/// Pose of a robot in the map that another robot's scans made, and how well its own laser confirms it.
struct RobotPlaceSample {
    enum class Cause : std::uint8_t {
        Slot,        ///< searched for beside the robot that makes the map
        Operator,    ///< placed by the operator
        Tracked,     ///< tracked since
        FoundAgain,  ///< searched for and found away from where odometry put it
        Seen,        ///< searched for and found where another robot sees something of its size
    };
    Time stamp{};  ///< station's clock
    std::string station;
    std::string robot;
    Cause cause = Cause::Tracked;
    Time measured{};                    ///< robot's clock
    Pose baseInMap = Pose::Identity();  ///< at @ref measured
    Pose odomInMap = Pose::Identity();  ///< odometry's frame from @ref measured on, levelled by the gyros
    double certainty = 0.0;             ///< 0 to 1
    double overlap = 0.0;               ///< share of what the robot sees that is in the map
    bool certain = false;               ///< false: from here, only odometry moves the robot on
    std::string how;                    ///< why it is certain or not, as a code (placement_format.h)
};

}  // namespace leitstand
