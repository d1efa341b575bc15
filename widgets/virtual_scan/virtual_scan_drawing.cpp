#include "widgets/virtual_scan/virtual_scan_drawing.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <unordered_map>

#include <QCoreApplication>
#include <QPainterPath>
#include <QPolygonF>

#include "widgets/models/numbers.h"
#include "widgets/painting/pane_paint.h"

namespace leitstand {
namespace {

struct DrawingTexts {
    Q_DECLARE_TR_FUNCTIONS(leitstand::VirtualScanPane)
};

constexpr std::size_t Strengths = 6;

/// Returns the visibility of something of @p age [s]. Strengths: fresh, within a turn of the scanner. It
/// fades to 1, never to 0, which means never seen.
std::size_t strengthOf(double age) {
    constexpr double Fresh = 2.5, Old = 10.0;
    if (!std::isfinite(age)) return 0;
    const double share = std::clamp((Old - age) / (Old - Fresh), 0.0, 1.0);
    return 1 + static_cast<std::size_t>(std::lround(share * (Strengths - 1)));
}

double alphaOf(std::size_t strength) {
    constexpr double Least = 0.25;
    return strength == 0 ? 0.0 : Least + (1.0 - Least) * static_cast<double>(strength - 1) / (Strengths - 1);
}

/// Adds a line to @p path; continues it if it ends at @p from.
void addLine(QPainterPath& path, const QPointF& from, const QPointF& to) {
    if (path.isEmpty() || path.currentPosition() != from) path.moveTo(from);
    path.lineTo(to);
}

/// Whether two outer points, @p apart sectors apart, belong to one wall instead of a near and a far one.
bool isOneWall(const Eigen::Vector2d& a, const Eigen::Vector2d& b, std::size_t apart) {
    return (a - b).norm() < static_cast<double>(apart) * (0.25 + 0.12 * std::min(a.norm(), b.norm()));
}

QString nearestText(const Proximity& nearest) {
    return DrawingTexts::tr("%1 m").arg(numberText(nearest.distance, 2));
}

QFont nearestFont(const QPainter& painter) {
    return sized(painter.font(), 14, true);
}

double ringStep(double range) {
    return range <= 2.5 ? 0.5 : range <= 4.0 ? 1.0 : range <= 10.0 ? 2.0 : 5.0;
}

}  // namespace

VirtualScanDrawing::VirtualScanDrawing(QPainter& painter, const ThemeColours& colours, const QPointF& origin,
                                       double scale, bool grey)
    : m_painter(painter), m_colours(colours), m_origin(origin), m_scale(scale), m_grey(grey) {}

QPointF VirtualScanDrawing::pixelOf(const Eigen::Vector2d& point) const {
    return m_origin - m_scale * QPointF(point.y(), point.x());
}

QColor VirtualScanDrawing::ink(QColor colour, double alpha) const {
    if (m_grey) colour = greyed(colour);
    colour.setAlphaF(static_cast<float>((m_grey ? 0.5 : 1.0) * alpha));
    return colour;
}

void VirtualScanDrawing::rings(const QRectF& area, double range, const QRectF& taken) const {
    const double step = ringStep(range);
    const QFontMetricsF metrics(m_painter.font());
    const double corner = std::hypot(std::max(m_origin.x() - area.left(), area.right() - m_origin.x()),
                                     std::max(m_origin.y() - area.top(), area.bottom() - m_origin.y()));
    for (int i = 1; i * step * m_scale < corner; ++i) {
        const double radius = i * step * m_scale;
        m_painter.setPen(QPen(ink(m_colours.line), 1.0));
        m_painter.setBrush(Qt::NoBrush);
        m_painter.drawEllipse(m_origin, radius, radius);
        const QString text = DrawingTexts::tr("%1 m").arg(numberText(i * step, step < 1.0 ? 1 : 0));
        // to the upper right, clear of the path ahead
        const QPointF at = m_origin + radius * QPointF(std::sin(0.6), -std::cos(0.6));
        const QRectF box(at.x() - 20, at.y() - 0.5 * metrics.height(), 40, metrics.height());
        if (!area.contains(box) || box.intersects(taken)) continue;
        m_painter.setPen(ink(m_colours.muted, 0.85));
        m_painter.drawText(box, Qt::AlignCenter, text);
    }
}

void VirtualScanDrawing::freeSpace(const VirtualScanView& view) const {
    // One wedge per sector, as long as its free space; wedges of one strength are painted together.
    const double half = std::numbers::pi / static_cast<double>(view.sectors.size());
    std::array<QPainterPath, Strengths + 1> wedges;
    for (QPainterPath& path : wedges) path.setFillRule(Qt::WindingFill);
    for (int i = 0; i < static_cast<int>(view.sectors.size()); ++i) {
        const VirtualSector& sector = view.sectors[static_cast<std::size_t>(i)];
        const auto& end = sector.outer ? sector.outer : sector.inner;
        if (!end || !std::isfinite(sector.age)) continue;
        const double direction = view.directionOf(i), length = end->norm();
        QPolygonF wedge;
        wedge << m_origin;
        for (const double side : {-half, half})
            wedge << pixelOf(length *
                             Eigen::Vector2d(std::cos(direction + side), std::sin(direction + side)));
        wedges[strengthOf(sector.age)].addPolygon(wedge);
    }
    m_painter.setRenderHint(QPainter::Antialiasing, false);
    for (std::size_t i = 1; i <= Strengths; ++i)
        m_painter.fillPath(wedges[i], ink(m_colours.wall, 0.11 * alphaOf(i)));
    m_painter.setRenderHint(QPainter::Antialiasing, true);
}

void VirtualScanDrawing::walls(const VirtualScanView& view) const {
    std::array<QPainterPath, Strengths + 1> seen, edges;
    const std::size_t count = view.sectors.size();
    for (std::size_t i = 0; i < count; ++i) {
        const VirtualSector& a = view.sectors[i];
        if (!a.outer) continue;
        // A wall seen at a flat angle skips sectors.
        std::size_t apart = 1;
        while (apart < 3 && !view.sectors[(i + apart) % count].outer) ++apart;
        const VirtualSector& b = view.sectors[(i + apart) % count];
        const std::size_t strength = strengthOf(std::max(a.age, std::isfinite(b.age) ? b.age : 0.0));
        const QPointF from = pixelOf(*a.outer);
        const bool oneWall = b.outer && isOneWall(*a.outer, *b.outer, apart);
        // A single point is a dot. A line between two walls is an edge: nothing was seen there.
        addLine(seen[strength], from, oneWall ? pixelOf(*b.outer) : from + QPointF(1.5, 0.0));
        if (b.outer && !oneWall) addLine(edges[strength], from, pixelOf(*b.outer));
    }
    m_painter.setBrush(Qt::NoBrush);
    for (std::size_t i = 1; i <= Strengths; ++i) {
        m_painter.setPen(QPen(ink(m_colours.wall, 0.35 * alphaOf(i)), 1.0));
        m_painter.drawPath(edges[i]);
        m_painter.setPen(QPen(ink(m_colours.wall, alphaOf(i)), 2.0));
        m_painter.drawPath(seen[i]);
    }
}

void VirtualScanDrawing::obstacles(const VirtualScanView& view) const {
    constexpr int Size = 4;  // [px]
    std::array<QPainterPath, Strengths + 1> lines;
    const std::size_t count = view.sectors.size();
    for (std::size_t i = 0; i < count; ++i) {
        const VirtualSector& a = view.sectors[i];
        const VirtualSector& b = view.sectors[(i + 1) % count];
        if (!a.inner || !b.inner || (*a.inner - *b.inner).norm() > 0.12 + 0.06 * a.inner->norm()) continue;
        if (!standsBeforeWall(view, *a.inner) || !standsBeforeWall(view, *b.inner)) continue;
        addLine(lines[strengthOf(std::max(a.age, b.age))], pixelOf(*a.inner), pixelOf(*b.inner));
    }
    // There may be thousands of points: only the freshest per few pixels is drawn.
    std::unordered_map<std::int64_t, std::size_t> dots;
    const QRectF area = m_painter.clipBoundingRect();
    for (const VirtualObstacle& one : view.obstacles) {
        const QPointF at = pixelOf(one.where) / (Size - 1);
        if (!area.contains(at * (Size - 1)) || !standsBeforeWall(view, one.where)) continue;
        std::size_t& strength = dots[(static_cast<std::int64_t>(std::floor(at.y())) << 32) +
                                     static_cast<std::int64_t>(std::floor(at.x()))];
        strength = std::max(strength, strengthOf(one.age));
    }
    for (const auto& [cell, strength] : dots) {
        const QPointF at((Size - 1) * static_cast<double>(cell & 0xFFFFFFFF),
                         (Size - 1) * static_cast<double>(cell >> 32));
        m_painter.fillRect(QRectF(at, QSizeF(Size, Size)), ink(m_colours.obstacle, alphaOf(strength)));
    }
    m_painter.setBrush(Qt::NoBrush);
    for (std::size_t i = 1; i <= Strengths; ++i) {
        m_painter.setPen(
            QPen(ink(m_colours.obstacle, alphaOf(i)), Size, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
        m_painter.drawPath(lines[i]);
    }
}

void VirtualScanDrawing::surroundings(const VirtualScanView& view, bool withLaser) const {
    if (view.sectors.empty()) return;
    freeSpace(view);
    if (withLaser) laser(view);
    walls(view);
    obstacles(view);
}

void VirtualScanDrawing::laser(const VirtualScanView& view) const {
    constexpr double Dot = 3.0, Solid = 0.5, Gone = 2.0;  // [px], [s]
    const double alpha = std::clamp(1.0 - (view.laserAge - Solid) / (Gone - Solid), 0.0, 1.0);
    if (view.laser.empty() || alpha <= 0.0) return;
    const QColor colour = ink(m_colours.laser, alpha);
    const QRectF area = m_painter.clipBoundingRect();
    for (const Eigen::Vector2f& point : view.laser) {
        const QPointF at = pixelOf(point.cast<double>());
        if (area.contains(at))
            m_painter.fillRect(QRectF(at - QPointF(Dot / 2, Dot / 2), QSizeF(Dot, Dot)), colour);
    }
}

void VirtualScanDrawing::path(const PredictedPath& path) const {
    if (path.isEmpty()) return;
    QPen pen(ink(m_colours.select), 1.5, Qt::CustomDashLine);
    pen.setDashPattern({4, 3});
    m_painter.setPen(pen);
    m_painter.setBrush(Qt::NoBrush);
    for (const auto* edge : {&path.left, &path.right}) {
        QPolygonF line;
        for (const Eigen::Vector2d& point : *edge) line << pixelOf(point);
        m_painter.drawPolyline(line);
    }
    m_painter.setPen(QPen(ink(m_colours.select), 1.5));
    m_painter.drawLine(pixelOf(path.left.back()), pixelOf(path.right.back()));
}

void VirtualScanDrawing::robot(const std::vector<Eigen::Vector2d>& footprint, const BodyBox& body) const {
    QPolygonF outline;
    for (const Eigen::Vector2d& corner : footprint) outline << pixelOf(corner);
    m_painter.setPen(QPen(ink(m_colours.text), 1.5));
    m_painter.setBrush(ink(m_colours.strip));
    m_painter.drawPolygon(outline);
    // An arrow marks its front, even when the body is small on screen.
    const double length = std::max((body.front + body.back) * m_scale, 12.0) / m_scale;
    const double middle = 0.5 * (body.front - body.back);
    QPolygonF arrow;
    arrow << pixelOf({middle + 0.40 * length, 0.0}) << pixelOf({middle - 0.32 * length, 0.27 * length})
          << pixelOf({middle - 0.18 * length, 0.0}) << pixelOf({middle - 0.32 * length, -0.27 * length});
    m_painter.setPen(Qt::NoPen);
    m_painter.setBrush(ink(m_colours.text));
    m_painter.drawPolygon(arrow);
}

QRectF VirtualScanDrawing::nearestBox(const Proximity& nearest, const QRectF& area) const {
    if (!nearest.where) return {};
    const QFontMetricsF metrics(nearestFont(m_painter));
    const QPointF at = pixelOf(*nearest.where);
    QRectF box(0, 0, metrics.horizontalAdvance(nearestText(nearest)) + 8.0, metrics.height() + 2.0);
    // Beside the point, away from the robot, and always visible.
    box.moveCenter(at);
    box.moveLeft(at.x() >= m_origin.x() ? at.x() + 10.0 : at.x() - 10.0 - box.width());
    box.moveLeft(std::clamp(box.left(), area.left(), area.right() - box.width()));
    box.moveTop(std::clamp(box.top(), area.top(), area.bottom() - box.height()));
    return box;
}

void VirtualScanDrawing::nearest(const Proximity& nearest, const QRectF& area) const {
    if (!nearest.where) return;
    const QColor colour = nearest.nearness == Nearness::Touching ? m_colours.act
                          : nearest.nearness == Nearness::Near   ? m_colours.attention
                                                                 : m_colours.text;
    const QRectF box = nearestBox(nearest, area);
    m_painter.save();
    m_painter.setPen(QPen(ink(colour), 1.5));
    m_painter.setBrush(Qt::NoBrush);
    if (const QPointF at = pixelOf(*nearest.where); area.contains(at)) m_painter.drawEllipse(at, 6.0, 6.0);
    m_painter.setPen(Qt::NoPen);
    m_painter.setBrush(ink(m_colours.pane, 0.8));
    m_painter.drawRoundedRect(box, 3, 3);
    m_painter.setFont(nearestFont(m_painter));
    m_painter.setPen(ink(colour));
    m_painter.drawText(box, Qt::AlignCenter, nearestText(nearest));
    m_painter.restore();
}

}  // namespace leitstand
