#pragma once

#include <optional>
#include <string>

#include "app/services/places/frame_tracks.h"
#include "core/event/event.h"
#include "core/mapping/live/robot_tracker.h"
#include "core/robot/robot_description.h"

namespace leitstand {

/// When a sample was taken: by the robot's clock where it says so, else when it came.
[[nodiscard]] Time stampOf(const Event& event, const SampleHeader& header);

/// Where a sensor was at a time.
struct SensorPlace {
    Pose sensorInBase, baseInOdom;
    std::optional<Pose> baseInMap;  ///< empty where nobody knows
    bool certain = false;           ///< of the robot's place in the map, now

    [[nodiscard]] Pose sensorInOdom() const { return baseInOdom * sensorInBase; }
};

/// Tells where one robot's sensors were at times of the near past: by its transforms and its odometry, and by
/// who tells where it is in the map. Without thread; one at a time.
class SensorPlaces {
public:
    /// @p robot must outlive it.
    explicit SensorPlaces(const RobotDescription& robot) : m_frames(robot), m_tracker(robot.name) {}
    SensorPlaces(const SensorPlaces&) = delete;
    SensorPlaces& operator=(const SensorPlaces&) = delete;

    /// Odometry, inertial unit and transforms of this robot; others are passed by.
    void onEvent(const Event& event);
    /// Where the robot was; until the first nothing has a place in the map.
    void correct(const MapFix& fix);
    void lose();  ///< nobody knows where the robot is

    /// Whether the odometry of that time has come.
    [[nodiscard]] bool covers(Time stamp) const { return m_tracker.motion().covers(stamp); }
    /// Where frame @p frame of @p sensor was; empty where transforms or odometry do not know.
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
    std::optional<MapFix> m_fix;  ///< that waits for odometry
};

}  // namespace leitstand
