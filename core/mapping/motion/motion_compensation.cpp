#include "core/mapping/motion/motion_compensation.h"

#include <algorithm>
#include <chrono>
#include <cstddef>
#include <cstdint>

#include "core/event/cloud_sample.h"

namespace leitstand {

Time endOf(const CloudSample& cloud) {
    const auto last = std::max_element(cloud.times.begin(), cloud.times.end());
    const auto after = last == cloud.times.end() ? 0 : std::max<std::int64_t>(*last, 0);
    return cloud.header.stamp + std::chrono::nanoseconds(after);
}

std::optional<Pose> takeMotionOut(CloudSample& cloud, const SensorTrack& track) {
    const std::optional<Pose> atEnd = track(endOf(cloud));
    if (!atEnd || cloud.times.size() != cloud.points.size()) return atEnd;
    const Pose odomInEnd = atEnd->inverse();
    std::optional<std::int64_t> moment;  // neighbours mostly share it
    std::optional<Eigen::Isometry3f> motion;
    for (std::size_t i = 0; i < cloud.points.size(); ++i) {
        if (moment != cloud.times[i]) {
            moment = cloud.times[i];
            const auto then = track(cloud.header.stamp + std::chrono::nanoseconds(*moment));
            motion = then ? std::optional((odomInEnd * *then).cast<float>()) : std::nullopt;
        }
        if (motion) cloud.points[i] = *motion * cloud.points[i];
    }
    return atEnd;
}

}  // namespace leitstand
