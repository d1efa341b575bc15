#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "core/base/pose.h"
#include "core/robot/joints/joint_group.h"
#include "core/robot/readings/reading_description.h"
#include "core/robot/scanner_correction.h"
#include "core/robot/services/service_description.h"
#include "core/robot/streams/qos.h"

namespace leitstand {

enum class StreamRole : std::uint8_t;

/// Which clock the stamps of commands come from; Zero: stamps are zero.
enum class StampSource : std::uint8_t { Robot, Zero, Station };
[[nodiscard]] std::string toString(StampSource source);

/// Converts raw numbers of a thermal picture to temperatures: kelvin = raw * scale + offset.
struct ThermalScale {
    double scale = 0.01;   ///< kelvin per step of the raw number
    double offset = 0.0;   ///< kelvin at raw number 0
    bool measured = true;  ///< false: the pictures show colours instead of temperatures
    friend bool operator==(const ThermalScale&, const ThermalScale&) = default;
};

/// One topic of a robot.
struct StreamDescription {
    StreamRole role{};
    std::string sensor;  ///< its sensor, as a key of RobotDescription::sensors, "left"; may be empty
    std::string topic;   ///< ROS name, "/kurt3d/points"
    std::string type;    ///< "sensor_msgs/msg/PointCloud2"
    Qos qos;
    StampSource stamp = StampSource::Robot;  ///< for commands that have a stamp
    std::string group;                       ///< for JointCommand: name of its JointGroup
    ThermalScale thermal;                    ///< for Thermal
    /// For Diagnostics: statuses whose hardware_id begins with this belong to the robot.
    std::string hardwareId;
    bool record = true;  ///< whether the mission's log stores it
    /// For Points and Ranges: if there are several scanners, this one makes the map.
    bool maps = false;
    std::vector<ReadingDescription> readings = {};  ///< for Reading: the numbers that are shown
    friend bool operator==(const StreamDescription&, const StreamDescription&) = default;
};

/// How a laser scanner is moved.
enum class SensorMotion : std::uint8_t { Unknown, Fixed, Turning, Tilting };
[[nodiscard]] std::string toString(SensorMotion motion);

/// The pan-tilt unit of a camera, and its range.
struct PanTiltMount {
    std::string unit;          ///< name of the unit; its joints are UNIT_pan and UNIT_tilt; "left"
    double pan = degrees(90);  ///< largest pan to each side [rad]
    double up = degrees(45), down = degrees(45);  ///< largest tilt up and down [rad]
    friend bool operator==(const PanTiltMount&, const PanTiltMount&) = default;
};

/// A sensor and how it is mounted.
struct SensorDescription {
    std::string frame = {};                       ///< frame_id of its samples
    Pose sensorInBase = Pose::Identity();         ///< used when tf has no such transform
    SensorMotion motion = SensorMotion::Unknown;  ///< determines which scanner a simulated robot has
    std::optional<PanTiltMount> panTilt = {};     ///< for a camera that can turn
    ScannerCorrection correction = {};            ///< for a 3D scanner
};

enum class DriveType : std::uint8_t { Differential, Tracked, Omnidirectional };
[[nodiscard]] std::string toString(DriveType drive);

/// What a robot does by itself when its link is lost (docs/design.md, "The wire").
enum class LinkLossRule : std::uint8_t { Stop, FinishAndWait, ReturnToLink };
[[nodiscard]] std::string toString(LinkLossRule rule);

/// How the tf frames of a robot are distinguished from those of other robots: by a topic of their own, by a
/// prefix in their names, or not at all.
enum class TfPrefix : std::uint8_t { Topic, Frame, None };
[[nodiscard]] std::string toString(TfPrefix prefix);

/// All that the station knows about a robot in advance: the content of its file.
struct RobotDescription {
    std::string file = {};  ///< file from which it was read; empty: none
    std::string letter;     ///< a capital letter, "K"
    std::string name;       ///< "kurt3d": lower case, as in topics
    std::string title;      ///< name for the operator, "Kurt3D"
    std::vector<StreamDescription> streams;
    std::vector<ServiceDescription> services;
    std::vector<JointGroup> jointGroups;
    std::map<std::string, SensorDescription> sensors;
    std::string baseFrame, odomFrame;
    TfPrefix tfPrefix = TfPrefix::Topic;
    std::vector<Eigen::Vector2d> footprint;  ///< outline of the robot, counter-clockwise, base frame [m]
    double height = 0.0;                     ///< [m]
    double maxRoll = 0.0, maxPitch = 0.0;    ///< tip-over limits [rad]
    double maxSpeed = 0.0;                   ///< [m/s]
    double maxTurnRate = 0.0;                ///< [rad/s]
    double maxClimb = 0.0;                   ///< steepest ramp [rad]; 0: not given, a usual value is used
    double maxStep = 0.0;                    ///< highest step [m]; 0: not given, a usual value is used
    /// Folders of ROS packages ("FOLDER/husky_description/meshes/base.dae"), which have the meshes of the
    /// robot's model. readRobot() makes them absolute; in its file they count from the file's folder.
    std::vector<std::string> packages;
    /// Whether mapping estimates the motion within a turn of the scanner, because the odometry is poor.
    bool refineTurns = false;
    DriveType drive = DriveType::Differential;
    std::map<std::string, std::string> bindings;   ///< operator's action -> key or pad control
    std::map<std::string, LinkLossRule> linkLoss;  ///< mode -> rule; teleoperation always stops

    /// The first stream with @p role (and @p sensor, if given); null when the robot has none.
    [[nodiscard]] const StreamDescription* stream(StreamRole role, const std::string& sensor = {}) const;
    /// The stream by which @p group is commanded; null: there is none.
    [[nodiscard]] const StreamDescription* commandsOf(const JointGroup& group) const;
    /// The action by which the robot's own navigation takes goals; null: its file names none.
    [[nodiscard]] const ServiceDescription* navigation() const;
    /// Whether the robot can be sent to a place, by its navigation or by a topic.
    [[nodiscard]] bool takesGoals() const;
    /// Whether the map may be made from @p one: clouds, or turns of a plane laser if the robot has odometry.
    [[nodiscard]] bool mayMap(const StreamDescription& one) const;
    /// The stream that makes the map: the one with StreamDescription::maps, or the only cloud if there is no
    /// plane laser beside it; null: none is chosen. A robot without clouds maps by planeScanner().
    [[nodiscard]] const StreamDescription* mappingStream() const;
};

}  // namespace leitstand
