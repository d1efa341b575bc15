#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "core/base/pose.h"
#include "core/base/time.h"
#include "core/scan/scan.h"

namespace leitstand {

/// A scan that entered the map: labelled and reduced, with where it was put at first.
struct KeyScanSample {
    Time stamp{};                          ///< station's clock
    std::uint64_t id = 0;                  ///< of the scan within the mission, from 1
    ScanPtr scan;                          ///< never null
    Pose sensorInBase = Pose::Identity();  ///< at the end of the sweep
    Pose scanInMap = Pose::Identity();     ///< when it entered; ScanPosesSample corrects it
    std::uint64_t matched = 0;             ///< id of the scan it was registered against; 0: none
};

/// Where a key scan is, and how sure that is.
struct ScanPose {
    std::uint64_t scan = 0;  ///< KeyScanSample::id
    Pose scanInMap = Pose::Identity();
    double rms = 0.0;          ///< of paired points [m]
    double inlierRatio = 0.0;  ///< 0 to 1
    double overlap = 0.0;      ///< 0 to 1
    double certainty = 0.0;    ///< 0 to 1
    bool converged = false;
};

/// Poses that a registration or a correction changed, all at once.
struct ScanPosesSample {
    enum class Cause : std::uint8_t { Registration, LoopClosure, Operator };
    Time stamp{};  ///< station's clock
    std::string station;
    Cause cause = Cause::Registration;
    std::vector<ScanPose> poses;
};

}  // namespace leitstand
