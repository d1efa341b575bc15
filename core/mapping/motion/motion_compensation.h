#pragma once

#include <functional>
#include <optional>

#include "core/base/pose.h"
#include "core/base/time.h"

namespace leitstand {

struct CloudSample;

/// Returns a sensor's pose in odom at a time of its robot's clock; empty: unknown.
using SensorTrack = std::function<std::optional<Pose>(Time)>;

/// Returns the stamp of the last shot of @p cloud.
[[nodiscard]] Time endOf(const CloudSample& cloud);

/// Removes the sensor's motion from @p cloud: each point is moved to where the sensor would have seen it from
/// its pose at the last shot. Returns that pose (sensorInOdom). If that pose is unknown, returns nothing and
/// moves nothing. Points at times that @p track does not know are not moved, and neither are clouds without
/// times.
[[nodiscard]] std::optional<Pose> takeMotionOut(CloudSample& cloud, const SensorTrack& track);

}  // namespace leitstand
