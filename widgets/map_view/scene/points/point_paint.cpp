#include "widgets/map_view/scene/points/point_paint.h"

namespace leitstand {
namespace {

/// One in this many points of an uncertain scan is drawn, so that points behind stay visible.
constexpr std::size_t UncertainOneOf = 3;

}  // namespace

Rgba onRamp(double value, const ColourRamp& ramp) {
    return viridis((value - ramp.low) / (ramp.high - ramp.low));
}

Rgba PointPaint::colourOf(const ScanPoints& points, std::size_t point) const {
    if (alike) return one;
    const Rgba plain = plainColourOf(points, point);
    return dim ? dimmed(plain, theme) : plain;
}

Rgba PointPaint::plainColourOf(const ScanPoints& points, std::size_t point) const {
    const Label label = points.labels[point];
    if (paleFloor && label == Label::Floor) return mapColours(theme).ground;
    switch (colouring) {
        case MapColouring::Label:
            return labelColour(label);
        case MapColouring::Scan:
        case MapColouring::Robot:
        case MapColouring::Age:
            return one;
        case MapColouring::Height:
            return onRamp(up.dot(points.points[point].cast<double>()) + height, ramp);
        case MapColouring::Range:
            return onRamp(points.points[point].norm(), ramp);
        case MapColouring::Intensity:
            return points.shades ? onRamp((*points.shades)[point], ramp) : labelColour(Label::Unlabelled);
    }
    return {};
}

PointCloudLook lookOf(const ScanPoints& points, const PointPaint& paint, bool withCeiling, bool thinned) {
    PointCloudLook look{paint, withCeiling, points.points.size() / (thinned ? UncertainOneOf : 1), 0};
    look.shown = look.among;
    if (withCeiling) return look;
    std::size_t hidden = points.labelCounts[static_cast<std::size_t>(Label::Ceiling)];
    if (thinned && hidden > 0) {
        hidden = 0;
        for (std::size_t i = 0; i < look.among; ++i)
            hidden += points.labelOfSample(i) == Label::Ceiling ? 1 : 0;
    }
    look.shown -= hidden;
    return look;
}

}  // namespace leitstand
