#pragma once

#include <chrono>
#include <optional>
#include <string_view>

#include "core/base/result.h"
#include "core/event/raw_event.h"
#include "core/event/sample.h"
#include "core/robot/robot_description.h"

namespace leitstand {

/// Encodes @p sample as a message of the ROS type @p type, little-endian. Error when that type cannot hold
/// the sample, or when the sample contradicts itself.
[[nodiscard]] Result<Payload> encode(const Sample& sample, std::string_view type);

/// Returns the ROS type that can hold all of @p sample: TwistStamped for a twist with a stamp,
/// CompressedImage for a compressed picture. Empty: Leitstand sends no such samples.
[[nodiscard]] std::string_view typeOf(const Sample& sample);

/// Returns the stamp of a command sent at @p now, on the clock @p source; empty for Zero. @p ahead: robot's
/// clock minus station's clock.
[[nodiscard]] std::optional<Time> commandStamp(StampSource source, Time now, std::chrono::nanoseconds ahead);

}  // namespace leitstand
