#pragma once

#include <cstdint>
#include <limits>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "core/base/pose.h"
#include "core/base/time.h"
#include "core/cloud/scan.h"

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

/// Whether a key scan counts.
enum class ScanTrust : std::uint8_t {
    Certain,    ///< part of the map, others are registered against it
    Uncertain,  ///< shown, but nothing is built on it until the operator decides
    SetAside,   ///< rejected or rewound: not shown
};

/// Why a scan is uncertain, and remarks on it: bits of ScanPose::doubts.
enum class ScanDoubt : std::uint8_t {
    Overlap = 1 << 0,    ///< too few of its points meet the map
    Residual = 1 << 1,   ///< those that do are too far from it
    Jump = 1 << 2,       ///< it would have moved differently from the odometry
    Certainty = 1 << 3,  ///< it could be shifted or turned in some direction
    Diverged = 1 << 4,   ///< the registration did not converge
    Odometry = 1 << 5,   ///< it is unknown how the robot came there
    Points = 1 << 6,     ///< it has too few points
    Guessed = 1 << 7,    ///< odometry was missing within it; this alone makes no scan uncertain
};

/// Pose of a key scan and how certain it is.
struct ScanPose {
    std::uint64_t scan = 0;  ///< KeyScanSample::id
    Pose scanInMap = Pose::Identity();
    double rms = 0.0;          ///< of paired points [m]
    double inlierRatio = 0.0;  ///< 0 to 1
    double overlap = 0.0;      ///< 0 to 1
    double certainty = 0.0;    ///< 0 to 1
    bool converged = false;
    ScanTrust trust = ScanTrust::Certain;
    std::uint8_t doubts = 0;  ///< bits of ScanDoubt
};

[[nodiscard]] constexpr bool has(std::uint8_t doubts, ScanDoubt doubt) {
    return (doubts & static_cast<std::uint8_t>(doubt)) != 0;
}

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

/// Where another robot was, or may have been, at a moment of a key scan.
struct BodyInScan {
    std::string robot;
    std::vector<Eigen::Vector2d> footprint;  ///< of that robot, its base frame, counter-clockwise [m]
    double height = 0.0;                     ///< of that robot [m]
    Pose baseInScan = Pose::Identity();      ///< in the frame of the scan's points
    double margin = 0.0;                     ///< the robot may be this far from there [m]
    friend bool operator==(const BodyInScan& a, const BodyInScan& b) {
        return a.robot == b.robot && a.footprint == b.footprint && a.height == b.height &&
               a.baseInScan.matrix() == b.baseInScan.matrix() && a.margin == b.margin;
    }
};

/// Other robots among the points of a key scan; they do not belong in the map.
struct BodiesOfScan {
    std::uint64_t scan = 0;          ///< KeyScanSample::id
    std::vector<BodyInScan> bodies;  ///< all known; empty: none after all
};

/// Replaces what was known of these scans before: a robot may be placed long after it was scanned.
struct ScanBodiesSample {
    Time stamp{};  ///< station's clock
    std::string station;
    std::vector<BodiesOfScan> scans;
};

/// Place of a robot in the map that another one's scans made, and how its laser keeps it there.
struct RobotPlaceSample {
    enum class Cause : std::uint8_t {
        Slot,        ///< searched for beside the robot that makes the map
        Operator,    ///< placed by the operator
        Tracked,     ///< tracked since
        FoundAgain,  ///< searched for and found away from its place by odometry
        Seen,        ///< searched for and found where another robot sees something of its size
    };
    Time stamp{};  ///< station's clock
    std::string station;
    std::string robot;
    Cause cause = Cause::Tracked;
    Time measured{};                    ///< robot's clock
    Pose baseInMap = Pose::Identity();  ///< at @ref measured
    Pose odomInMap = Pose::Identity();  ///< from then on, level by its gyros
    double certainty = 0.0;             ///< 0 to 1
    double overlap = 0.0;               ///< share of what it sees that is in the map
    bool certain = false;               ///< false: only its odometry moves it on
    std::string how;                    ///< why, as a code (placement_format.h)
};

}  // namespace leitstand
