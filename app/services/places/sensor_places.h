#pragma once

#include <optional>
#include <string>

#include "app/services/places/frame_tracks.h"
#include "core/mapping/live/robot_tracker.h"
#include "core/robot/robot_description.h"

namespace leitstand {

struct SampleHeader;
struct Event;

/// Returns when a sample was taken: its stamp on the robot's clock, or if it has none, when it was received.
[[nodiscard]] Time stampOf(const Event& event, const SampleHeader& header);

/// Where a sensor was at a time.
struct SensorPlace {
    Pose sensorInBase, baseInOdom;
    std::optional<Pose> baseInMap;  ///< empty: unknown
    bool certain = false;           ///< whether the robot's place in the map is certain now

    [[nodiscard]] Pose sensorInOdom() const { return baseInOdom * sensorInBase; }
};

/// Finds where a robot's sensors were in the recent past, from its transforms and odometry, and from fixes of
/// its place in the map. It has no thread; one call at a time.
class SensorPlaces {
public:
    /// @p robot must outlive this object.
    explicit SensorPlaces(const RobotDescription& robot) : m_frames(robot), m_tracker(robot.name) {}
    SensorPlaces(const SensorPlaces&) = delete;
    SensorPlaces& operator=(const SensorPlaces&) = delete;

    /// Takes odometry, inertial unit and transforms of this robot; ignores other events.
    void onEvent(const Event& event);
    /// Sets where the robot was. Before the first call, nothing has a place in the map.
    void correct(const MapFix& fix);
    void lose();  ///< call when the robot's place is unknown

    /// Whether odometry up to @p stamp was received.
    [[nodiscard]] bool covers(Time stamp) const { return m_tracker.motion().covers(stamp); }
    /// Returns where @p frame of @p sensor was; empty where transforms or odometry have a gap.
    [[nodiscard]] std::optional<SensorPlace> at(const std::string& sensor, const std::string& frame,
                                                Time stamp);
    /// Implements FrameTracks::inBase().
    [[nodiscard]] std::optional<Pose> inBase(const std::string& sensor, const std::string& frame,
                                             Time stamp) {
        return m_frames.inBase(sensor, frame, stamp);
    }
    [[nodiscard]] std::optional<Pose> baseInOdom(Time stamp) const;  ///< empty: no odometry for that time
    [[nodiscard]] std::optional<Pose> baseInMap(Time stamp) const { return m_tracker.baseInMap(stamp); }
    [[nodiscard]] const RobotInMap& now() const { return m_tracker.now(); }

private:
    void follow();

    FrameTracks m_frames;
    RobotTracker m_tracker;
    std::optional<MapFix> m_fix;  ///< fix that waits for odometry
};

}  // namespace leitstand
