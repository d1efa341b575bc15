#pragma once

#include <vector>

class QPainter;

namespace leitstand {

class MapProjection;
struct OverlayStyle;
struct RobotMark;

/// Paints where robots have been: one line each, whose dashes tell the robot, and whose letter stands where
/// it began.
void paintTrails(QPainter& painter, const MapProjection& projection, const std::vector<RobotMark>& robots,
                 const OverlayStyle& style);

/// Paints robots with their attitude and letter, farthest first, on top of everything: an operator has to see
/// them through walls too. Far away they become arrows. Robots in doubt are dashed, in a ring as large as the
/// doubt; goals are targets at the end of a dashed line.
void paintRobots(QPainter& painter, const MapProjection& projection, const std::vector<RobotMark>& robots,
                 const OverlayStyle& style);

/// Paints @p robot as it would stand: planned, dashed.
void paintPlanned(QPainter& painter, const MapProjection& projection, const RobotMark& robot,
                  const OverlayStyle& style);

}  // namespace leitstand
