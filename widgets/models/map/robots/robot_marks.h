#pragma once

#include <optional>

#include "core/mapping/live/robot_in_map.h"
#include "core/station/robot_view.h"
#include "widgets/models/map/robots/robot_mark.h"

namespace leitstand {

/// Returns how @p robot is drawn at @p place; empty: its place is unknown. @p goalInMap: where it was sent.
[[nodiscard]] std::optional<RobotMark> robotMarkOf(const RobotFace& face, const RobotDescription& robot,
                                                   const RobotInMap& place, const LinkStatus& link,
                                                   bool selected, const std::optional<Pose>& goalInMap = {});

/// Draws @p mark with @p body, its joints as @p view has them. Null: as a symbol.
void setBody(RobotMark& mark, ModelBodyPtr body, const RobotView& view);

/// Returns how certain the places of all @p marks are, one per line.
[[nodiscard]] QString detailsOf(const std::vector<RobotMark>& marks);

/// Whether @p a and @p b look the same.
[[nodiscard]] bool sameMark(const RobotMark& a, const RobotMark& b);

/// Returns a text that says that the robots @p unplaced are not in the map yet; empty when there are none.
/// @p placeKeys: keys that place a robot; may be empty.
[[nodiscard]] QString unplacedText(const std::vector<RobotFace>& unplaced, const QString& placeKeys);

}  // namespace leitstand
