#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "core/base/progress.h"
#include "core/base/result.h"

namespace leitstand {

/// Highest rates at which samples of robots are kept, per topic [1/s].
struct ThinningSettings {
    double pictures = 1.0;  ///< of each camera
    double clouds = 0.0;    ///< clouds of robots; key scans of the map are always kept
    double ranges = 2.0;    ///< turns of plane lasers
    double motion = 10.0;   ///< odometry, transforms
    double seconds = 0.0;   ///< length that is kept, from the beginning of the mission [s]; 0: all of it
    double others = 2.0;    ///< other steady streams: inertial units, joints, commands, camera infos
};

/// Result of thinning a mission.
struct ThinOutcome {
    std::uint64_t kept = 0, left = 0;   ///< number of events that were kept, and that were left out
    std::vector<std::string> problems;  ///< what could not be read
};

/// Writes a small copy of @p mission to the folder @p out, which must not exist. Keeps everything that
/// stations published, except checkpoints. Keeps what robots send on changes, and all evidence of finds,
/// including finds of other stations. Keeps as much of the rest as @p settings allow. Sequences do not
/// change, so that evidence is found. Error when the mission cannot be read, @p out cannot be written, or it
/// is cancelled; then nothing of @p out remains.
[[nodiscard]] Result<ThinOutcome> thinMission(const std::filesystem::path& mission,
                                              const std::filesystem::path& out,
                                              const ThinningSettings& settings,
                                              const Progress& progress = {});

}  // namespace leitstand
