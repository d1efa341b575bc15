#pragma once

#include <cstdint>
#include <vector>

#include <Eigen/Core>

#include "core/event/sample_header.h"

namespace leitstand {

/// Points of a 3D scanner: a slice of its sweep or a whole sweep (sensor_msgs/msg/PointCloud2).
struct CloudSample {
    SampleHeader header;
    int rows = 0, columns = 0;            ///< row-major grid of the message; 0 x 0 when unorganised
    std::vector<Eigen::Vector3f> points;  ///< in the header's frame [m]; no echo: x, y, z NaN
    std::vector<float> intensities;       ///< empty, or one a point; as the sensor gives them
    std::vector<std::int64_t> times;  ///< empty, or one a point: after the header's stamp [ns], may be < 0
    std::vector<std::int32_t> rings;  ///< empty, or one a point: row of the raw scan

    [[nodiscard]] bool organised() const { return rows > 0 && columns > 0; }
};

/// One turn of a plane laser scanner (sensor_msgs/msg/LaserScan).
struct RangesSample {
    SampleHeader header;                    ///< stamp: of the first ray
    double angleMin = 0.0;                  ///< of the first ray, about z, counter-clockwise [rad]
    double angleStep = 0.0;                 ///< from ray to ray [rad]; not 0 where there are rays
    double timeStep = 0.0;                  ///< from ray to ray [s]
    double turnTime = 0.0;                  ///< from turn to turn [s]
    double rangeMin = 0.0, rangeMax = 0.0;  ///< ranges outside are no echo [m]
    std::vector<float> ranges;              ///< [m]; may be NaN or infinite: no echo
    std::vector<float> intensities;         ///< empty, or one a ray
};

}  // namespace leitstand
