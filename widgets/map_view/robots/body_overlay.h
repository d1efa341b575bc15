#pragma once

class QPainter;

namespace leitstand {

class MapProjection;
struct OverlayStyle;
struct RobotMark;

/// How a body is painted.
struct BodyLook {
    double opacity = 1.0;  ///< 0 to 1; less than 1 for a robot whose place is uncertain
    bool grey = false;     ///< whether its colours are left out, as for a robot that is not heard
};

/// Paints the surface of @p robot by its model, with shading, and hidden parts hidden. Nothing of the map
/// hides it. On the ground its footprint and an arrow ahead show the robot's colour and heading. Returns
/// false, and paints nothing, if the robot has no model, is partly behind the eye, or would take too long.
[[nodiscard]] bool paintModel(QPainter& painter, const MapProjection& projection, const RobotMark& robot,
                              const BodyLook& look, const OverlayStyle& style);

}  // namespace leitstand
