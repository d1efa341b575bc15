#pragma once

#include <optional>
#include <string_view>

#include "core/base/pose.h"

namespace leitstand::detail {

/// Reads the pose "x y z qx qy qz qw" [m] from @p line into @p into. Returns what was expected instead; empty
/// when the pose was read. @p expectation is returned when @p line is not exactly seven finite numbers.
/// Positions beyond 100 km are refused, and quaternions whose length differs from 1 by more than 1 %.
[[nodiscard]] std::optional<std::string_view> takePose(std::string_view line, Pose& into,
                                                       std::string_view expectation);

}  // namespace leitstand::detail
