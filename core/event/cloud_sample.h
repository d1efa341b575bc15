#pragma once

#include <cstdint>
#include <vector>

#include <Eigen/Core>

#include "core/event/sample_header.h"

namespace leitstand {

/// Points of a 3D scanner: a slice of its sweep, or a whole sweep (sensor_msgs/msg/PointCloud2).
struct CloudSample {
    SampleHeader header;
    int rows = 0, columns = 0;  ///< rows and columns of the message's grid (row by row); 0 x 0: unorganised
    std::vector<Eigen::Vector3f> points;  ///< in the header's frame [m]; NaN: no echo
    std::vector<float> intensities;       ///< empty, or one per point, in the sensor's units
    /// Empty, or one per point: time after the header's stamp [ns]; may be negative.
    std::vector<std::int64_t> times;
    std::vector<std::int32_t> rings;  ///< empty, or one per point: row of the raw scan

    [[nodiscard]] bool organised() const { return rows > 0 && columns > 0; }
};

/// One turn of a plane laser scanner (sensor_msgs/msg/LaserScan).
struct RangesSample {
    SampleHeader header;                    ///< its stamp is that of the first ray
    double angleMin = 0.0;                  ///< angle of the first ray about z, counter-clockwise [rad]
    double angleStep = 0.0;                 ///< angle between rays [rad]; not 0 if there are rays
    double timeStep = 0.0;                  ///< time between rays [s]
    double turnTime = 0.0;                  ///< time between turns [s]
    double rangeMin = 0.0, rangeMax = 0.0;  ///< smaller and larger ranges are no echo [m]
    std::vector<float> ranges;              ///< [m]; NaN or infinite: no echo
    std::vector<float> intensities;         ///< empty, or one per ray
};

}  // namespace leitstand
