#pragma once

#include <optional>
#include <vector>

#include "core/robot/samples/cloud_sample.h"
#include "core/scan/scan.h"

namespace leitstand {

/// Puts what a 3D scanner sends together to scans. A cloud that is a whole sweep is a scan by itself. Slices
/// of a yawing scanner (organised, rows are vertical raw scans, design section 4) are gathered until they
/// make a turn of 360 degrees; each slice is moved by its own pose, so that the robot's motion from slice to
/// slice is taken out. One thread at a time.
class TurnAssembler {
public:
    /// Adds @p cloud, taken when the sensor was at @p sensorInOdom (empty: unknown, it then counts as at
    /// rest). Returns a scan when one is complete: without name and robot.
    [[nodiscard]] std::optional<Scan> add(const CloudSample& cloud, const std::optional<Pose>& sensorInOdom);
    /// What is gathered of a turn that has not ended, when it is half a turn at least.
    [[nodiscard]] std::optional<Scan> finish();

private:
    struct Slice {
        CloudSample cloud;
        std::optional<Pose> sensorInOdom;
    };
    [[nodiscard]] std::optional<Scan> take();
    void forget();

    std::vector<Slice> m_slices;
    double m_turned = 0.0;                ///< by the raw scans gathered [rad]
    int m_rows = 0;                       ///< raw scans gathered that tell a heading
    std::optional<double> m_lastHeading;  ///< of the last raw scan [rad]
};

}  // namespace leitstand
