#include "widgets/map_view/map_overlay.h"

#include <algorithm>

#include <QStringList>

#include "widgets/map_view/overlays/hint.h"
#include "widgets/map_view/overlays/legend.h"
#include "widgets/map_view/overlays/map_marks.h"
#include "widgets/map_view/overlays/scale_overlays.h"
#include "widgets/map_view/overlays/scan_outlines.h"
#include "widgets/map_view/robots/drawing_overlay.h"
#include "widgets/map_view/robots/robot_overlay.h"
#include "widgets/map_view/victims/victim_overlay.h"

namespace leitstand {

void MapOverlay::paint(QPainter& painter, const MapProjection& projection, const SceneContent& content,
                       const OverlayStyle& style) {
    if (content.scans.empty() && robots.empty()) return;
    painter.setRenderHint(QPainter::Antialiasing);
    double gridStep = 0.0;
    if (content.settings.look == MapLook::Top) {
        gridStep = paintGroundGrid(painter, projection, content, style);
    }
    floor.paint(painter, projection, style);
    grid.paint(painter, projection, style);
    paintScanOutlines(painter, projection, content, style);
    const bool trails = std::any_of(robots.begin(), robots.end(), [](const auto& one) { return one.trail; });
    paintScanPositions(painter, projection, content, !trails, style);
    paintLinks(painter, projection, content, links, style);
    if (highlighted != 0) paintHighlight(painter, projection, content, highlighted, style);
    paintArea(painter, projection, area, ground, style);
    paintTrails(painter, projection, robots, style);
    paintPlans(painter, projection, robots, style);
    paintDrawings(painter, projection, robots, style);
    paintRobots(painter, projection, robots, style);
    paintVictims(painter, projection, finds, chosenFind, style);
    tools.paint(painter, projection, style);
    if (content.settings.follow == MapFollow::Free) {
        for (const MapCaption& caption : captions)
            paintCaption(painter, projection, caption.places, caption.text, style);
    }
    if (seam) paintMeasurement(painter, projection, seam->from, seam->to, style);
    if (const auto from = ruler.from(content))
        paintMeasurement(painter, projection, *from, ruler.to(content), style);
    const QRect scaleBar = paintScaleBar(painter, projection, gridStep, style);
    QRect legend = paintLegend(painter, content, projection.size(), scaleBar, style);
    if (floor.tint()) legend = paintFloorLegend(painter, *floor.tint(), projection.size(), legend, style);
    if (grid.grid()) paintGridLegend(painter, *grid.grid(), projection.size(), legend, style);
    paintAxes(painter, projection, style);
    if (!hint.isEmpty()) paintHint(painter, hint, projection.size(), style);
}

const RobotMark* MapOverlay::robotAt(const QPointF& position, const MapProjection& projection) const {
    constexpr double Near = 24.0;  // of the robot's middle, from floor to top [pixels]
    for (const RobotMark& robot : robots) {
        const auto floor = projection.project(robot.baseInMap.translation());
        const auto top = projection.project(robot.baseInMap * Eigen::Vector3d(0, 0, robot.height));
        if (!floor || !top) continue;
        // Its letter stands above it.
        const QRectF about =
            QRectF(floor->position, top->position).normalized().adjusted(-Near, -2 * Near, Near, Near);
        if (about.contains(position)) return &robot;
    }
    return nullptr;
}

QString MapOverlay::description() const {
    QStringList lines = {hint, detailsOf(robots)};
    lines.removeAll(QString());
    return lines.join(QLatin1Char('\n'));
}

}  // namespace leitstand
