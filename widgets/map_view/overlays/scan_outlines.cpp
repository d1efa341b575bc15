#include "widgets/map_view/overlays/scan_outlines.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

#include <QPainter>
#include <QPolygonF>
#include <opencv2/imgproc.hpp>

#include "widgets/map_view/camera/map_camera.h"
#include "widgets/map_view/overlays/overlay_style.h"
#include "widgets/map_view/scene/scene_content.h"

namespace leitstand {
namespace {

/// The hull of what is seen of @p scan; empty where less than a triangle is.
QPolygonF outlineOf(const SceneScan& scan, const SceneContent& content, const MapProjection& projection) {
    std::vector<cv::Point2f> seen;
    bool whole = true;
    const auto add = [&](std::size_t i) {
        const auto at = projection.project(scan.poseInMap * scan.points->sample(i).cast<double>());
        if (at) seen.emplace_back(float(at->position.x()), float(at->position.y()));
        whole = whole && at;
    };
    const bool withCeiling = content.settings.withCeiling();
    for (const std::uint16_t i : scan.points->outermost) add(i);
    if (withCeiling) {
        for (const std::uint16_t i : scan.points->outermostOfCeiling) add(i);
    }
    // Where one looks from amidst it, what lies outermost of what is ahead is not what lies outermost at all.
    for (std::size_t i = 0; !whole && i < std::min(ScanPoints::Sampled, scan.points->points.size()); ++i) {
        if (withCeiling || scan.points->labelOfSample(i) != Label::Ceiling) add(i);
    }
    if (seen.size() < 3) return {};
    std::vector<cv::Point2f> hull;
    cv::convexHull(seen, hull);
    QPolygonF outline;
    for (const cv::Point2f& corner : hull) outline.append(QPointF(corner.x, corner.y));
    return outline;
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
