#pragma once

#include <map>
#include <optional>
#include <string>

#include "app/services/places/sensor_poses.h"
#include "core/base/pose.h"
#include "core/base/time.h"
#include "core/cloud/pose_track.h"
#include "core/event/event.h"
#include "core/robot/robot_description.h"

namespace leitstand {

/// Where a robot's sensors sat in its base at a time of the near past: frames that turn, as those of cameras
/// on pan-tilt units, with their history.
class FrameTracks {
public:
    static constexpr std::chrono::seconds Memory{10};

    explicit FrameTracks(const RobotDescription& robot) : m_robot(&robot), m_fixed(robot) {}

    void add(const Event& event);  ///< transforms and odometry; others are passed by
    /// Pose of @p frame of @p sensor in the robot's base at @p stamp: by tf, else by the robot's file, which
    /// does not know where a unit is turned to. Empty where tf has a gap then.
    [[nodiscard]] std::optional<Pose> inBase(const std::string& sensor, const std::string& frame, Time stamp);

private:
    struct Track {
        std::string parent;
        PoseTrack poses;
    };
    const RobotDescription* m_robot;
    SensorPoses m_fixed;
    std::map<std::string, Track> m_turning;  ///< by child frame
    std::string m_base;                      ///< as the odometry names it
};

}  // namespace leitstand
