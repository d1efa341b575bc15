#pragma once

#include <map>
#include <optional>
#include <set>
#include <string>
#include <utility>

#include "core/cloud/pose_track.h"
#include "core/robot/robot_description.h"

namespace leitstand {

struct SampleHeader;
struct Event;

/// Where a robot's sensors were, from its odometry, its tf_static and its file.
class SensorPoses {
public:
    explicit SensorPoses(const RobotDescription& robot) : m_robot(&robot) {}

    /// Takes odometry and transforms; ignores other events.
    void add(const Event& event);
    /// Returns the pose of the sensor that made the sample of @p event, in the odometry's frame at @p stamp.
    /// Empty when there is no odometry near that time. A sensor with an unknown place is assumed to be at the
    /// robot's base; remarks() reports this.
    [[nodiscard]] std::optional<Pose> sensorInOdom(const Event& event, const SampleHeader& header,
                                                   Time stamp);
    /// Returns the pose of @p frame of @p sensor in the robot's base, from its transforms, or if they lack
    /// it, from its file. Otherwise returns the base itself, which remarks() reports.
    [[nodiscard]] Pose inBase(const std::string& sensor, const std::string& frame);
    /// Sets the correction of @p sensor from now on. If the robot's file has no such sensor, the correction
    /// is for the sensor with @p frame.
    void setCorrection(const std::string& sensor, const std::string& frame,
                       const ScannerCorrection& correction);
    /// Whether @p frame can belong to a sensor itself. If data is in the frame of the base or of the
    /// odometry, the sensor's place is unknown.
    [[nodiscard]] bool isOfScanner(const std::string& frame) const;
    /// Returns the correction that was set last; if none was, that of the robot's file. Its lean is already
    /// in inBase(). No correction if isOfScanner() is false.
    [[nodiscard]] ScannerCorrection correctionOf(const std::string& sensor, const std::string& frame) const;
    /// Returns the parent of a frame in the transforms received so far, and the frame's pose in it; empty:
    /// unknown.
    [[nodiscard]] std::optional<std::pair<std::string, Pose>> parentOf(const std::string& frame) const;
    [[nodiscard]] std::optional<Pose> baseInOdom(Time stamp) const { return m_baseInOdom.at(stamp); }
    void forgetBefore(Time stamp) { m_baseInOdom.forgetBefore(stamp); }  ///< drops older odometry
    /// Whether the place of @p frame of @p sensor is known: by transforms, by the robot's file, or because
    /// the frame is that of the base or of the odometry.
    [[nodiscard]] bool isPlaced(const std::string& sensor, const std::string& frame) const;
    /// What was missing; each remark is listed once.
    [[nodiscard]] const std::set<std::string>& remarks() const { return m_remarks; }

private:
    struct Parent {
        std::string frame;
        Pose childInParent = Pose::Identity();
    };
    [[nodiscard]] std::optional<Pose> inBaseByTransforms(const std::string& frame) const;
    /// Returns the name of the sensor in the robot's file; empty: the file has no such sensor.
    [[nodiscard]] std::string nameOf(const std::string& sensor, const std::string& frame) const;
    [[nodiscard]] Pose describedInBase(const std::string& sensor, const std::string& frame);

    const RobotDescription* m_robot;
    PoseTrack m_baseInOdom;
    std::string m_baseFrame;                                 ///< name of the base frame in the odometry
    std::map<std::string, Parent> m_parents;                 ///< by child frame
    std::map<std::string, ScannerCorrection> m_corrections;  ///< set by setCorrection(), by sensor
    std::set<std::string> m_remarks;
};

}  // namespace leitstand
