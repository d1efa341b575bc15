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

/// When an incomplete turn of the scanner ends.
struct TurnSettings {
    double leastTurn = degrees(180);  ///< shorter interrupted turns are dropped; 0: none is dropped [rad]
    /// The turn ends when the sensor has moved farther than this [m] ...
    double longestWay = std::numeric_limits<double>::infinity();
    double mostTurned = std::numeric_limits<double>::infinity();  ///< ... or turned more than this [rad]
    /// A turn is interrupted if it takes longer than this and is also slower than slowestTurn for 360
    /// degrees. Then the drive is stuck, or the window is covered.
    std::chrono::nanoseconds longestTime = std::chrono::seconds(10);
    std::chrono::nanoseconds slowestTurn = std::chrono::seconds(30);
};

/// Why a scan ended.
enum class TurnEnd : std::uint8_t {
    Turn,      ///< the scanner saw all directions
    Sweep,     ///< the cloud was a whole sweep
    Distance,  ///< the robot moved farther than TurnSettings allow
    Break,     ///< no more slices arrived, or they do not continue the turn
};

/// Assembles scans from the clouds of a 3D scanner. A cloud that is a whole sweep is a scan by itself. Slices
/// of a yawing scanner (organised; rows are vertical raw scans; design section 4) are gathered to a turn of
/// 360 degrees, which may begin anywhere. The sensor's motion is removed: each point is moved to where it
/// would be seen from the pose at the last shot. One thread at a time.
class TurnAssembler {
public:
    explicit TurnAssembler(const TurnSettings& settings = {}) : m_settings(settings) {}

    /// Adds @p cloud. @p track returns the sensor's pose; where it is unknown, the sensor is assumed to be at
    /// rest. Returns a scan, without name and robot, when one is complete.
    [[nodiscard]] std::optional<Scan> add(CloudSample cloud, const SensorTrack& track);
    /// As above, for a sensor that did not move during @p cloud.
    [[nodiscard]] std::optional<Scan> add(CloudSample cloud, const std::optional<Pose>& sensorInOdom) {
        return add(std::move(cloud), [&](Time) { return sensorInOdom; });
    }
    /// Returns the slices of an incomplete turn as a scan, if the settings accept it.
    [[nodiscard]] std::optional<Scan> finish();
    /// Returns why the last scan ended.
    [[nodiscard]] TurnEnd ended() const { return m_ended; }
    /// Returns where the sensor was when the first slice of the last scan ended, in that scan's frame [m];
    /// zero: unknown.
    [[nodiscard]] const Eigen::Vector3d& began() const { return m_began; }
    [[nodiscard]] bool gathers() const { return !m_slices.empty(); }

private:
    struct Slice {
        CloudSample cloud;                 ///< its points as seen from the pose at its last shot
        std::optional<Pose> sensorInOdom;  ///< pose at its last shot
    };
    [[nodiscard]] std::optional<Scan> take(TurnEnd end);
    [[nodiscard]] bool continues(const CloudSample& cloud) const;
    /// Returns whether the turn takes too long if @p cloud is added.
    [[nodiscard]] bool takesTooLong(const CloudSample& cloud) const;
    [[nodiscard]] bool movedTooFar() const;
    void gather(CloudSample cloud, const std::optional<Pose>& sensorInOdom);
    void forget();

    TurnSettings m_settings;
    std::vector<Slice> m_slices;
    double m_turned = 0.0;                ///< angle of the gathered raw scans [rad]
    int m_rows = 0;                       ///< number of gathered raw scans that have a heading
    std::optional<double> m_lastHeading;  ///< heading of the last raw scan [rad]
    double m_way = 0.0;                   ///< how far the sensor moved since the first gathered slice [m]
    double m_rotated = 0.0;               ///< how far the sensor rotated since the first gathered slice [rad]
    TurnEnd m_ended = TurnEnd::Turn;
    Eigen::Vector3d m_began = Eigen::Vector3d::Zero();
};

}  // namespace leitstand
