#pragma once

#include <filesystem>
#include <vector>

#include "core/base/pose.h"
#include "core/base/result.h"
#include "core/base/time.h"

namespace leitstand {

/// A pose of a trajectory, with its time.
struct TimedPose {
    Time time{};
    Pose pose = Pose::Identity();
};

/// Reads a trajectory of lines "t x y z qx qy qz qw" [s, m]; skips blank lines and comments ('#'). Error when
/// the length of a quaternion differs from 1 by more than 1 %; other quaternions are normalised.
[[nodiscard]] Result<std::vector<TimedPose>> readTum(const std::filesystem::path& file);

/// Writes @p poses so that readTum() returns the same poses, and the same times to the nanosecond.
[[nodiscard]] Result<void> writeTum(const std::filesystem::path& file, const std::vector<TimedPose>& poses);

}  // namespace leitstand
