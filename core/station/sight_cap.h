#pragma once

#include <cstdint>
#include <limits>

#include "core/perception/pictures/picture_watch.h"
#include "core/perception/surroundings/virtual_scan_view.h"
#include "core/robot/control/drive_setpoint.h"

namespace leitstand {

/// How old what the driver sees of a robot's surroundings may be (design, section 7).
struct SightRules {
    double full = 0.3;        ///< younger: full speed [s]
    double creep = 1.0;       ///< younger: creep speed; older: none [s]
    double creepShare = 0.2;  ///< of the robot's limits
    double turn =
        3.0;  ///< what a scanner saw longer ago in the direction of motion is no eyes [s]; turns take 2.3
};

/// What the driver sees of a robot's surroundings now.
struct SightAges {
    bool camera = false;                                     ///< the robot's file names one
    bool scanner = false;                                    ///< likewise
    PictureAges picture;                                     ///< of the camera that the driver looks through
    double scan = std::numeric_limits<double>::infinity();   ///< since anything of a scan came [s]
    double ahead = std::numeric_limits<double>::infinity();  ///< scanAgeAlong() the motion [s]
};

/// Why a robot may move as fast as it may.
enum class SightReason : std::uint8_t {
    Fresh,      ///< the driver sees what is there
    ScanAlone,  ///< the picture is old, but the virtual scan is fresh
    OldPicture,
    FrozenPicture,  ///< pictures come, but always the same
    NoPicture,      ///< none ever came
    OldScan,        ///< of a robot without a camera
    NoEyes,  ///< its file names neither camera nor scanner: who drives it sees it, and nothing is capped
};

/// How fast a robot may be driven by what its driver sees of it.
struct SightCap {
    double factor = 1.0;  ///< of the robot's limits, 0 to 1
    SightReason reason = SightReason::Fresh;
    double age = 0.0;         ///< of what the reason names [s]; infinite: never
    bool overridden = false;  ///< the driver holds the override: the factor is 1 whatever the reason
    /// The override is what lets it move as fast.
    [[nodiscard]] bool isBlind() const {
        return reason != SightReason::Fresh && reason != SightReason::ScanAlone &&
               reason != SightReason::NoEyes;
    }
    friend bool operator==(const SightCap&, const SightCap&) = default;
};

/// Full speed with a picture or virtual scan younger than 0.3 s, creep speed below 1 s, then none. Pure.
[[nodiscard]] SightCap sightCap(const SightAges& ages, bool overridden, const SightRules& rules = {});

/// How long ago the scanner looked to where @p velocity leads [s]: the age that nine of ten sectors within 30
/// degrees of it have at most; for a turn on the spot, of the half ahead. Standing counts as forward.
/// Infinite: never.
[[nodiscard]] double scanAgeAlong(const VirtualScanView& view, const DriveVelocity& velocity);

/// @p velocity as fast as @p cap lets it, its direction kept; slower ones stay as they are.
[[nodiscard]] DriveVelocity capped(const DriveVelocity& velocity, const SightCap& cap,
                                   const DriveLimits& limits);

}  // namespace leitstand
