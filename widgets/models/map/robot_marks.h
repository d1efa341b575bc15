#pragma once

#include <optional>

#include "core/mapping/live/robot_in_map.h"
#include "core/station/robot_view.h"
#include "widgets/models/map/robot_mark.h"

namespace leitstand {

/// How @p robot is drawn where @p place says it is; empty while nobody knows. @p goalInMap: where it was
/// sent.
[[nodiscard]] std::optional<RobotMark> robotMarkOf(const RobotFace& face, const RobotDescription& robot,
                                                   const RobotInMap& place, const LinkStatus& link,
                                                   bool selected, const std::optional<Pose>& goalInMap = {});

/// How sure the places of all @p marks are, a line each.
[[nodiscard]] QString detailsOf(const std::vector<RobotMark>& marks);

/// Whether both are drawn alike.
[[nodiscard]] bool sameMark(const RobotMark& a, const RobotMark& b);

/// What is to be said of robots that are not in the map yet; empty: all are. @p placeKeys: that place one.
[[nodiscard]] QString unplacedText(const std::vector<RobotFace>& unplaced, const QString& placeKeys);

}  // namespace leitstand
