#pragma once

#include <functional>
#include <optional>

#include "core/base/pose.h"
#include "core/base/time.h"

namespace leitstand {

struct CloudSample;

/// Returns a sensor's pose in odom at a moment of its robot's clock; empty where it is unknown.
using SensorTrack = std::function<std::optional<Pose>(Time)>;

/// Returns the stamp of the last shot of @p cloud.
[[nodiscard]] Time endOf(const CloudSample& cloud);

/// Moves each point of @p cloud by the sensor's motion since the point's own shot, to where the sensor would
/// have seen it from its pose at the last shot. Returns that pose (sensorInOdom). Empty, and nothing is
/// moved, when that pose is unknown. Points of moments that @p track does not know stay as they are, and so
/// do clouds without times.
[[nodiscard]] std::optional<Pose> takeMotionOut(CloudSample& cloud, const SensorTrack& track);

}  // namespace leitstand
