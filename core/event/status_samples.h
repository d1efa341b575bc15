#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include <Eigen/Core>

#include "core/base/unknown.h"
#include "core/event/sample_header.h"

namespace leitstand {

/// Concentration of a gas (leitstand_msgs/msg/GasConcentration, or std_msgs/msg/Float32 without stamp and
/// name).
struct GasSample {
    SampleHeader header;
    std::string gas = "co2";
    double ppm = 0.0;  ///< parts per million by volume
};

/// Numbers from a message of any type: those of StreamDescription::readings, in that order.
struct ReadingSample {
    SampleHeader header;  ///< epoch and no frame if the message has no header
    /// In ReadingDescription::unit; Unknown if the message does not tell. A distance that is infinite is out
    /// of reach, or too near if it is negative (REP 117).
    std::vector<double> values;
};

/// The model of a robot as URDF (robot_description, std_msgs/msg/String).
struct RobotModelSample {
    static constexpr std::size_t MostBytes = 2'000'000;
    std::string urdf;
};

/// State of a battery (sensor_msgs/msg/BatteryState). Numbers are Unknown if they are not measured.
struct BatterySample {
    enum class Status : std::uint8_t { Unknown, Charging, Discharging, NotCharging, Full };
    SampleHeader header;
    double voltage = Unknown;      ///< [V]
    double current = Unknown;      ///< negative when discharging [A]
    double charge = Unknown;       ///< remaining charge [Ah]
    double capacity = Unknown;     ///< charge when it was last full [Ah]
    double fraction = Unknown;     ///< remaining share of the charge, 0 to 1
    double temperature = Unknown;  ///< [degrees C]
    Status status = Status::Unknown;
    bool present = true;
    std::string location;  ///< where it is mounted
};

/// State that one part of a robot reports about itself.
struct DiagnosticStatus {
    enum class Level : std::uint8_t { Ok, Warning, Error, Stale };
    Level level = Level::Ok;
    std::string name, message, hardwareId;
    std::vector<std::pair<std::string, std::string>> values;  ///< pairs of key and value
};

/// diagnostic_msgs/msg/DiagnosticArray, with only the statuses of this robot.
struct DiagnosticsSample {
    SampleHeader header;
    std::vector<DiagnosticStatus> statuses;
};

/// What a robot is doing, sent at each change.
struct ModeSample {
    SampleHeader header;
    std::string mode;                    ///< "teleoperation", "explore": a key of RobotDescription::linkLoss
    bool autonomous = false;             ///< whether it drives by itself
    std::string reason;                  ///< why it changed; may be empty
    std::vector<std::string> available;  ///< modes that may be requested
};

/// State of one bumper.
struct Bumper {
    std::string name;        ///< "front_left"
    bool pressed = false;    ///< whether it is pressed now
    std::uint32_t hits = 0;  ///< number of hits since the robot started
};

/// All bumpers of a robot, sent at each change.
struct BumpSample {
    SampleHeader header;
    std::vector<Bumper> bumpers;
};

/// Something that a robot itself believes it has found.
struct Sighting {
    std::uint32_t id = 0;  ///< does not change for the same find
    std::string kind;      ///< "victim", "heat", "motion", "sound", "co2", "code", "hazard"
    Eigen::Vector3d position = Eigen::Vector3d::Zero();  ///< in the header's frame [m]
    double deviation = Unknown;                          ///< standard deviation of the position [m]
    double confidence = Unknown;                         ///< 0 to 1
    double value = Unknown;                              ///< for heat [degrees C], for co2 [ppm]
    std::string text;                                    ///< content of a code; may be empty
};

/// All present sightings of a robot, sent at each change.
struct SightingSample {
    SampleHeader header;
    std::vector<Sighting> sightings;
};

/// A robot's answer to StopCommandSample.
struct StopStateSample {
    SampleHeader header;
    std::uint64_t number = 0;  ///< number of the newest stop or release that the robot answered
    std::string station;       ///< station that sent it; empty: the robot's own stop button
    bool stopped = false;      ///< whether a stop is in force: the robot obeys no drive command
    bool standing = false;     ///< whether the robot stands, from its odometry
    std::string refused;       ///< why the release was refused; empty: it was not
    std::uint64_t stops = 0;   ///< increases with every stop that the robot obeys; a release must name it
};

/// A robot's answer to PingSample.
struct PongSample {
    std::uint64_t number = 0;  ///< number of the ping
    std::string station;       ///< station that sent the ping
    Time sent{};               ///< when the station sent the ping, station's clock
    Time received{};           ///< when the robot received it, robot's clock
    Time replied{};            ///< when the robot replied, robot's clock
};

}  // namespace leitstand
