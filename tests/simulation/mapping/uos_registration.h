#pragma once

#include <cstddef>

#include "tests/simulation/mapping/mapped_drive.h"

namespace leitstand::simulation::test {

/// What registering the scans of a drive from files came to.
struct UosRegistration {
    std::size_t read = 0;    ///< scans that came back from the files ...
    std::size_t points = 0;  ///< ... with their points, those without an echo too
    Trajectory trajectory;   ///< one pose a scan
};

/// Writes @p drive's scans as a folder of uos scans with their odometry, reads them again and registers them
/// as `leitstandctl register FOLDER --guess odometry` does: one against the one before, from odometry alone.
[[nodiscard]] UosRegistration registeredFromUos(const MappedDrive& drive);

}  // namespace leitstand::simulation::test
