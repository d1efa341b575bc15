#include "core/robot/scanner_correction.h"

#include <algorithm>

namespace leitstand {

ScannerCorrection ScannerCorrection::with(const ScannerCorrection& more) const {
    const auto limited = [](double value, double most) { return std::clamp(value, -most, most); };
    return {limited(range + more.range, MostRange), limited(roll + more.roll, MostLean),
            limited(pitch + more.pitch, MostLean)};
}

Pose ScannerCorrection::corrected(const Pose& sensorInBase) const {
    Pose pose = sensorInBase;
    pose.linear() = poseFrom(Eigen::Vector3d::Zero(), roll, pitch, 0.0).linear() * sensorInBase.linear();
    return pose;
}

void ScannerCorrection::correct(CloudSample& cloud) const {
    if (range == 0.0) return;
    const auto more = static_cast<float>(range);
    for (Eigen::Vector3f& point : cloud.points) {
        const float seen = point.norm();
        if (seen > 0.0F) point *= std::max(0.0F, 1.0F + more / seen);  // what is no echo stays none
    }
}

}  // namespace leitstand
