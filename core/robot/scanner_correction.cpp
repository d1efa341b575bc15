#include "core/robot/scanner_correction.h"

#include <algorithm>
#include <chrono>
#include <cmath>

#include "core/event/cloud_sample.h"

namespace leitstand {

ScannerCorrection ScannerCorrection::with(const ScannerCorrection& more) const {
    const auto limited = [](double value, double most) { return std::clamp(value, -most, most); };
    return {limited(range + more.range, MostRange), limited(roll + more.roll, MostLean),
            limited(pitch + more.pitch, MostLean),  limited(x + more.x, MostShift),
            limited(y + more.y, MostShift),         limited(yaw + more.yaw, MostTurn),
            limited(clock + more.clock, MostClock)};
}

Pose ScannerCorrection::corrected(const Pose& sensorInBase) const {
    Pose pose = sensorInBase;
    pose.translation() += Eigen::Vector3d(x, y, 0.0);
    const Eigen::Vector3d none = Eigen::Vector3d::Zero();
    pose.linear() = poseFrom(none, roll, pitch, 0.0).linear() * poseFrom(none, 0.0, 0.0, yaw).linear() *
                    sensorInBase.linear();
    return pose;
}

void ScannerCorrection::correct(CloudSample& cloud) const {
    if (cloud.header.stamp != Time{})
        cloud.header.stamp += std::chrono::nanoseconds(std::llround(1e9 * clock));
    if (range == 0.0) return;
    const auto more = static_cast<float>(range);
    for (Eigen::Vector3f& point : cloud.points) {
        const float seen = point.norm();
        if (seen > 0.0F) point *= std::max(0.0F, 1.0F + more / seen);  // no echo stays no echo
    }
}

}  // namespace leitstand
