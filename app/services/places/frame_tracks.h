#pragma once

#include <map>
#include <optional>
#include <string>

#include "app/services/places/sensor_poses.h"
#include "core/base/pose.h"
#include "core/base/time.h"
#include "core/cloud/pose_track.h"
#include "core/robot/robot_description.h"

namespace leitstand {

struct Event;

/// Where a robot's sensors were in its base in the recent past. Keeps the history of frames that turn, such
/// as those of cameras on pan-tilt units.
class FrameTracks {
public:
    static constexpr std::chrono::seconds Memory{10};

    explicit FrameTracks(const RobotDescription& robot) : m_robot(&robot), m_fixed(robot) {}

    void add(const Event& event);  ///< takes transforms and odometry; ignores other events
    /// Returns the pose of @p frame, which belongs to @p sensor, in the robot's base at @p stamp. Uses tf,
    /// otherwise the robot's file, which does not know how a pan-tilt unit is turned. Empty where tf has a
    /// gap.
    [[nodiscard]] std::optional<Pose> inBase(const std::string& sensor, const std::string& frame, Time stamp);

private:
    struct Track {
        std::string parent;
        PoseTrack poses;
    };
    const RobotDescription* m_robot;
    SensorPoses m_fixed;
    std::map<std::string, Track> m_turning;  ///< by child frame
    std::string m_base;                      ///< name of the base frame in the odometry
};

}  // namespace leitstand
