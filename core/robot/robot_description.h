#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "core/base/pose.h"
#include "core/robot/scanner_correction.h"
#include "core/robot/streams/qos.h"

namespace leitstand {

enum class StreamRole : std::uint8_t;

/// Clock from which the stamps of commands are taken; Zero: stamps are zero.
enum class StampSource : std::uint8_t { Robot, Zero, Station };
[[nodiscard]] std::string toString(StampSource source);

/// Converts raw numbers of a thermal picture to temperatures: kelvin = raw * scale + offset.
struct ThermalScale {
    double scale = 0.01;   ///< [K] a step
    double offset = 0.0;   ///< [K]
    bool measured = true;  ///< false: colour-mapped pictures without temperatures
    friend bool operator==(const ThermalScale&, const ThermalScale&) = default;
};

/// One topic of a robot.
struct StreamDescription {
    StreamRole role{};
    std::string sensor;  ///< key in RobotDescription::sensors of its sensor, "left"; may be empty
    std::string topic;   ///< ROS name, "/kurt3d/points"
    std::string type;    ///< "sensor_msgs/msg/PointCloud2"
    Qos qos;
    StampSource stamp = StampSource::Robot;  ///< of stamped commands
    ThermalScale thermal;                    ///< of Thermal
    std::string hardwareId;  ///< for Diagnostics: its statuses have a hardware_id that begins so
    bool record = true;      ///< whether the mission's log keeps it
    bool maps = false;       ///< for Points and Ranges: of several scanners, this one makes the map
    friend bool operator==(const StreamDescription&, const StreamDescription&) = default;
};

/// How a laser scanner is moved.
enum class SensorMotion : std::uint8_t { Unknown, Fixed, Turning, Tilting };
[[nodiscard]] std::string toString(SensorMotion motion);

/// The pan-tilt unit of a camera, and its range.
struct PanTiltMount {
    std::string unit;                             ///< of its joints UNIT_pan and UNIT_tilt, "left"
    double pan = degrees(90);                     ///< greatest pan to each side [rad]
    double up = degrees(45), down = degrees(45);  ///< greatest tilt [rad]
    friend bool operator==(const PanTiltMount&, const PanTiltMount&) = default;
};

/// A sensor and its mount.
struct SensorDescription {
    std::string frame = {};                       ///< frame_id of its samples
    Pose sensorInBase = Pose::Identity();         ///< used where tf has no such transform
    SensorMotion motion = SensorMotion::Unknown;  ///< decides what a simulated robot carries
    std::optional<PanTiltMount> panTilt = {};     ///< of a camera that can turn
    ScannerCorrection correction = {};            ///< of a 3D scanner
};

enum class DriveType : std::uint8_t { Differential, Tracked, Omnidirectional };
[[nodiscard]] std::string toString(DriveType drive);

/// What a robot does by itself when its link is lost (docs/design.md, "The wire").
enum class LinkLossRule : std::uint8_t { Stop, FinishAndWait, ReturnToLink };
[[nodiscard]] std::string toString(LinkLossRule rule);

/// What distinguishes the tf frames of a robot from those of others: a topic of its own, a prefix in their
/// names, nothing.
enum class TfPrefix : std::uint8_t { Topic, Frame, None };
[[nodiscard]] std::string toString(TfPrefix prefix);

/// Everything that the station knows about a robot beforehand: the content of its file.
struct RobotDescription {
    std::string file = {};  ///< file that it was read from; empty: no file
    std::string letter;     ///< one capital letter, "K"
    std::string name;       ///< "kurt3d": lower case, as in topics
    std::string title;      ///< name for the operator, "Kurt3D"
    std::vector<StreamDescription> streams;
    std::map<std::string, SensorDescription> sensors;
    std::string baseFrame, odomFrame;
    TfPrefix tfPrefix = TfPrefix::Topic;
    std::vector<Eigen::Vector2d> footprint;  ///< counter-clockwise, base frame [m]
    double height = 0.0;                     ///< [m]
    double maxRoll = 0.0, maxPitch = 0.0;    ///< tip-over limits [rad]
    double maxSpeed = 0.0;                   ///< [m/s]
    double maxTurnRate = 0.0;                ///< [rad/s]
    double maxClimb = 0.0;                   ///< steepest ramp [rad]; 0: not given, the usual one
    double maxStep = 0.0;                    ///< highest step [m]; 0: not given, the usual one
    /// Whether the map estimates the motion within a turn of the scanner, since the odometry is poor.
    bool refineTurns = false;
    DriveType drive = DriveType::Differential;
    std::map<std::string, std::string> bindings;   ///< operator's action -> key or pad control
    std::map<std::string, LinkLossRule> linkLoss;  ///< mode -> rule; teleoperation always stops

    /// The first stream of @p role (and @p sensor, when given); null when the robot has none.
    [[nodiscard]] const StreamDescription* stream(StreamRole role, const std::string& sensor = {}) const;
    /// The clouds that make the map: the only ones, or those with StreamDescription::maps; null: there are
    /// none, or several and none is chosen.
    [[nodiscard]] const StreamDescription* mappingStream() const;
};

}  // namespace leitstand
