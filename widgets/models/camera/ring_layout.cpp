#include "widgets/models/camera/ring_layout.h"

#include <algorithm>
#include <cmath>

namespace leitstand {
namespace {

constexpr double Pen = 7.0;         // half of the thickest part, with its rim [px]
constexpr double LeastRadius = 24;  // [px]
constexpr double Inside = 10.0;     // figures end this far within the ring [px]

}  // namespace

QRectF ringCircle(const QRectF& picture, double top, double bottom) {
    const double room = 0.5 * (bottom - top) - Pen;
    const double radius = std::min(0.34 * std::min(picture.height(), picture.width()), room);
    if (radius < LeastRadius) return {};
    // A robot looks ahead and down: what is before it lies below the middle.
    const double y =
        std::clamp(picture.top() + 0.58 * picture.height(), top + Pen + radius, bottom - Pen - radius);
    return {picture.center().x() - radius, y - radius, 2.0 * radius, 2.0 * radius};
}

std::vector<RingFigure> ringFigures(const std::vector<Proximity>& ring, const QRectF& circle,
                                    const QSizeF& size) {
    const double radius = 0.5 * circle.width();
    const Proximity* nearest = nearestOf(ring);
    std::vector<RingFigure> figures;
    for (std::size_t i = 0; i < ring.size(); ++i) {
        const Proximity& part = ring[i];
        const bool loud = part.nearness == Nearness::Near || part.nearness == Nearness::Touching;
        if (!loud && &part != nearest) continue;
        const double middle = 0.5 * (part.from + part.to);
        const QPointF out(-std::sin(middle), -std::cos(middle));
        const double half = 0.5 * (std::abs(out.x()) * size.width() + std::abs(out.y()) * size.height());
        figures.push_back({circle.center() + std::max(0.0, radius - Inside - half) * out, i, loud});
    }
    std::ranges::stable_sort(figures, {}, [&](const RingFigure& one) { return ring[one.part].distance; });
    std::vector<RingFigure> seen;
    for (const RingFigure& one : figures) {
        const bool hides = std::ranges::any_of(seen, [&](const RingFigure& other) {
            return std::abs(one.at.x() - other.at.x()) < size.width() &&
                   std::abs(one.at.y() - other.at.y()) < size.height();
        });
        if (!hides) seen.push_back(one);
    }
    return seen;
}

}  // namespace leitstand
