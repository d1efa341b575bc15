#pragma once

#include <optional>
#include <utility>
#include <vector>

#include "core/robot/samples/cloud_sample.h"
#include "core/scan/motion_compensation.h"
#include "core/scan/scan.h"

namespace leitstand {

/// Puts what a 3D scanner sends together to scans. A cloud that is a whole sweep is a scan by itself. Slices
/// of a yawing scanner (organised, rows are vertical raw scans, design section 4) are gathered until they
/// make a turn of 360 degrees. The robot's motion is taken out: every point is moved by the sensor's motion
/// from its own shot to the scan's last one. One thread at a time.
class TurnAssembler {
public:
    /// Adds @p cloud; @p track tells where the sensor was (unknown: it counts as at rest). Returns a scan
    /// when one is complete: without name and robot.
    [[nodiscard]] std::optional<Scan> add(CloudSample cloud, const SensorTrack& track);
    /// The same of a sensor that did not move during @p cloud.
    [[nodiscard]] std::optional<Scan> add(CloudSample cloud, const std::optional<Pose>& sensorInOdom) {
        return add(std::move(cloud), [&](Time) { return sensorInOdom; });
    }
    /// What is gathered of a turn that has not ended, when it is half a turn at least.
    [[nodiscard]] std::optional<Scan> finish();

private:
    struct Slice {
        CloudSample cloud;                 ///< as seen from the pose at its last shot
        std::optional<Pose> sensorInOdom;  ///< at its last shot
    };
    [[nodiscard]] std::optional<Scan> take();
    void forget();

    std::vector<Slice> m_slices;
    double m_turned = 0.0;                ///< by the raw scans gathered [rad]
    int m_rows = 0;                       ///< raw scans gathered that tell a heading
    std::optional<double> m_lastHeading;  ///< of the last raw scan [rad]
};

}  // namespace leitstand
