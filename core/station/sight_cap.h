#pragma once

#include <cstdint>
#include <limits>

#include "core/perception/pictures/picture_watch.h"
#include "core/perception/surroundings/virtual_scan_view.h"
#include "core/robot/control/drive_setpoint.h"

namespace leitstand {

/// Limits on the age of what the driver sees of a robot's surroundings (docs/design.md, "The window").
struct SightRules {
    double full = 0.3;        ///< younger: full speed [s]
    double creep = 1.0;       ///< younger: creep speed; older: none [s]
    double creepShare = 0.2;  ///< of the robot's limits
    double turn = 3.0;  ///< a scan counts if it saw the direction of motion within this [s]; a turn takes 2.3
};

/// Ages of what the driver sees of a robot's surroundings.
struct SightAges {
    bool camera = false;                                     ///< the robot's file names a camera
    bool scanner = false;                                    ///< the robot's file names a scanner
    PictureAges picture;                                     ///< of the camera that the driver looks through
    double scan = std::numeric_limits<double>::infinity();   ///< since any part of a scan arrived [s]
    double ahead = std::numeric_limits<double>::infinity();  ///< scanAgeAlong() of the motion [s]
};

/// The reason for the speed that a SightCap allows.
enum class SightReason : std::uint8_t {
    Fresh,      ///< the driver sees what is there
    ScanAlone,  ///< the picture is old, but the virtual scan is fresh
    OldPicture,
    FrozenPicture,  ///< pictures arrive, but always the same
    NoPicture,      ///< none ever arrived
    OldScan,        ///< the scan is old, and the robot has no camera
    NoEyes,  ///< its file names neither camera nor scanner: its driver sees the robot, and nothing is capped
};

/// The limit on a robot's speed by how well its driver sees its surroundings.
struct SightCap {
    double factor = 1.0;  ///< of the robot's limits, 0 to 1
    SightReason reason = SightReason::Fresh;
    double age = 0.0;  ///< of the picture, or of the scan without a camera [s]; infinite: none ever arrived
    bool overridden = false;  ///< the driver holds the override: the factor is 1 whatever the reason
    /// Whether picture and scan are missing or too old, so that only the override allows full speed.
    [[nodiscard]] bool isBlind() const {
        return reason != SightReason::Fresh && reason != SightReason::ScanAlone &&
               reason != SightReason::NoEyes;
    }
    friend bool operator==(const SightCap&, const SightCap&) = default;
};

/// Returns full speed with a picture or virtual scan younger than 0.3 s, creep speed below 1 s, then none.
/// Full speed also with the override, and for robots with neither camera nor scanner. Pure.
[[nodiscard]] SightCap sightCap(const SightAges& ages, bool overridden, const SightRules& rules = {});

/// Returns how long ago the scanner looked in the direction of @p velocity [s]; infinite: never. Nine of ten
/// sectors within 30 degrees of that direction are at most this old. A turn on the spot uses the half circle
/// ahead; standing counts as forward.
[[nodiscard]] double scanAgeAlong(const VirtualScanView& view, const DriveVelocity& velocity);

/// Returns @p velocity reduced to the share of @p limits that @p cap allows, in the same direction. A slower
/// velocity stays as it is.
[[nodiscard]] DriveVelocity capped(const DriveVelocity& velocity, const SightCap& cap,
                                   const DriveLimits& limits);

}  // namespace leitstand
