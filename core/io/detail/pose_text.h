#pragma once

#include <optional>
#include <string_view>

#include "core/base/pose.h"

namespace leitstand::detail {

/// Reads the pose "x y z qx qy qz qw" [m] of @p line, which must hold nothing else, into @p into. Returns
/// what was expected instead; empty: the pose was read. That is @p expectation when @p line does not hold
/// seven finite numbers. Also refuses positions beyond 100 km, and quaternions whose length differs from 1 by
/// more than 1 %.
[[nodiscard]] std::optional<std::string_view> takePose(std::string_view line, Pose& into,
                                                       std::string_view expectation);

}  // namespace leitstand::detail
