#pragma once

#include <chrono>
#include <optional>
#include <string_view>

#include "core/base/result.h"
#include "core/event/event.h"
#include "core/event/raw_event.h"
#include "core/robot/robot_description.h"

namespace leitstand {

/// @p sample as a message of the ROS type @p type, little-endian. An error when a message of that type cannot
/// say it, or when the sample contradicts itself.
[[nodiscard]] Result<Payload> encode(const Sample& sample, std::string_view type);

/// The ROS type that says everything of @p sample: TwistStamped for a stamped twist, else Twist.
[[nodiscard]] std::string_view typeOf(const Sample& sample);

/// What a command is stamped with: @p source's clock; empty for Zero. @p ahead: robot's clock minus
/// station's.
[[nodiscard]] std::optional<Time> commandStamp(StampSource source, Time now, std::chrono::nanoseconds ahead);

}  // namespace leitstand
