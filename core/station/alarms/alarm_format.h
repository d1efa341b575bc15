#pragma once

/// Texts of alarms in the log, in English, after the robot's title and ": ". "{}" stands for a figure or for
/// the alarm's note. Views use their own words for all of it, by key.
namespace leitstand::alarm_format {

inline constexpr const char* LinkLost = "link lost, silent for {} s";
inline constexpr const char* LinkDegraded = "link: {}";
inline constexpr const char* NotReceived = "not heard: {}";
inline constexpr const char* RolledOver = "rolled over, tilted by {} degrees";
inline constexpr const char* Tilted = "roll {}, pitch {} degrees: {} % of where it tips over";
inline constexpr const char* BatteryShare = "battery {} %";
inline constexpr const char* BatteryMinutes = "battery, {} min left";
inline constexpr const char* BatteryBoth = "battery {} %, {} min left";
inline constexpr const char* Gas = "CO2 {} ppm";
inline constexpr const char* WheelsSpin = "its wheels turned for {} m, the map says it stands";
inline constexpr const char* Bumped = "bumped: {}";
inline constexpr const char* Part = "{}: {}";  ///< detail and note
inline constexpr const char* Frozen = "camera {} repeats one picture for {} s";
inline constexpr const char* ClockAhead = "its clock is {} s ahead of the station's";
inline constexpr const char* ClockBehind = "its clock is {} s behind the station's";
inline constexpr const char* StopUnanswered = "does not answer the stop for {} s";
inline constexpr const char* GrantLost = "the grant to drive was lost to {}";
inline constexpr const char* UncertainScan = "{} uncertain scan to be decided on";
inline constexpr const char* UncertainScans = "{} uncertain scans to be decided on";

}  // namespace leitstand::alarm_format
