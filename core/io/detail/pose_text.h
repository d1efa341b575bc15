#pragma once

#include <optional>
#include <string_view>

#include "core/base/pose.h"

namespace leitstand::detail {

/// Takes the pose "x y z qx qy qz qw" [m], with which @p line ends. A text says what was expected instead:
/// @p expectation where there are other fields. A quaternion whose length is not 1 within 1 % is an error.
[[nodiscard]] std::optional<std::string_view> takePose(std::string_view line, Pose& into,
                                                       std::string_view expectation);

}  // namespace leitstand::detail
