#pragma once

#include <vector>

class QPainter;

namespace leitstand {

class MapProjection;
struct OverlayStyle;
struct RobotMark;

/// Paints where robots have been: one line each, with the robot's dash pattern and its letter at the start.
void paintTrails(QPainter& painter, const MapProjection& projection, const std::vector<RobotMark>& robots,
                 const OverlayStyle& style);

/// Paints where robots plan to go: their paths, in the robots' colours.
void paintPlans(QPainter& painter, const MapProjection& projection, const std::vector<RobotMark>& robots,
                const OverlayStyle& style);

/// Paints robots with attitude and letter, farthest first, on top of everything, so that the operator also
/// sees them through walls. Distant robots become arrows. Robots with an uncertain position are dashed,
/// inside a ring as large as the uncertainty. Robots not heard lately are dashed and grey. Goals are targets
/// at the end of a dashed line.
void paintRobots(QPainter& painter, const MapProjection& projection, const std::vector<RobotMark>& robots,
                 const OverlayStyle& style);

/// Paints @p robot dashed at a planned pose.
void paintPlanned(QPainter& painter, const MapProjection& projection, const RobotMark& robot,
                  const OverlayStyle& style);

}  // namespace leitstand
