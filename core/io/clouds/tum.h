#pragma once

#include <filesystem>
#include <vector>

#include "core/base/pose.h"
#include "core/base/result.h"
#include "core/base/time.h"

namespace leitstand {

/// A pose of a trajectory.
struct TimedPose {
    Time time{};
    Pose pose = Pose::Identity();
};

/// Reads a trajectory of lines "t x y z qx qy qz qw" [s, m]; blank lines and comments ('#') are left out. A
/// quaternion whose length is not 1 within 1 % is an error, smaller differences are removed.
[[nodiscard]] Result<std::vector<TimedPose>> readTum(const std::filesystem::path& file);

/// Writes @p poses so that readTum() gives the same times, to the nanosecond, and poses.
[[nodiscard]] Result<void> writeTum(const std::filesystem::path& file, const std::vector<TimedPose>& poses);

}  // namespace leitstand
