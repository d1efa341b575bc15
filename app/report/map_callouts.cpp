#include "app/report/map_callouts.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <QColor>
#include <QFont>
#include <QFontMetricsF>
#include <QLineF>
#include <QPainter>
#include <QPolygonF>

namespace leitstand {
namespace {

constexpr int Letters = 12;         ///< height of the names' font [dots]: 9 pt
constexpr double Margin = 3.0;      ///< within a box [dots]
constexpr double Apart = 2.0;       ///< between boxes [dots]
constexpr double LeastClear = 4.0;  ///< around a mark [dots]
constexpr double Speck = 6.0;       ///< a shorter bar cannot be read [dots]

bool crosses(const QLineF& line, const QRectF& box) {
    if (box.contains(line.p1()) || box.contains(line.p2())) return true;
    const std::vector<QLineF> sides = {{box.topLeft(), box.topRight()},
                                       {box.topRight(), box.bottomRight()},
                                       {box.bottomRight(), box.bottomLeft()},
                                       {box.bottomLeft(), box.topLeft()}};
    return std::any_of(sides.begin(), sides.end(), [&](const QLineF& side) {
        return line.intersects(side, nullptr) == QLineF::BoundedIntersection;
    });
}

/// Returns the line from @p place to the nearest point of @p box.
QLineF leader(const QPointF& place, const QRectF& box) {
    return {place,
            {std::clamp(place.x(), box.left(), box.right()), std::clamp(place.y(), box.top(), box.bottom())}};
}

QColor colourOf(MapMark::Kind kind) {
    const auto colour = [](Rgb rgb) { return QColor(rgb.red, rgb.green, rgb.blue); };
    switch (kind) {
        case MapMark::Kind::UnconfirmedVictim:
            return colour(map_colour::UnconfirmedVictim);
        case MapMark::Kind::Hazard:
            return colour(map_colour::Hazard);
        case MapMark::Kind::Code:
            return colour(map_colour::Code);
        case MapMark::Kind::Object:
            return colour(map_colour::Object).darker(150);  // visible on white
        case MapMark::Kind::Victim:
            break;
    }
    return colour(map_colour::Victim);
}

/// Whether @p box may name the place of number @p index. @p strict: it must not hide any place or line.
bool fits(const QRectF& box, std::size_t index, const std::vector<QPointF>& places,
          const std::vector<QRectF>& boxes, const CalloutRoom& settings, bool strict) {
    if (!settings.room.contains(box)) return false;
    const QRectF about = box.adjusted(-Apart, -Apart, Apart, Apart);
    if (std::any_of(boxes.begin(), boxes.end(), [&](const QRectF& one) { return about.intersects(one); }))
        return false;
    if (!strict) return true;
    for (const QPointF& place : places) {
        if (leader(place, box).length() < settings.clear) return false;
    }
    const QLineF line = leader(places[index], box);
    for (std::size_t i = 0; i < boxes.size(); ++i) {
        const QLineF other = leader(places[i], boxes[i]);
        if (crosses(other, about) || crosses(line, boxes[i])) return false;
        if (other.p1() != line.p1() && line.intersects(other, nullptr) == QLineF::BoundedIntersection)
            return false;
    }
    return true;
}

void arrow(QPainter& painter, const QPointF& from, const QPointF& to) {
    const QPointF along = (to - from) / QLineF(from, to).length(), side(-along.y(), along.x());
    painter.drawLine(from, to - 4.0 * along);
    painter.drawPolygon(QPolygonF({to, to - 7.0 * along + 3.0 * side, to - 7.0 * along - 3.0 * side}));
}

}  // namespace

std::vector<QRectF> placeCallouts(const std::vector<QPointF>& places, const std::vector<QSizeF>& sizes,
                                  const CalloutRoom& settings) {
    constexpr int Directions = 16;
    constexpr double Step = 6.0;  // [dots]
    const double farthest = std::hypot(settings.room.width(), settings.room.height());
    std::vector<QRectF> boxes;
    for (std::size_t i = 0; i < places.size(); ++i) {
        QRectF box(QPointF(), sizes[i]);
        bool found = false;
        for (const bool strict : {true, false}) {
            for (double away = settings.clear + Step; !found && away < farthest; away += Step) {
                for (int turn = 0; !found && turn < Directions; ++turn) {
                    // Starts at the upper right. The box touches a circle around the place from outside.
                    const double angle = (turn + 2) * 2.0 * std::numbers::pi / Directions;
                    const QPointF along(std::cos(angle), -std::sin(angle));
                    box.moveCenter(places[i] + QPointF(along.x() * (away + box.width() / 2),
                                                       along.y() * (away + box.height() / 2)));
                    found = fits(box, i, places, boxes, settings, strict);
                }
            }
            if (found) break;
        }
        if (!found) box.moveCenter(places[i]);  // more names than a page holds
        boxes.push_back(box);
    }
    return boxes;
}

void drawCallouts(QPainter& painter, const QRectF& picture, const MapPicture& map,
                  const std::vector<MapMark>& marks) {
    if (map.picture.width == 0) return;
    painter.save();
    QFont font = painter.font();
    font.setPixelSize(Letters);
    font.setBold(true);
    painter.setFont(font);
    const QFontMetricsF metrics(font);
    const double dots = picture.width() / map.picture.width;
    std::vector<QPointF> places;
    std::vector<QSizeF> sizes;
    for (const MapMark& mark : marks) {
        const Eigen::Vector2d pixel = map.pixelOf(mark.place);
        places.push_back(picture.topLeft() + dots * QPointF(pixel.x(), pixel.y()));
        const double wide = metrics.horizontalAdvance(QString::fromStdString(nameOf(mark)));
        sizes.emplace_back(wide + 2 * Margin, Letters + 2 * Margin);
    }
    const double clear = std::max(LeastClear, 0.5 * map_size::Disc * dots / map.perPixel);
    const auto boxes = placeCallouts(places, sizes, {picture, clear});
    painter.setRenderHint(QPainter::Antialiasing);
    for (std::size_t i = 0; i < marks.size(); ++i) {
        QLineF line = leader(places[i], boxes[i]);
        if (line.length() < clear + 1.0) continue;
        line.setP1(line.pointAt(clear / line.length()));  // keeps the number in the mark visible
        painter.setPen(QPen(Qt::white, 3.0));
        painter.drawLine(line);
        painter.setPen(QPen(Qt::black, 1.0));
        painter.drawLine(line);
    }
    for (std::size_t i = 0; i < marks.size(); ++i) {
        const bool sure = marks[i].kind != MapMark::Kind::UnconfirmedVictim;
        painter.setPen(QPen(colourOf(marks[i].kind), 1.5, sure ? Qt::SolidLine : Qt::DashLine));
        painter.setBrush(Qt::white);
        painter.drawRect(boxes[i]);
        painter.setPen(Qt::black);
        painter.drawText(boxes[i], Qt::AlignCenter, QString::fromStdString(nameOf(marks[i])));
    }
    painter.restore();
}

void drawScale(QPainter& painter, const QPointF& corner, double dots) {
    const int metres = dots < Speck ? 10 : 1;
    painter.save();
    QFont font = painter.font();
    font.setPixelSize(Letters);
    painter.setFont(font);
    painter.setRenderHint(QPainter::Antialiasing);
    const QColor colour(map_colour::Scale.red, map_colour::Scale.green, map_colour::Scale.blue);
    painter.setPen(QPen(colour, 2.0));
    painter.setBrush(colour);
    const QPointF joint = corner + QPointF(32.0, ScaleHeight - 6.0);
    arrow(painter, joint, joint - QPointF(0.0, 30.0));
    arrow(painter, joint, joint - QPointF(30.0, 0.0));
    painter.drawText(joint + QPointF(6.0, -22.0), QStringLiteral("x"));
    painter.drawText(joint + QPointF(-28.0, -8.0), QStringLiteral("y"));
    const QPointF begin = joint + QPointF(32.0, 0.0), end = begin + QPointF(metres * dots, 0.0);
    painter.setPen(QPen(colour, 2.0, Qt::SolidLine, Qt::FlatCap));
    painter.drawLine(begin, end);
    for (const QPointF& tick : {begin, end})
        painter.drawLine(tick + QPointF(0.0, 3.0), tick - QPointF(0.0, 6.0));
    painter.drawText(begin + QPointF(2.0, -9.0), QStringLiteral("%1 m").arg(metres));
    painter.restore();
}

}  // namespace leitstand
