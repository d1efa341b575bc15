#pragma once

#include <string>
#include <string_view>

namespace leitstand {

/// Whether a replay may publish a topic. Sensors and states may be published. What moves a robot or speaks
/// for a station may not: commands, goals, stops, pings, and the stations' own topics (docs/design.md,
/// "Command lines"). Name and type decide, so that a drive command under another name is not published
/// either.
[[nodiscard]] bool isReplayable(std::string_view topic, std::string_view type);

/// Returns the robot to which a topic belongs: "/kurt3d/odom" -> "kurt3d"; empty for topics without a
/// namespace.
[[nodiscard]] std::string robotOfTopic(std::string_view topic);

}  // namespace leitstand
