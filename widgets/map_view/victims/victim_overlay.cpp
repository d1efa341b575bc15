#include "widgets/map_view/victims/victim_overlay.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <QPainter>
#include <QPainterPath>

#include "core/event/find_sample.h"
#include "widgets/map_view/camera/map_camera.h"
#include "widgets/map_view/overlays/overlay_style.h"
#include "widgets/models/victims/mark_places.h"

namespace leitstand {
namespace {

using Kind = FindSample::Kind;
constexpr double Radius = 12.0, CandidateRadius = 8.0, ChosenRadius = 18.0;  // [px]

/// Returns one of Okabe & Ito's colours, which everybody can distinguish. Shapes have the same meaning.
QColor colourOf(const VictimRow& find) {
    if (!find.filed()) return {0xCC, 0x79, 0xA7};
    switch (find.find.first) {
        case Kind::Victim:
            return {0xD5, 0x5E, 0x00};
        case Kind::Hazard:
            return {0xE6, 0x9F, 0x00};
        case Kind::Code:
            return {0x00, 0x72, 0xB2};
        case Kind::Object:
            return {0x00, 0x9E, 0x73};
    }
    return {};
}

QPolygonF corners(const QPointF& middle, double radius, int count, double first) {
    QPolygonF polygon;
    for (int i = 0; i < count; ++i) {
        const double angle = first + 2.0 * std::numbers::pi * i / count;
        polygon << middle + radius * QPointF(std::cos(angle), std::sin(angle));
    }
    return polygon;
}

QPainterPath outline(const VictimRow& find, const QPointF& at) {
    QPainterPath path;
    const double radius = find.filed() ? Radius : CandidateRadius;
    switch (find.find.first) {
        case Kind::Victim:
            path.addEllipse(at, radius, radius);
            break;
        case Kind::Hazard:
            path.addPolygon(corners(at, 1.25 * radius, 4, 0.0));
            break;
        case Kind::Code:
            path.addPolygon(corners(at, 1.2 * radius, 4, std::numbers::pi / 4.0));
            break;
        case Kind::Object:
            path.addPolygon(corners(at, 1.1 * radius, 6, 0.0));
            break;
    }
    path.closeSubpath();
    return path;
}

/// Paints a line from a mark that moved aside to its place.
void paintLeader(QPainter& painter, const QPointF& place, const QPointF& mark, const QColor& colour,
                 const OverlayStyle& style) {
    for (const QPen& pen : {QPen(asColour(style.colours.background), 4.0), QPen(colour, 2.0)}) {
        painter.setPen(pen);
        painter.drawLine(place, mark);
    }
}

void paintFind(QPainter& painter, const VictimRow& find, const QPointF& at, bool chosen,
               const OverlayStyle& style) {
    const QColor colour = colourOf(find);
    const QPainterPath shape = outline(find, at);
    if (chosen) {
        painter.setBrush(Qt::NoBrush);
        for (const QPen& pen : {QPen(asColour(style.colours.background), 5.0),
                                QPen(asColour(style.colours.measurement), 2.5)}) {
            painter.setPen(pen);
            painter.drawEllipse(at, ChosenRadius, ChosenRadius);
        }
    }
    painter.setPen(QPen(asColour(style.colours.background), 4.0));
    painter.setBrush(find.confirmed ? colour : asColour(style.colours.panel));
    painter.drawPath(shape);
    painter.setPen(
        QPen(find.confirmed ? QColor(Qt::white) : colour, 2.0, find.filed() ? Qt::SolidLine : Qt::DotLine));
    painter.drawPath(shape);
    QFont font = style.font;
    font.setBold(true);
    font.setPixelSize(find.filed() ? 12 : 11);
    painter.setFont(font);
    painter.setPen(find.confirmed ? QColor(Qt::white) : asColour(style.colours.text));
    painter.drawText(QRectF(at - QPointF(20, 12), QSizeF(40, 24)), Qt::AlignCenter, find.name);
}

}  // namespace

void paintVictims(QPainter& painter, const MapProjection& projection, const std::vector<VictimRow>& finds,
                  const std::optional<FindKey>& chosen, const OverlayStyle& style) {
    const auto isChosen = [&](const VictimRow& find) { return find.filed() && chosen == find.find; };
    const auto rankOf = [&](const VictimRow& find) { return isChosen(find) ? 0 : find.filed() ? 1 : 2; };
    // The most important marks keep their places and lie on top.
    std::vector<const VictimRow*> seen;
    for (const VictimRow& find : finds) {
        if (projection.project(find.inMap)) seen.push_back(&find);
    }
    std::ranges::stable_sort(seen, {}, [&](const VictimRow* find) { return rankOf(*find); });
    std::vector<MarkDisc> discs;
    for (const VictimRow* find : seen)
        discs.push_back(
            {projection.project(find->inMap)->position, find->filed() ? Radius : CandidateRadius});
    const std::vector<QPointF> places = markPlaces(discs);
    for (std::size_t i = seen.size(); i-- > 0;) {
        if (places[i] != discs[i].at) paintLeader(painter, discs[i].at, places[i], colourOf(*seen[i]), style);
        paintFind(painter, *seen[i], places[i], isChosen(*seen[i]), style);
    }
}

}  // namespace leitstand
