#pragma once

#include <optional>
#include <string_view>

#include "core/base/pose.h"

namespace leitstand::detail {

/// Takes the pose "x y z qx qy qz qw" [m], with which @p line ends. Returns what was expected instead, if
/// anything: @p expectation when the fields differ. Refuses a quaternion whose length differs from 1 by more
/// than 1 %.
[[nodiscard]] std::optional<std::string_view> takePose(std::string_view line, Pose& into,
                                                       std::string_view expectation);

}  // namespace leitstand::detail
