#pragma once

#include <cstddef>
#include <filesystem>

namespace leitstand::test {

/// What a driven mission has.
struct DrivenMission {
    std::size_t keyScans = 0, points = 0;  ///< of all key scans
    std::size_t victims = 0;               ///< confirmed, each with pictures, heat and gas
    std::size_t events = 0;                ///< in the log, checkpoints apart
};

/// Writes twenty minutes on Kurt3D and the Crawler into @p folder, as a station records them: odometry of
/// both at 20 Hz, pictures of camera and infrared, a key scan of some ten thousand points every 3 s, a
/// checkpoint every 20 s, six victims. They drive to and fro through six furnished rooms of 8 m x 6 m.
DrivenMission writeDrivenMission(const std::filesystem::path& folder);

}  // namespace leitstand::test
