#include "core/station/robot_figures.h"

#include <algorithm>
#include <cmath>

namespace leitstand {

std::optional<std::pair<double, double>> rollAndPitch(const RobotDescription& description,
                                                      const RobotState& said, Time now) {
    Eigen::Matrix3d baseInLevel;
    if (isFresh(said.imu, now, 1.0) && said.imu->sample.orientation) {
        baseInLevel = said.imu->sample.orientation->toRotationMatrix();
        const StreamDescription* stream = description.stream(StreamRole::Imu);
        const auto sensor =
            stream == nullptr ? description.sensors.end() : description.sensors.find(stream->sensor);
        if (sensor != description.sensors.end())
            baseInLevel = baseInLevel * sensor->second.sensorInBase.linear().transpose();
    } else if (isFresh(said.odometry, now, 1.0)) {
        baseInLevel = said.odometry->sample.baseInOdom.linear();
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

double minutesLeft(const RobotState& said) {
    if (!said.battery) return Unknown;
    const BatterySample& battery = said.battery->sample;
    double charge = battery.charge;
    if (!std::isfinite(charge)) charge = battery.fraction * battery.capacity;
    const double current = std::isfinite(said.load.current) ? said.load.current : battery.current;
    return battery.current < -0.01 && current < -0.01 ? 60.0 * charge / -current : Unknown;
}

}  // namespace leitstand
