#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "core/base/progress.h"
#include "core/base/result.h"

namespace leitstand {

/// How much of what robots said is kept, at most so often a topic [1/s].
struct ThinSettings {
    double pictures = 1.0;  ///< of each camera
    double clouds = 0.0;    ///< the map's key scans are the station's, and stay
    double ranges = 2.0;    ///< turns of plane lasers
    double motion = 10.0;   ///< odometry, transforms
    double seconds = 0.0;   ///< only so much of the mission's beginning [s]; 0: all of it
    double others = 2.0;    ///< of what comes steadily: inertial units, joints, commands, camera infos
};

/// What came of it.
struct ThinOutcome {
    std::uint64_t kept = 0, left = 0;   ///< events
    std::vector<std::string> problems;  ///< what could not be read
};

/// Writes a small copy of @p mission into the folder @p out, which must not exist: everything that stations
/// said but for checkpoints, what robots say on change, all evidence of finds, also of those that other
/// stations told, and of the rest so much as @p settings say. Sequences stay, so that evidence is found. An
/// error when the mission cannot be read or @p out not be written; cancelled: what was written so far.
[[nodiscard]] Result<ThinOutcome> thinMission(const std::filesystem::path& mission,
                                              const std::filesystem::path& out, const ThinSettings& settings,
                                              const Progress& progress = {});

}  // namespace leitstand
