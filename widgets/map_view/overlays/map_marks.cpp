#include "widgets/map_view/overlays/map_marks.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <string>

#include <QCoreApplication>
#include <QFontMetrics>
#include <QPainter>
#include <QPixmap>

#include "core/base/rotation/heading.h"
#include "core/mapping/live/trail.h"
#include "widgets/map_view/camera/map_camera.h"
#include "widgets/map_view/overlays/overlay_style.h"
#include "widgets/map_view/overlays/painted_cells.h"
#include "widgets/map_view/scene/scene_content.h"

namespace leitstand {
namespace {

constexpr double ScanMarkSize = 9.0, CrowdedMarkSize = 5.0, MeasureMarkRadius = 4.0;  ///< [px]
constexpr double DiamondSize = 9.0, HighlightRadius = 15.0;                           ///< [px]
constexpr double SamePlace = 4.0;        ///< of two marks closer than this, one is painted [px]
constexpr std::size_t CrowdedFrom = 20;  ///< scans

/// Returns the part of the first scan's floor plane that a parallel view from above shows.
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

/// Whether the robot's path from one scan to the next is known. It counts as known for scans of files, which
/// have no times.
bool knowsWay(const SceneScan& from, const SceneScan& to) {
    if (from.entered == Time{} || to.entered == Time{}) return true;
    return !isGap(distanceBetween(from.poseInMap, to.poseInMap), to.entered - from.entered);
}

/// Returns @p pose with its position and heading only: the grid stays level.
Pose levelled(const Pose& pose) {
    return poseFrom(pose.translation(), 0.0, 0.0, headingOf(pose));
}

QString measurementText(const Eigen::Vector3d& from, const Eigen::Vector3d& to, const QLocale& locale) {
    const Eigen::Vector3d step = to - from;
    const auto number = [&locale](double value) { return numberText(value, 2, locale); };
    return QCoreApplication::translate("leitstand::MapView", "%1 m  dx %2 m dy %3 m dz %4 m",
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

void paintUncertainPosition(QPainter& painter, const QPointF& at, const OverlayStyle& style) {
    painter.setPen(QPen(asColour(style.colours.uncertainScan), 1.8));
    painter.setBrush(asColour(style.colours.panel));
    painter.drawPolygon(QPolygonF({at + QPointF(0, -DiamondSize), at + QPointF(DiamondSize, 0),
                                   at + QPointF(0, DiamondSize), at + QPointF(-DiamondSize, 0)}));
    QFont font = style.font;
    font.setPixelSize(11);
    font.setBold(true);
    painter.setFont(font);
    painter.drawText(QRectF(at - QPointF(8, 8), QSizeF(16, 16)), Qt::AlignCenter, QStringLiteral("?"));
}

/// Returns a mark of width and height @p side [px], painted once for all that look the same.
template <class Paint>
QPixmap markOf(double side, double pixelRatio, Paint paint) {
    const int pixels = static_cast<int>(std::ceil(side * pixelRatio));
    QPixmap pixmap(pixels, pixels);
    pixmap.setDevicePixelRatio(pixelRatio);
    pixmap.fill(Qt::transparent);
    QPainter painter(&pixmap);
    painter.setRenderHint(QPainter::Antialiasing);
    paint(painter, QPointF(pixels, pixels) / pixelRatio / 2.0);
    return pixmap;
}

void paintCertainPosition(QPainter& painter, const QPointF& at, double size, const OverlayStyle& style) {
    painter.setPen(
        QPen(asColour(style.colours.markerEdge), 1.5, Qt::SolidLine, Qt::SquareCap, Qt::MiterJoin));
    painter.setBrush(asColour(style.colours.scanPosition));
    painter.drawRect(QRectF(at - QPointF(size, size) / 2, QSizeF(size, size)));
}

/// Paints @p mark around @p at.
void paintMark(QPainter& painter, const QPointF& at, const QPixmap& mark) {
    painter.drawPixmap(at - QPointF(mark.width(), mark.height()) / mark.devicePixelRatio() / 2.0, mark);
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
                        bool joined, const OverlayStyle& style) {
    struct Mark {
        const SceneScan* scan;
        QPointF at;
    };
    std::vector<Mark> marks;
    for (const SceneScan& scan : content.scans) {
        if (!scan.visible) continue;
        const auto seen = projection.project(scan.poseInMap.translation());
        if (seen) marks.push_back({&scan, seen->position});
    }
    if (joined) {
        painter.setPen(QPen(asColour(style.colours.trail), 1.5));
        std::map<std::string, Mark> last;  // by robot
        for (const Mark& mark : marks) {
            const auto [before, first] = last.try_emplace(mark.scan->robot, mark);
            if (!first && knowsWay(*before->second.scan, *mark.scan))
                painter.drawLine(before->second.at, mark.at);
            before->second = mark;
        }
    }
    // Many marks are painted small, so that they do not hide the map.
    const double size = marks.size() > CrowdedFrom ? CrowdedMarkSize : ScanMarkSize;
    constexpr double Edge = 4.0;  // room for it [px]
    const double ratio = painter.device()->devicePixelRatioF();
    const QPixmap square = markOf(size + Edge, ratio, [&](QPainter& mark, const QPointF& middle) {
        paintCertainPosition(mark, middle, size, style);
    });
    const QPixmap diamond =
        markOf(2.0 * DiamondSize + Edge, ratio,
               [&](QPainter& mark, const QPointF& middle) { paintUncertainPosition(mark, middle, style); });
    PaintedCells certain(projection.size(), SamePlace), uncertain(projection.size(), SamePlace);
    for (const Mark& mark : marks) {
        if (!mark.scan->uncertain && certain.take(mark.at)) paintMark(painter, mark.at, square);
    }
    for (const Mark& mark : marks) {
        if (mark.scan->uncertain && uncertain.take(mark.at)) paintMark(painter, mark.at, diamond);
    }
}

void paintHighlight(QPainter& painter, const MapProjection& projection, const SceneContent& content,
                    std::uint64_t id, const OverlayStyle& style) {
    for (const SceneScan& scan : content.scans) {
        if (scan.id != id || !scan.visible) continue;
        const auto seen = projection.project(scan.poseInMap.translation());
        if (!seen) return;
        painter.setBrush(Qt::NoBrush);
        const Rgba colour = scan.uncertain ? style.colours.scanInQuestion : style.colours.measurement;
        for (const QPen& pen : {QPen(asColour(style.colours.background), 5.0), QPen(asColour(colour), 2.5)}) {
            painter.setPen(pen);
            painter.drawEllipse(seen->position, HighlightRadius, HighlightRadius);
        }
        const QString text = QCoreApplication::translate("leitstand::MapView", "scan %1").arg(id);
        paintTextBeside(painter, seen->position + QPointF(HighlightRadius + 4, -10), text, projection.size(),
                        style);
    }
}

void paintCaption(QPainter& painter, const MapProjection& projection, std::span<const Eigen::Vector3d> places,
                  const QString& text, const OverlayStyle& style) {
    constexpr double Above = 70.0;  // clears the walls around the scans [px]
    std::optional<QPointF> highest;
    for (const Eigen::Vector3d& place : places) {
        const auto seen = projection.project(place);
        if (seen && (!highest || seen->position.y() < highest->y())) highest = seen->position;
    }
    if (!highest || !QRectF(QPointF(), projection.size()).contains(*highest)) return;
    painter.setFont(style.font);
    const QPointF aside(painter.fontMetrics().horizontalAdvance(text) / 2.0, Above);
    paintTextBeside(painter, *highest - aside, text, projection.size(), style);
}

void paintMeasurement(QPainter& painter, const MapProjection& projection, const Eigen::Vector3d& from,
                      const std::optional<Eigen::Vector3d>& to, const OverlayStyle& style) {
    const auto start = projection.project(from);
    const auto end = to ? projection.project(*to) : std::nullopt;
    if (start && end) {
        // A dark line below a light one is visible on every map colour.
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
