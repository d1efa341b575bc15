#include "core/station/robot_figures.h"

#include <algorithm>
#include <cmath>

#include "core/event/motion_samples.h"
#include "core/event/status_samples.h"
#include "core/event/stream_role.h"

namespace leitstand {

std::optional<std::pair<double, double>> rollAndPitch(const RobotDescription& description,
                                                      const RobotState& reported, Time now) {
    Eigen::Matrix3d baseInLevel;
    if (isFresh(reported.imu, now, 1.0) && reported.imu->sample.orientation) {
        baseInLevel = reported.imu->sample.orientation->toRotationMatrix();
        const StreamDescription* stream = description.stream(StreamRole::Imu);
        const auto sensor =
            stream == nullptr ? description.sensors.end() : description.sensors.find(stream->sensor);
        if (sensor != description.sensors.end())
            baseInLevel = baseInLevel * sensor->second.sensorInBase.linear().transpose();
    } else if (isFresh(reported.odometry, now, 1.0)) {
        baseInLevel = reported.odometry->sample.baseInOdom.linear();
    } else {
        return std::nullopt;
    }
    const double roll = std::atan2(baseInLevel(2, 1), baseInLevel(2, 2));
    const double pitch = std::asin(std::clamp(-baseInLevel(2, 0), -1.0, 1.0));
    if (!std::isfinite(roll) || !std::isfinite(pitch)) return std::nullopt;
    return std::pair(roll, pitch);
}

double shareOfLimits(const RobotDescription& description, double roll, double pitch) {
    double share = 0.0;
    if (description.maxRoll > 0.0) share = std::max(share, std::abs(roll) / description.maxRoll);
    if (description.maxPitch > 0.0) share = std::max(share, std::abs(pitch) / description.maxPitch);
    return share;
}

double minutesLeft(const RobotState& reported) {
    if (!reported.battery) return Unknown;
    const BatterySample& battery = reported.battery->sample;
    double charge = battery.charge;
    if (!std::isfinite(charge)) charge = battery.fraction * battery.capacity;
    const double current = std::isfinite(reported.load.current) ? reported.load.current : battery.current;
    return battery.current < -0.01 && current < -0.01 ? 60.0 * charge / -current : Unknown;
}

}  // namespace leitstand
