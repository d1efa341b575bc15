#pragma once

#include <optional>
#include <string>

#include "app/services/places/frame_tracks.h"
#include "core/mapping/live/robot_tracker.h"
#include "core/robot/robot_description.h"

namespace leitstand {

struct SampleHeader;
struct Event;

/// Returns when a sample was taken: by its stamp on the robot's clock, else when it was received.
[[nodiscard]] Time stampOf(const Event& event, const SampleHeader& header);

/// Where a sensor was at a time.
struct SensorPlace {
    Pose sensorInBase, baseInOdom;
    std::optional<Pose> baseInMap;  ///< empty when unknown
    bool certain = false;           ///< whether the robot's place in the map is certain now

    [[nodiscard]] Pose sensorInOdom() const { return baseInOdom * sensorInBase; }
};

/// Finds where one robot's sensors were in the recent past, by its transforms and odometry, and by fixes of
/// its place in the map. Has no thread; one call at a time.
class SensorPlaces {
public:
    /// @p robot must outlive it.
    explicit SensorPlaces(const RobotDescription& robot) : m_frames(robot), m_tracker(robot.name) {}
    SensorPlaces(const SensorPlaces&) = delete;
    SensorPlaces& operator=(const SensorPlaces&) = delete;

    /// Takes odometry, inertial unit and transforms of this robot; ignores others.
    void onEvent(const Event& event);
    /// Sets where the robot was; nothing has a place in the map before the first call.
    void correct(const MapFix& fix);
    void lose();  ///< the robot's place is unknown

    /// Whether the odometry of @p stamp has come.
    [[nodiscard]] bool covers(Time stamp) const { return m_tracker.motion().covers(stamp); }
    /// Returns where frame @p frame of @p sensor was; empty where transforms or odometry have a gap.
    [[nodiscard]] std::optional<SensorPlace> at(const std::string& sensor, const std::string& frame,
                                                Time stamp);
    /// As of FrameTracks.
    [[nodiscard]] std::optional<Pose> inBase(const std::string& sensor, const std::string& frame,
                                             Time stamp) {
        return m_frames.inBase(sensor, frame, stamp);
    }
    [[nodiscard]] std::optional<Pose> baseInOdom(Time stamp) const;  ///< empty: no odometry of that time
    [[nodiscard]] std::optional<Pose> baseInMap(Time stamp) const { return m_tracker.baseInMap(stamp); }
    [[nodiscard]] const RobotInMap& now() const { return m_tracker.now(); }

private:
    void follow();

    FrameTracks m_frames;
    RobotTracker m_tracker;
    std::optional<MapFix> m_fix;  ///< waits for odometry
};

}  // namespace leitstand
