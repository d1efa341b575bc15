#pragma once

#include <span>
#include <string_view>

#include "core/robot/robot_description.h"

namespace leitstand {

/// The ROS types that a stream of @p role may have; the first one is the default.
[[nodiscard]] std::span<const std::string_view> typesOf(StreamRole role);

}  // namespace leitstand
