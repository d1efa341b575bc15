#include "widgets/map_view/overlays/scan_outlines.h"

#include <algorithm>
#include <cstddef>
#include <vector>

#include <QPainter>
#include <QPolygonF>

#include "widgets/map_view/camera/map_camera.h"
#include "widgets/map_view/overlays/overlay_style.h"
#include "widgets/map_view/scene/scene_content.h"

namespace leitstand {
namespace {

constexpr std::size_t MostPoints = 600;  ///< random sample: single points far outside are mostly left out

/// Returns the side of the line from @p a to @p b on which @p point lies, by its sign.
double sideOf(const QPointF& a, const QPointF& b, const QPointF& point) {
    return (b.x() - a.x()) * (point.y() - a.y()) - (b.y() - a.y()) * (point.x() - a.x());
}

/// Returns the convex hull of @p points (Andrew 1979).
QPolygonF hullOf(std::vector<QPointF> points) {
    std::sort(points.begin(), points.end(), [](const QPointF& a, const QPointF& b) {
        return a.x() < b.x() || (a.x() == b.x() && a.y() < b.y());
    });
    QPolygonF hull;
    const auto addChain = [&hull](auto from, auto to) {
        const auto begin = hull.size();
        for (auto point = from; point != to; ++point) {
            while (hull.size() >= begin + 2 && sideOf(hull[hull.size() - 2], hull.back(), *point) <= 0.0)
                hull.removeLast();
            hull.append(*point);
        }
        hull.removeLast();  // the other chain begins with it
    };
    if (points.size() < 3) return {};
    addChain(points.begin(), points.end());
    addChain(points.rbegin(), points.rend());
    return hull;
}

QPolygonF outlineOf(const SceneScan& scan, const SceneContent& content, const MapProjection& projection) {
    std::vector<QPointF> seen;
    const std::size_t count = std::min(MostPoints, scan.points->points.size());
    for (std::size_t i = 0; i < count; ++i) {
        if (scan.points->labelOfSample(i) == Label::Ceiling && !content.withCeiling()) continue;
        const auto at = projection.project(scan.poseInMap * scan.points->sample(i).cast<double>());
        if (at) seen.push_back(at->position);
    }
    return hullOf(std::move(seen));
}

}  // namespace

void paintScanOutlines(QPainter& painter, const MapProjection& projection, const SceneContent& content,
                       const OverlayStyle& style) {
    painter.setBrush(Qt::NoBrush);
    for (const SceneScan& scan : content.scans) {
        if (!scan.uncertain || !scan.visible || !scan.points) continue;
        const bool inQuestion = scan.id == content.inQuestion;
        if (content.inQuestion != 0 && !inQuestion) continue;  // all else is dimmed
        const QPolygonF outline = outlineOf(scan, content, projection);
        const Rgba colour = inQuestion ? style.colours.scanInQuestion : style.colours.uncertainScan;
        painter.setPen(QPen(asColour(style.colours.background), inQuestion ? 5.0 : 3.5));
        painter.drawPolygon(outline);
        painter.setPen(
            QPen(asColour(colour), inQuestion ? 2.5 : 1.5, inQuestion ? Qt::SolidLine : Qt::DashLine));
        painter.drawPolygon(outline);
    }
}

}  // namespace leitstand
