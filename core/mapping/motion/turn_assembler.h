#pragma once

#include <chrono>
#include <cstdint>
#include <limits>
#include <optional>
#include <utility>
#include <vector>

#include "core/base/pose.h"
#include "core/cloud/scan.h"
#include "core/event/cloud_sample.h"
#include "core/mapping/motion/motion_compensation.h"

namespace leitstand {

/// When a turn ends that the scanner does not finish.
struct TurnSettings {
    double leastTurn = degrees(180);  ///< shorter interrupted turns are left out; 0: none is [rad]
    double longestWay = std::numeric_limits<double>::infinity();  ///< of the sensor within a turn [m] ...
    double mostTurned = std::numeric_limits<double>::infinity();  ///< ... and its largest turn [rad]; beyond,
                                                                  ///< the turn ends there
    /// A turn that lasts longer breaks off if it is also slower than slowestTurn for 360 degrees: the drive
    /// is stuck, or the window is covered.
    std::chrono::nanoseconds longestTime = std::chrono::seconds(10);
    std::chrono::nanoseconds slowestTurn = std::chrono::seconds(30);
};

/// The reason why a scan ends.
enum class TurnEnd : std::uint8_t {
    Turn,      ///< the scanner saw all directions
    Sweep,     ///< the cloud was a whole sweep
    Distance,  ///< the robot moved farther than TurnSettings allow
    Break,     ///< no more slices came, or different ones, or they make no turn
};

/// Assembles scans from the clouds of a 3D scanner. A cloud that is a whole sweep is a scan of its own.
/// Slices of a yawing scanner (organised, rows are vertical raw scans, design section 4) are gathered until
/// they make a turn of 360 degrees, from wherever they begin. The robot's motion is taken out: every point is
/// moved by the sensor's motion from its own shot to the scan's last one. One thread at a time.
class TurnAssembler {
public:
    explicit TurnAssembler(const TurnSettings& settings = {}) : m_settings(settings) {}

    /// Adds @p cloud; @p track returns the sensor's pose (unknown: it counts as at rest). Returns a scan,
    /// without name and robot, when one is complete.
    [[nodiscard]] std::optional<Scan> add(CloudSample cloud, const SensorTrack& track);
    /// The same for a sensor that did not move during @p cloud.
    [[nodiscard]] std::optional<Scan> add(CloudSample cloud, const std::optional<Pose>& sensorInOdom) {
        return add(std::move(cloud), [&](Time) { return sensorInOdom; });
    }
    /// Returns what is gathered of an unfinished turn, if the settings accept it.
    [[nodiscard]] std::optional<Scan> finish();
    /// Returns why the last returned scan ended.
    [[nodiscard]] TurnEnd ended() const { return m_ended; }
    /// Returns where the sensor was at the end of the first slice of the last returned scan, in that scan's
    /// frame [m]; zero: unknown.
    [[nodiscard]] const Eigen::Vector3d& began() const { return m_began; }
    [[nodiscard]] bool gathers() const { return !m_slices.empty(); }

private:
    struct Slice {
        CloudSample cloud;                 ///< as seen from the pose at its last shot
        std::optional<Pose> sensorInOdom;  ///< at its last shot
    };
    [[nodiscard]] std::optional<Scan> take(TurnEnd end);
    [[nodiscard]] bool continues(const CloudSample& cloud) const;
    /// Returns whether the turn would take too long with @p cloud.
    [[nodiscard]] bool takesTooLong(const CloudSample& cloud) const;
    [[nodiscard]] bool movedTooFar() const;
    void gather(CloudSample cloud, const std::optional<Pose>& sensorInOdom);
    void forget();

    TurnSettings m_settings;
    std::vector<Slice> m_slices;
    double m_turned = 0.0;                ///< by the raw scans gathered [rad]
    int m_rows = 0;                       ///< gathered raw scans with a heading
    std::optional<double> m_lastHeading;  ///< of the last raw scan [rad]
    double m_way = 0.0;                   ///< of the sensor from the first slice gathered [m]
    double m_rotated = 0.0;               ///< of the sensor from the first slice gathered [rad]
    TurnEnd m_ended = TurnEnd::Turn;
    Eigen::Vector3d m_began = Eigen::Vector3d::Zero();
};

}  // namespace leitstand
