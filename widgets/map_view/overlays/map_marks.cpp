#include "widgets/map_view/overlays/map_marks.h"

#include <algorithm>
#include <cmath>

#include <QCoreApplication>
#include <QFontMetrics>
#include <QPainter>

#include "widgets/map_view/map_camera.h"
#include "widgets/map_view/overlays/overlay_style.h"
#include "widgets/map_view/scene/scene_content.h"

namespace leitstand {
namespace {

constexpr double ScanMarkSize = 9.0, MeasureMarkRadius = 4.0;  ///< [px]

/// The part of the first scan's floor plane that a parallel view from above shows.
Eigen::AlignedBox2d shownGround(const MapProjection& projection, const Pose& mapInScan) {
    Eigen::AlignedBox2d shown;
    const QSize size = projection.size();
    for (const QPointF corner : {QPointF(0, 0), QPointF(size.width(), 0), QPointF(0, size.height()),
                                 QPointF(size.width(), size.height())}) {
        const Eigen::Vector3d inMap = projection.unproject(corner, projection.focusDepth());
        shown.extend(Eigen::Vector2d((mapInScan * inMap).head<2>()));
    }
    return shown;
}

/// Only the position and heading of @p pose: the grid stays level.
Pose levelled(const Pose& pose) {
    const Eigen::Vector3d ahead = pose.linear().col(0);
    return poseFrom(pose.translation(), 0.0, 0.0, std::atan2(ahead.y(), ahead.x()));
}

QString measurementText(const Eigen::Vector3d& from, const Eigen::Vector3d& to, const QLocale& locale) {
    const Eigen::Vector3d step = to - from;
    const auto number = [&locale](double value) { return numberText(value, 2, locale); };
    return QCoreApplication::translate("leitstand::MapView", "%1 m  dx %2 dy %3 dz %4",
                                       "length of a measurement and its parts along the map's axes")
        .arg(number(step.norm()), number(step.x()), number(step.y()), number(step.z()));
}

void paintTextBeside(QPainter& painter, const QPointF& place, const QString& text, QSize size,
                     const OverlayStyle& style) {
    painter.setFont(style.font);
    const QFontMetrics metrics = painter.fontMetrics();
    QRectF box(place, QSizeF(metrics.horizontalAdvance(text) + 16, metrics.height() + 8));
    box.moveLeft(std::clamp(box.left(), 4.0, std::max(4.0, size.width() - box.width() - 4)));
    box.moveTop(std::clamp(box.top(), 4.0, std::max(4.0, size.height() - box.height() - 4)));
    paintPanel(painter, box, style);
    painter.setPen(asColour(style.colours.text));
    painter.drawText(box, Qt::AlignCenter, text);
}

}  // namespace

double paintGroundGrid(QPainter& painter, const MapProjection& projection, const SceneContent& content,
                       const OverlayStyle& style) {
    constexpr double ClosestLines = 6.0;  // [px]
    const Pose scanInMap = content.scans.empty() ? Pose::Identity() : levelled(content.scans[0].poseInMap);
    const double metresPerPixel = projection.metresPerPixel(projection.focusDepth());
    double step = 1.0;
    while (step < ClosestLines * metresPerPixel) step *= 10.0;
    const Eigen::AlignedBox2d shown = shownGround(projection, scanInMap.inverse());
    const auto onScreen = [&](double x, double y) {
        const double height = projection.camera().focus.z();
        const Eigen::Vector3d inMap = scanInMap * Eigen::Vector3d(x, y, height - scanInMap.translation().z());
        return projection.project(inMap).value_or(Projected{}).position;
    };
    painter.setPen(QPen(asColour(style.colours.grid), 1.0));
    for (double x = std::ceil(shown.min().x() / step) * step; x <= shown.max().x(); x += step) {
        painter.drawLine(onScreen(x, shown.min().y()), onScreen(x, shown.max().y()));
    }
    for (double y = std::ceil(shown.min().y() / step) * step; y <= shown.max().y(); y += step) {
        painter.drawLine(onScreen(shown.min().x(), y), onScreen(shown.max().x(), y));
    }
    return step;
}

void paintScanPositions(QPainter& painter, const MapProjection& projection, const SceneContent& content,
                        const OverlayStyle& style) {
    std::vector<std::optional<QPointF>> places;
    for (const SceneScan& scan : content.scans) {
        if (!scan.visible) continue;
        const auto seen = projection.project(scan.poseInMap.translation());
        places.push_back(seen ? std::optional(seen->position) : std::nullopt);
    }
    painter.setPen(QPen(asColour(style.colours.trail), 1.5));
    for (std::size_t i = 1; i < places.size(); ++i) {
        if (places[i - 1] && places[i]) painter.drawLine(*places[i - 1], *places[i]);
    }
    painter.setPen(
        QPen(asColour(style.colours.markerEdge), 1.5, Qt::SolidLine, Qt::SquareCap, Qt::MiterJoin));
    painter.setBrush(asColour(style.colours.scanPosition));
    for (const auto& place : places) {
        if (!place) continue;
        painter.drawRect(
            QRectF(*place - QPointF(ScanMarkSize, ScanMarkSize) / 2, QSizeF(ScanMarkSize, ScanMarkSize)));
    }
}

void paintMeasurement(QPainter& painter, const MapProjection& projection, const Eigen::Vector3d& from,
                      const std::optional<Eigen::Vector3d>& to, const OverlayStyle& style) {
    const auto start = projection.project(from);
    const auto end = to ? projection.project(*to) : std::nullopt;
    if (start && end) {
        // A dark line below a light one is seen on every colour of the map.
        painter.setPen(QPen(asColour(style.colours.background), 4.0));
        painter.drawLine(start->position, end->position);
        painter.setPen(QPen(asColour(style.colours.measurement), 2.0));
        painter.drawLine(start->position, end->position);
    }
    painter.setPen(QPen(asColour(style.colours.background), 1.5));
    painter.setBrush(asColour(style.colours.measurement));
    for (const auto& mark : {start, end}) {
        if (mark) painter.drawEllipse(mark->position, MeasureMarkRadius, MeasureMarkRadius);
    }
    if (start && end) {
        const QPointF middle = (start->position + end->position) / 2;
        paintTextBeside(painter, middle + QPointF(12, 10), measurementText(from, *to, style.locale),
                        projection.size(), style);
    }
}

}  // namespace leitstand
