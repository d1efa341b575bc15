#include "robots/simulation/sensors/sensor_place.h"

#include <algorithm>

namespace leitstand::simulation {
namespace {

constexpr double Up = 0.7;  ///< z axes that rise more stand like base_link's

}  // namespace

std::optional<SensorPlace> placeOf(const RobotDescription& robot, StreamRole role, const std::string& key,
                                   const SensorPlace& usual) {
    SensorPlace place = usual;
    const StreamDescription* stream = robot.stream(role, key);
    if (stream == nullptr && !robot.streams.empty()) return std::nullopt;
    if (stream != nullptr) place.key = stream->sensor;
    const auto sensor = robot.sensors.find(place.key.empty() ? usual.key : place.key);
    if (sensor != robot.sensors.end()) {
        if (!sensor->second.frame.empty()) place.frame = sensor->second.frame;
        if (!sensor->second.sensorInBase.isApprox(Pose::Identity(), 1e-9)) {
            place.inBase = sensor->second.sensorInBase;
        }
    }
    return place;
}

Eigen::Matrix3d opticalAxes() {
    Eigen::Matrix3d axes;
    axes << 0, 0, 1,  //
        -1, 0, 0,     //
        0, -1, 0;
    return axes;
}

Eigen::Matrix3d mirrorAxes() {
    Eigen::Matrix3d axes;  // x to the right, y back, z down
    axes << 0, -1, 0,      //
        -1, 0, 0,          //
        0, 0, -1;
    return axes;
}

SensorPlace opticalPlace(const SensorPlace& place, const Eigen::Matrix3d& axes) {
    if (place.inBase.linear()(2, 2) < Up) return place;
    SensorPlace optical = place;
    optical.frame += "_optical";
    optical.inBase.linear() = place.inBase.linear() * axes;
    return optical;
}

}  // namespace leitstand::simulation
