#include "widgets/pad/pad_drawing.h"

#include <array>

#include <QPainterPath>

#include "widgets/painting/pane_paint.h"

namespace leitstand {
namespace {

namespace axis = standard_axis;
namespace button = standard_button;

/// A spot of the drawing, in units of its width.
struct Place {
    PadSpot spot;
    double x, y, radius;
};
constexpr double StickRadius = 0.062;

constexpr std::array<Place, 17> Places = {{{{false, axis::LeftTrigger}, 0.20, 0.035, 0.05},
                                           {{true, button::LeftShoulder}, 0.20, 0.105, 0.05},
                                           {{false, axis::LeftX}, 0.22, 0.24, StickRadius},
                                           {{true, button::LeftStick}, 0.22, 0.24, 0.03},
                                           {{true, button::Up}, 0.36, 0.355, 0.024},
                                           {{true, button::Left}, 0.312, 0.403, 0.024},
                                           {{true, button::Right}, 0.408, 0.403, 0.024},
                                           {{true, button::Down}, 0.36, 0.451, 0.024},
                                           {{true, button::Back}, 0.43, 0.21, 0.02},
                                           {{true, button::Start}, 0.57, 0.21, 0.02},
                                           {{true, button::Y}, 0.78, 0.172, 0.031},
                                           {{true, button::X}, 0.712, 0.24, 0.031},
                                           {{true, button::B}, 0.848, 0.24, 0.031},
                                           {{true, button::A}, 0.78, 0.308, 0.031},
                                           {{false, axis::RightX}, 0.64, 0.403, StickRadius},
                                           {{true, button::RightStick}, 0.64, 0.403, 0.03},
                                           {{false, axis::RightTrigger}, 0.80, 0.035, 0.05}}};
constexpr Place RightShoulder = {{true, button::RightShoulder}, 0.80, 0.105, 0.05};

const Place& placeOf(const PadSpot& spot) {
    for (const Place& place : Places) {
        if (place.spot == spot) return place;
    }
    return RightShoulder;
}

QPainterPath body(const QRectF& box) {
    const auto at = [&](double x, double y) { return box.topLeft() + QPointF(x, y) * box.width(); };
    QPainterPath path(at(0.22, 0.135));
    path.cubicTo(at(0.32, 0.10), at(0.38, 0.145), at(0.5, 0.145));
    path.cubicTo(at(0.62, 0.145), at(0.68, 0.10), at(0.78, 0.135));
    path.cubicTo(at(0.93, 0.15), at(1.0, 0.42), at(0.985, 0.56));
    path.cubicTo(at(0.975, 0.645), at(0.885, 0.64), at(0.84, 0.575));
    path.cubicTo(at(0.79, 0.50), at(0.73, 0.495), at(0.66, 0.495));
    path.lineTo(at(0.34, 0.495));
    path.cubicTo(at(0.27, 0.495), at(0.21, 0.50), at(0.16, 0.575));
    path.cubicTo(at(0.115, 0.64), at(0.025, 0.645), at(0.015, 0.56));
    path.cubicTo(at(0.0, 0.42), at(0.07, 0.15), at(0.22, 0.135));
    return path;
}

/// Sets pen and brush for the control of @p callout.
void setInk(QPainter& painter, const PadCallout& callout, const ThemeColours& colours, double width) {
    const bool bound = !callout.does.isEmpty();
    painter.setPen(QPen(callout.stop ? colours.stop : bound ? colours.text : colours.line, width));
    painter.setBrush(callout.stop   ? QBrush(colours.stop)
                     : callout.held ? QBrush(colours.select)
                                    : QBrush(colours.field));
}

void drawSpot(QPainter& painter, const QRectF& box, const PadCallout& callout, const PadState& state,
              const ThemeColours& colours) {
    const Place& place = placeOf(callout.spot);
    const double unit = box.width(), radius = place.radius * unit;
    QPointF middle = padSpotAt(callout.spot, box);
    setInk(painter, callout, colours, unit / 260.0);
    const int index = callout.spot.index;
    if (!callout.spot.isButton && (index == axis::LeftX || index == axis::RightX)) {
        painter.drawEllipse(middle, radius, radius);
        middle += QPointF(state.axis(index), state.axis(index + 1)) * (radius * 0.45);
        painter.drawEllipse(middle, radius * 0.6, radius * 0.6);
        return;
    }
    if (index == button::LeftStick && callout.spot.isButton) return;  // drawn as the stick itself
    if (index == button::RightStick && callout.spot.isButton) return;
    const bool wide =
        !callout.spot.isButton || index == button::LeftShoulder || index == button::RightShoulder;
    if (wide) {
        painter.drawRoundedRect(
            QRectF(middle.x() - 1.6 * radius, middle.y() - 0.5 * radius, 3.2 * radius, radius), radius / 3,
            radius / 3);
        return;
    }
    painter.drawEllipse(middle, radius, radius);
    if (index > button::Y) return;
    painter.setPen(callout.stop ? Qt::white : callout.held ? colours.window : colours.text);
    painter.setFont(sized(painter.font(), std::max(7, static_cast<int>(1.1 * radius)), true));
    painter.drawText(QRectF(middle.x() - radius, middle.y() - radius, 2 * radius, 2 * radius),
                     Qt::AlignCenter, callout.control);
}

}  // namespace

QPointF padSpotAt(const PadSpot& spot, const QRectF& box) {
    const Place& place = placeOf(spot);
    return box.topLeft() + QPointF(place.x, place.y) * box.width();
}

void drawPadBody(QPainter& painter, const QRectF& box, const ThemeColours& colours) {
    painter.setPen(QPen(colours.muted, box.width() / 260.0));
    painter.setBrush(colours.strip);
    painter.drawPath(body(box));
}

void drawPadControls(QPainter& painter, const QRectF& box, const PadCallouts& callouts, const PadState& state,
                     const ThemeColours& colours) {
    for (const auto* side : {&callouts.left, &callouts.right}) {
        for (const PadCallout& callout : *side) drawSpot(painter, box, callout, state, colours);
    }
}

}  // namespace leitstand
