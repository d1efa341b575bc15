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
    double turn = 3.0;        ///< an older scan of the direction of motion does not count [s]; turns take 2.3
};

/// Ages of what the driver sees of a robot's surroundings.
struct SightAges {
    bool camera = false;                                     ///< the robot's file names a camera
    bool scanner = false;                                    ///< the robot's file names a scanner
    PictureAges picture;                                     ///< of the camera that the driver looks through
    double scan = std::numeric_limits<double>::infinity();   ///< since any part of a scan arrived [s]
    double ahead = std::numeric_limits<double>::infinity();  ///< scanAgeAlong() the motion [s]
};

/// The reason why a robot may move as fast as it may.
enum class SightReason : std::uint8_t {
    Fresh,      ///< the driver sees what is there
    ScanAlone,  ///< the picture is old, but the virtual scan is fresh
    OldPicture,
    FrozenPicture,  ///< pictures arrive, but always the same
    NoPicture,      ///< none ever arrived
    OldScan,        ///< of a robot without a camera
    NoEyes,  ///< its file names neither camera nor scanner: its driver sees the robot, and nothing is capped
};

/// How fast a robot may be driven by what its driver sees of it.
struct SightCap {
    double factor = 1.0;  ///< of the robot's limits, 0 to 1
    SightReason reason = SightReason::Fresh;
    double age = 0.0;         ///< of what the reason names [s]; infinite: never
    bool overridden = false;  ///< the driver holds the override: the factor is 1 whatever the reason
    /// Whether only the override lets it move this fast.
    [[nodiscard]] bool isBlind() const {
        return reason != SightReason::Fresh && reason != SightReason::ScanAlone &&
               reason != SightReason::NoEyes;
    }
    friend bool operator==(const SightCap&, const SightCap&) = default;
};

/// Returns full speed with a picture or virtual scan younger than 0.3 s, creep speed below 1 s, then none.
/// Pure.
[[nodiscard]] SightCap sightCap(const SightAges& ages, bool overridden, const SightRules& rules = {});

/// Returns how long ago the scanner looked in the direction of @p velocity [s]; infinite: never. It is the
/// age that nine of ten sectors within 30 degrees of that have at most. A turn on the spot counts the half
/// ahead; standing counts as forward.
[[nodiscard]] double scanAgeAlong(const VirtualScanView& view, const DriveVelocity& velocity);

/// Returns @p velocity reduced to @p cap, in the same direction; slower ones stay as they are.
[[nodiscard]] DriveVelocity capped(const DriveVelocity& velocity, const SightCap& cap,
                                   const DriveLimits& limits);

}  // namespace leitstand
