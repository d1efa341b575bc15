#pragma once

#include <functional>
#include <optional>

#include "core/base/pose.h"
#include "core/base/time.h"
#include "core/event/cloud_sample.h"

namespace leitstand {

/// Where a sensor was in odom at a moment of its robot's clock; empty where nobody knows.
using SensorTrack = std::function<std::optional<Pose>(Time)>;

/// Stamp of the last shot of @p cloud.
[[nodiscard]] Time endOf(const CloudSample& cloud);

/// Moves the points of @p cloud to where the sensor would have seen them from its pose at the last shot, each
/// by the sensor's motion since its own shot, and returns that pose (sensorInOdom). Empty, and nothing is
/// moved, when that pose is unknown; points of moments of which @p track knows nothing stay as they are, and
/// so do those of clouds that do not tell times.
[[nodiscard]] std::optional<Pose> takeMotionOut(CloudSample& cloud, const SensorTrack& track);

}  // namespace leitstand
