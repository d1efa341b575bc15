#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace leitstand::detail {

// The keys of robot files, map by map; docs/robots.md explains them.
inline constexpr std::string_view RobotKeys[] = {
    "letter",  "name",    "title",    "drive",        "frames",   "footprint", "height",       "limits",
    "sensors", "streams", "services", "joint_groups", "bindings", "link_loss", "refine_turns", "packages"};
inline constexpr std::string_view FrameKeys[] = {"base", "odom", "prefix"};
inline constexpr std::string_view LimitKeys[] = {"roll", "pitch", "speed", "turn_rate", "climb", "step"};
inline constexpr std::string_view SensorKeys[] = {"frame",  "position", "rotation",
                                                  "motion", "pan_tilt", "correction"};
inline constexpr std::string_view CorrectionKeys[] = {"range", "roll", "pitch", "x", "y", "yaw", "clock"};
inline constexpr std::string_view PanTiltKeys[] = {"unit", "pan", "up", "down"};
inline constexpr std::string_view StreamKeys[] = {"role",   "sensor", "topic",   "type",
                                                  "qos",    "stamp",  "thermal", "hardware_id",
                                                  "record", "maps",   "group",   "readings"};
inline constexpr std::string_view ReadingKeys[] = {"field",    "title", "unit", "scale",   "offset",
                                                   "decimals", "low",   "high", "low_act", "high_act"};
inline constexpr std::string_view JointGroupKeys[] = {"name",   "title", "command",
                                                      "joints", "axes",  "presets"};
inline constexpr std::string_view JointKeys[] = {"name", "type",     "lower", "upper",
                                                 "rate", "reversed", "link"};
inline constexpr std::string_view JointLinkKeys[] = {"at", "length", "zero", "parent"};
inline constexpr std::string_view JointAxisKeys[] = {"title", "joints"};
inline constexpr std::string_view JointPresetKeys[] = {"title", "positions"};
inline constexpr std::string_view ServiceKeys[] = {"name", "type", "title", "stop"};
inline constexpr std::string_view QosKeys[] = {"reliability", "durability", "depth", "lifespan", "deadline"};
inline constexpr std::string_view ThermalKeys[] = {"scale", "offset", "measured"};

/// Returns all keys of a robot's file with their paths: "name", "frames.base", "sensors.NAME.frame",
/// "streams[].qos.depth".
[[nodiscard]] std::vector<std::string> allRobotKeys();

}  // namespace leitstand::detail
