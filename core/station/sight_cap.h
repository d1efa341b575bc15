#pragma once

#include <cstdint>
#include <limits>

#include "core/perception/pictures/picture_watch.h"
#include "core/perception/surroundings/virtual_scan_view.h"
#include "core/robot/control/drive_setpoint.h"

namespace leitstand {

/// Limits for the age of what the driver sees of a robot's surroundings (docs/design.md, "The window").
struct SightRules {
    double full = 0.3;        ///< up to this age: full speed [s]
    double creep = 1.0;       ///< up to this age: creep speed; beyond it: no speed [s]
    double creepShare = 0.2;  ///< creep speed as a share of the robot's limits
    /// A scan is used if it saw the direction of motion within this time [s]; a turn takes 2.3 s.
    double turn = 3.0;
};

/// Ages of what the driver sees of a robot's surroundings.
struct SightAges {
    bool camera = false;   ///< whether the robot's file has a camera
    bool scanner = false;  ///< whether the robot's file has a scanner
    PictureAges picture;   ///< ages of the pictures of the camera that the driver looks through
    double scan = std::numeric_limits<double>::infinity();   ///< since any part of a scan arrived [s]
    double ahead = std::numeric_limits<double>::infinity();  ///< scanAgeAlong() for the motion [s]
};

/// Why a SightCap allows its speed.
enum class SightReason : std::uint8_t {
    Fresh,      ///< the driver sees the surroundings as they are now
    ScanAlone,  ///< the picture is old, but the virtual scan is fresh
    OldPicture,
    FrozenPicture,  ///< pictures arrive, but they are always the same
    NoPicture,      ///< no picture ever arrived
    OldScan,        ///< the scan is old, and the robot has no camera
    /// Its file has neither camera nor scanner: its driver sees the robot directly, and speed is not limited.
    NoEyes,
};

/// The limit of a robot's speed, given how well its driver sees its surroundings.
struct SightCap {
    double factor = 1.0;  ///< share of the robot's limits, 0 to 1
    SightReason reason = SightReason::Fresh;
    double age = 0.0;  ///< age of the picture; without a camera, of the scan [s]; infinite: never received
    bool overridden = false;  ///< the driver holds the override: the factor is 1 for any reason
    /// Whether picture and scan are missing or too old, so that only the override allows full speed.
    [[nodiscard]] bool isBlind() const {
        return reason != SightReason::Fresh && reason != SightReason::ScanAlone &&
               reason != SightReason::NoEyes;
    }
    friend bool operator==(const SightCap&, const SightCap&) = default;
};

/// Returns full speed if the picture or virtual scan is younger than 0.3 s, creep speed below 1 s, otherwise
/// none. Also returns full speed with the override, and for robots with neither camera nor scanner. Pure.
[[nodiscard]] SightCap sightCap(const SightAges& ages, bool overridden, const SightRules& rules = {});

/// Returns how long ago the scanner saw the direction of @p velocity [s]; infinite: never. Nine of ten
/// sectors within 30 degrees of that direction are at most this old. For a turn on the spot, the half circle
/// ahead is used; for standing, the direction ahead.
[[nodiscard]] double scanAgeAlong(const VirtualScanView& view, const DriveVelocity& velocity);

/// Returns @p velocity reduced to the share of @p limits that @p cap allows, in the same direction. A slower
/// velocity is not changed.
[[nodiscard]] DriveVelocity capped(const DriveVelocity& velocity, const SightCap& cap,
                                   const DriveLimits& limits);

}  // namespace leitstand
