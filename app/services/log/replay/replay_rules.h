#pragma once

#include <string>
#include <string_view>

namespace leitstand {

/// Whether a replay may publish a topic. Sensors and states may be published. What moves a robot or speaks
/// for a station may not: commands, goals, stops, pings, and the stations' own topics (docs/design.md,
/// "Command lines"). Decides by name and by type, so that a drive command under another name is held back
/// too.
[[nodiscard]] bool isReplayable(std::string_view topic, std::string_view type);

/// Returns the robot that a topic belongs to: "/kurt3d/odom" -> "kurt3d"; empty for topics without a
/// namespace.
[[nodiscard]] std::string robotOfTopic(std::string_view topic);

}  // namespace leitstand
