#include "widgets/map_view/robots/robot_overlay.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include <QFontMetricsF>
#include <QPainter>
#include <QVector>

#include "widgets/map_view/camera/map_camera.h"
#include "widgets/map_view/overlays/overlay_style.h"
#include "widgets/map_view/overlays/painted_cells.h"
#include "widgets/map_view/robots/body_overlay.h"
#include "widgets/map_view/robots/robot_shape.h"
#include "widgets/models/map/robots/robot_mark.h"
#include "widgets/painting/pane_paint.h"

namespace leitstand {
namespace {

constexpr double SmallestBody = 13.0;  ///< half a body's length on screen; smaller robots become arrows [px]
constexpr double ArrowSize = 11.0, BadgeSize = 18.0, TargetSize = 9.0;  ///< [px]
constexpr double NumberSize = 9.0;  ///< radius of a waypoint's number [px]
constexpr double FaintBody = 0.45;  ///< opacity of a model whose place is uncertain
constexpr double GoalAhead = 0.45;  ///< length of a goal's heading [m]

std::optional<QPointF> seen(const MapProjection& projection, const Eigen::Vector3d& pointInMap) {
    const auto projected = projection.project(pointInMap);
    if (!projected) return std::nullopt;
    return projected->position;
}

std::optional<QPolygonF> seen(const MapProjection& projection, const Pose& pose,
                              const std::vector<Eigen::Vector3d>& corners) {
    QPolygonF polygon;
    for (const Eigen::Vector3d& corner : corners) {
        const auto at = seen(projection, pose * corner);
        if (!at) return std::nullopt;
        polygon << *at;
    }
    return polygon;
}

QColor colourOf(const RobotMark& robot, const OverlayStyle& style) {
    const QColor colour = style.window->robot(robot.face.place);
    return robot.stale ? greyed(colour) : colour;
}

QColor facetColour(const RobotFacet& facet, const QColor& robot, const OverlayStyle& style) {
    switch (facet.part) {
        case RobotPart::Gear:
            return QColor(0x2A, 0x2F, 0x38).lighter(static_cast<int>(100 * facet.light + 30));
        case RobotPart::Mast:
            return QColor(0xB8, 0xC0, 0xCC).darker(static_cast<int>(100 / facet.light));
        case RobotPart::Arrow:
            return asColour(style.colours.background);
        case RobotPart::Body:
            break;
    }
    return robot.darker(static_cast<int>(100 / std::clamp(facet.light, 0.3, 1.0)));
}

void paintBody(QPainter& painter, const MapProjection& projection, const RobotMark& robot, bool dashed,
               const OverlayStyle& style) {
    struct Seen {
        QPolygonF outline;
        double depth;
        RobotFacet facet;
    };
    const Eigen::Vector3d eye = projection.camera().eye();
    std::vector<Seen> facets;
    for (RobotFacet& facet : robotFacets(robot)) {
        const Eigen::Vector3d outward = robot.baseInMap.linear() * facet.outward;
        if (outward.dot(robot.baseInMap * facet.corners.front() - eye) >= 0.0) continue;
        const auto outline = seen(projection, robot.baseInMap, facet.corners);
        if (!outline) continue;
        Eigen::Vector3d middle = Eigen::Vector3d::Zero();
        for (const Eigen::Vector3d& corner : facet.corners)
            middle += corner / static_cast<double>(facet.corners.size());
        const double nearer = facet.part == RobotPart::Arrow ? 0.02 : 0.0;
        const double depth = (robot.baseInMap * middle - eye).dot(projection.camera().forward()) - nearer;
        facets.push_back({*outline, depth, std::move(facet)});
    }
    std::sort(facets.begin(), facets.end(), [](const Seen& a, const Seen& b) { return a.depth > b.depth; });
    const QColor colour = colourOf(robot, style);
    for (const Seen& one : facets) {
        QColor fill = facetColour(one.facet, colour, style);
        if (dashed) fill.setAlpha(one.facet.part == RobotPart::Arrow ? 200 : 60);
        painter.setBrush(fill);
        painter.setPen(dashed ? QPen(colour, 1.3, Qt::DashLine) : QPen(fill.darker(130), 0.8));
        painter.drawPolygon(one.outline);
    }
}

/// Returns half of the body's length on screen [px].
double sizeOnScreen(const MapProjection& projection, const RobotMark& robot) {
    const auto at = projection.project(robot.baseInMap.translation());
    if (!at) return 0.0;
    double half = 0.2;
    for (const Eigen::Vector2d& corner : robot.footprint) half = std::max(half, corner.x());
    return half / projection.metresPerPixel(at->depth);
}

void paintArrow(QPainter& painter, const MapProjection& projection, const RobotMark& robot, bool dashed,
                const OverlayStyle& style) {
    const auto at = seen(projection, robot.baseInMap.translation());
    const auto ahead = seen(projection, robot.baseInMap * Eigen::Vector3d(0.3, 0, 0));
    if (!at || !ahead) return;
    painter.save();
    painter.translate(*at);
    painter.rotate(qRadiansToDegrees(std::atan2(ahead->y() - at->y(), ahead->x() - at->x())));
    QColor fill = colourOf(robot, style);
    painter.setPen(QPen(asColour(style.colours.markerEdge), 1.5, dashed ? Qt::DashLine : Qt::SolidLine));
    if (dashed) fill.setAlpha(60);
    painter.setBrush(fill);
    painter.drawPolygon(QPolygonF({{ArrowSize, 0.0},
                                   {-0.8 * ArrowSize, 0.75 * ArrowSize},
                                   {-0.4 * ArrowSize, 0.0},
                                   {-0.8 * ArrowSize, -0.75 * ArrowSize}}));
    painter.restore();
}

void paintDoubt(QPainter& painter, const MapProjection& projection, const RobotMark& robot,
                const OverlayStyle& style) {
    constexpr int Corners = 48;
    std::vector<Eigen::Vector3d> ring;
    for (int i = 0; i < Corners; ++i) {
        const double angle = degrees(360.0 * i / Corners);
        ring.emplace_back(*robot.doubtRadius * Eigen::Vector3d(std::cos(angle), std::sin(angle), 0.0));
    }
    Pose level = Pose::Identity();
    level.translation() = robot.baseInMap.translation();
    const auto outline = seen(projection, level, ring);
    if (!outline) return;
    painter.setBrush(Qt::NoBrush);
    painter.setPen(QPen(asColour(style.colours.uncertain), 1.6, Qt::DashLine));
    painter.drawPolygon(*outline);
}

void paintBadge(QPainter& painter, const MapProjection& projection, const RobotMark& robot, double lift,
                const OverlayStyle& style) {
    auto top = seen(projection, robot.baseInMap * Eigen::Vector3d(0, 0, robot.height));
    if (!top) return;
    // Above the whole body, so that its arrow stays visible from above.
    for (const Eigen::Vector2d& corner : robot.footprint) {
        const auto at = seen(projection, robot.baseInMap * Eigen::Vector3d(corner.x(), corner.y(), 0.0));
        if (at) top->setY(std::min(top->y(), at->y()));
    }
    const QRectF badge(*top - QPointF(BadgeSize / 2, BadgeSize + lift), QSizeF(BadgeSize, BadgeSize));
    painter.setPen(robot.selected ? QPen(asColour(style.colours.text), 2.0) : QPen(Qt::NoPen));
    painter.setBrush(colourOf(robot, style));
    painter.drawRoundedRect(badge, 4, 4);
    painter.setFont(sized(style.font, 12, true));
    painter.setPen(style.window->window);
    painter.drawText(badge, Qt::AlignCenter, robot.face.letter);
    if (robot.note.isEmpty()) return;
    painter.setFont(sized(style.font, 12));
    constexpr double Apart = 4.0;
    QRectF box(badge.right() + Apart, badge.top(),
               QFontMetricsF(painter.font()).horizontalAdvance(robot.note) + 12, BadgeSize);
    if (box.right() > projection.size().width()) box.moveRight(badge.left() - Apart);
    paintPanel(painter, box, style);
    painter.setPen(toneColour(robot.tone, *style.window));
    painter.drawText(box, Qt::AlignCenter, robot.note);
}

void paintGoal(QPainter& painter, const MapProjection& projection, const RobotMark& robot,
               const OverlayStyle& style) {
    const auto at = seen(projection, robot.goalInMap->translation());
    const auto ahead = seen(projection, *robot.goalInMap * Eigen::Vector3d(GoalAhead, 0, 0));
    const auto from = seen(projection, robot.baseInMap.translation());
    if (!at || !ahead) return;
    const QColor colour = colourOf(robot, style);
    painter.setBrush(Qt::NoBrush);
    // A dark line below makes it visible on every map colour.
    for (const QPen& pen : {QPen(asColour(style.colours.background), 4.0), QPen(colour, 2.0)}) {
        QPen line = pen;
        painter.setPen(line);
        painter.drawEllipse(*at, TargetSize, TargetSize);
        painter.drawLine(*at, *ahead);
        line.setStyle(Qt::DashLine);
        painter.setPen(line);
        if (from) painter.drawLine(*from, *at);
    }
    painter.setBrush(colour);
    painter.setPen(Qt::NoPen);
    painter.drawEllipse(*at, 3.0, 3.0);
}

/// Paints where @p robot goes after its goal: the way from place to place, and each one's number.
void paintWaypoints(QPainter& painter, const MapProjection& projection, const RobotMark& robot,
                    const OverlayStyle& style) {
    if (!robot.goalInMap || robot.waypoints.empty()) return;
    const QColor colour = colourOf(robot, style);
    std::vector<std::optional<QPointF>> places = {seen(projection, robot.goalInMap->translation())};
    for (const Pose& place : robot.waypoints) places.push_back(seen(projection, place.translation()));
    painter.setBrush(Qt::NoBrush);
    for (const QPen& pen : {QPen(asColour(style.colours.background), 4.0), QPen(colour, 2.0)}) {
        QPen line = pen;
        line.setStyle(Qt::DashLine);
        painter.setPen(line);
        for (std::size_t i = 1; i < places.size(); ++i)
            if (places[i - 1] && places[i]) painter.drawLine(*places[i - 1], *places[i]);
    }
    painter.setFont(sized(style.font, 12, true));
    for (std::size_t i = 1; i < places.size(); ++i) {
        if (!places[i]) continue;
        painter.setPen(QPen(asColour(style.colours.background), 1.5));
        painter.setBrush(colour);
        painter.drawEllipse(*places[i], NumberSize, NumberSize);
        painter.setPen(style.window->window);
        const QRectF box(places[i]->x() - NumberSize, places[i]->y() - NumberSize, 2 * NumberSize,
                         2 * NumberSize);
        painter.drawText(box, Qt::AlignCenter, QString::number(i + 1));
    }
}

void paintRobot(QPainter& painter, const MapProjection& projection, const RobotMark& robot, bool dashed,
                const OverlayStyle& style) {
    const double size = sizeOnScreen(projection, robot);
    if (size <= 0.0) return;
    const bool large = size >= SmallestBody;
    const BodyLook look{dashed ? FaintBody : 1.0, robot.stale};
    if (large && paintModel(painter, projection, robot, look, style)) {
        // drawn by its model
    } else if (large) {
        paintBody(painter, projection, robot, dashed, style);
    } else {
        paintArrow(painter, projection, robot, dashed, style);
    }
    paintBadge(painter, projection, robot, large ? 6.0 : ArrowSize, style);
}

/// A dash pattern: lengths drawn and left out [px]. With nothing left out, the line is solid. The pen adds
/// its width to each dash.
struct Dashes {
    double drawn, out;
};

Dashes dashesOf(const RobotMark& robot) {
    switch (robot.face.place % 3) {
        case 0:
            return {1.0, 0.0};
        case 1:
            return {6.0, 6.0};
        default:
            return {0.5, 5.5};
    }
}

/// Adds the dashes of @p line to @p lines. @p along: length of the trail before the line [px].
void addDashed(QVector<QLineF>& lines, const QLineF& line, double along, const Dashes& dashes) {
    const double length = line.length();
    if (dashes.out == 0.0) {
        lines << line;
        return;
    }
    const double period = dashes.drawn + dashes.out;
    for (double dash = std::floor(along / period) * period; dash < along + length; dash += period) {
        const double from = std::max(dash - along, 0.0), to = std::min(dash + dashes.drawn - along, length);
        if (to > from) lines << QLineF(line.pointAt(from / length), line.pointAt(to / length));
    }
}

/// Returns where @p robot has been, on screen. A path driven twice is drawn once. Short lines paint in a
/// fraction of the time of a QPainterPath.
QVector<QLineF> trailOf(const RobotMark& robot, const MapProjection& projection) {
    constexpr double LeastStep = 2.0, Beside = 2.0;  // [px]
    constexpr double Longest = 4000.0;  // longer lines lie mostly outside: they are not dashed [px]
    PaintedCells painted(projection.size(), Beside);
    QVector<QLineF> lines;
    std::optional<QPointF> last;
    double along = 0.0;
    const auto lineTo = [&](const Eigen::Vector3d& place, bool always) {
        const auto at = seen(projection, place);
        if (at && last && !always && (*at - *last).manhattanLength() < LeastStep) return;
        if (at && last) {
            const QLineF line(*last, *at);
            const double length = line.length();
            if (painted.takeLine(*last, *at) || always)
                addDashed(lines, line, along, length < Longest ? dashesOf(robot) : Dashes{1.0, 0.0});
            if (length < Longest) along += length;
        }
        last = at;
    };
    for (const TrailPlace& place : *robot.trail) {
        if (place.afterGap) last.reset();
        lineTo(place.inMap.cast<double>(), false);
    }
    if (!robot.afterGap) lineTo(robot.baseInMap.translation(), true);
    return lines;
}

}  // namespace

void paintTrails(QPainter& painter, const MapProjection& projection, const std::vector<RobotMark>& robots,
                 const OverlayStyle& style) {
    painter.setBrush(Qt::NoBrush);
    for (const RobotMark& robot : robots) {
        if (!robot.trail || robot.trail->empty()) continue;
        painter.setPen(QPen(asColour(style.colours.trail), 2.0, Qt::SolidLine, Qt::SquareCap));
        painter.drawLines(trailOf(robot, projection));
        const auto began = seen(projection, robot.trail->front().inMap.cast<double>());
        if (!began) continue;
        painter.setFont(sized(style.font, 11, true));
        painter.drawText(QRectF(*began + QPointF(-16, 4), QSizeF(14, 14)), Qt::AlignCenter,
                         robot.face.letter);
    }
}

void paintPlans(QPainter& painter, const MapProjection& projection, const std::vector<RobotMark>& robots,
                const OverlayStyle& style) {
    constexpr double LeastStep = 3.0, Width = 2.5, Edge = 5.0;  // [px]
    painter.setBrush(Qt::NoBrush);
    for (const RobotMark& robot : robots) {
        if (!robot.plans) continue;
        for (const std::vector<Eigen::Vector3d>& path : *robot.plans) {
            QVector<QLineF> lines;
            std::optional<QPointF> last;
            for (std::size_t i = 0; i < path.size(); ++i) {
                const auto at = seen(projection, path[i]);
                const bool skipped = at && last && (*at - *last).manhattanLength() < LeastStep;
                if (skipped && i + 1 < path.size()) continue;
                if (at && last) lines << QLineF(*last, *at);
                last = at;
            }
            for (const auto& [colour, width] : {std::pair(asColour(style.colours.markerEdge), Edge),
                                                std::pair(colourOf(robot, style), Width)}) {
                painter.setPen(QPen(colour, width, Qt::SolidLine, Qt::RoundCap));
                painter.drawLines(lines);
            }
        }
    }
}

void paintRobots(QPainter& painter, const MapProjection& projection, const std::vector<RobotMark>& robots,
                 const OverlayStyle& style) {
    std::vector<const RobotMark*> order;
    order.reserve(robots.size());
    for (const RobotMark& robot : robots) order.push_back(&robot);
    const auto depth = [&projection](const RobotMark* robot) {
        return robot->baseInMap.translation().dot(projection.camera().forward());
    };
    std::sort(order.begin(), order.end(),
              [&depth](const RobotMark* a, const RobotMark* b) { return depth(a) > depth(b); });
    for (const RobotMark* robot : order) {
        if (robot->goalInMap) paintGoal(painter, projection, *robot, style);
        paintWaypoints(painter, projection, *robot, style);
        if (robot->doubtRadius) paintDoubt(painter, projection, *robot, style);
    }
    for (const RobotMark* robot : order) {
        paintRobot(painter, projection, *robot, robot->doubtRadius.has_value() || robot->stale, style);
    }
}

void paintPlanned(QPainter& painter, const MapProjection& projection, const RobotMark& robot,
                  const OverlayStyle& style) {
    paintRobot(painter, projection, robot, true, style);
    const auto at = seen(projection, robot.baseInMap.translation());
    const auto ahead = seen(projection, robot.baseInMap * Eigen::Vector3d(2 * GoalAhead, 0, 0));
    if (!at || !ahead) return;
    painter.setPen(QPen(asColour(style.colours.background), 4.0));
    painter.drawLine(*at, *ahead);
    painter.setPen(QPen(colourOf(robot, style), 2.0));
    painter.drawLine(*at, *ahead);
}

}  // namespace leitstand
