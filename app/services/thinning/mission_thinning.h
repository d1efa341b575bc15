#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "core/base/progress.h"
#include "core/base/result.h"

namespace leitstand {

/// How often samples of robots are kept at most, by topic [1/s].
struct ThinSettings {
    double pictures = 1.0;  ///< of each camera
    double clouds = 0.0;    ///< of robots; key scans of the map always stay
    double ranges = 2.0;    ///< turns of plane lasers
    double motion = 10.0;   ///< odometry, transforms
    double seconds = 0.0;   ///< length that is kept, from the mission's beginning [s]; 0: all of it
    double others = 2.0;    ///< other steady streams: inertial units, joints, commands, camera infos
};

/// Result of a thinning.
struct ThinOutcome {
    std::uint64_t kept = 0, left = 0;   ///< events
    std::vector<std::string> problems;  ///< what could not be read
};

/// Writes a small copy of @p mission into the folder @p out, which must not exist. Keeps everything that
/// stations published, except checkpoints. Keeps what robots send on change, and all evidence of finds, also
/// of other stations' finds. Keeps as much of the rest as @p settings allow. Sequences stay, so that evidence
/// is found. Error when the mission cannot be read, @p out cannot be written, or it is cancelled; nothing of
/// @p out is left then.
[[nodiscard]] Result<ThinOutcome> thinMission(const std::filesystem::path& mission,
                                              const std::filesystem::path& out, const ThinSettings& settings,
                                              const Progress& progress = {});

}  // namespace leitstand
