#include "widgets/models/camera/heat_labels.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace leitstand {
namespace {

constexpr double Beside = 5.0;       // from a frame to its words [px]
constexpr double Farthest = 5.5;     // largest gap to it, in heights of the words: past the scale at the edge
constexpr double OneBody = 2.0;      // gap between parts of one body, in longer sides of the larger part
constexpr double OnFrame = 1'000.0;  // cost of lying on a frame, against pixels away from it

/// Returns the gap from edge to edge; 0 where they meet.
double gapBetween(const QRectF& one, const QRectF& other) {
    const double across = std::max({0.0, one.left() - other.right(), other.left() - one.right()});
    const double down = std::max({0.0, one.top() - other.bottom(), other.top() - one.bottom()});
    return std::hypot(across, down);
}

double longerSide(const QRectF& frame) {
    return std::max(frame.width(), frame.height());
}

/// Returns groups of marks that belong together, each by indices.
std::vector<std::vector<std::size_t>> bodiesOf(const std::vector<HeatMark>& marks) {
    std::vector<std::vector<std::size_t>> bodies;
    std::vector<bool> known(marks.size(), false);
    for (std::size_t first = 0; first < marks.size(); ++first) {
        if (known[first]) continue;
        known[first] = true;
        std::vector<std::size_t> body{first};
        for (std::size_t i = 0; i < body.size(); ++i) {
            const QRectF part = marks[body[i]].frame;
            for (std::size_t other = 0; other < marks.size(); ++other) {
                const QRectF& frame = marks[other].frame;
                const double reach = OneBody * std::max(longerSide(part), longerSide(frame));
                if (known[other] || gapBetween(part, frame) > reach) continue;
                known[other] = true;
                body.push_back(other);
            }
        }
        bodies.push_back(std::move(body));
    }
    return bodies;
}

/// Returns where a box of @p size may lie, first above @p about.
std::vector<QRectF> placesFor(const QSizeF& size, const QRectF& about, const QRectF& area,
                              const std::vector<QRectF>& taken) {
    const double w = size.width(), h = size.height();
    std::vector<QRectF> places;
    if (w > area.width() || h > area.height()) return places;
    const auto add = [&](double x, double y) {
        places.emplace_back(QPointF(std::clamp(x, area.left(), area.right() - w),
                                    std::clamp(y, area.top(), area.bottom() - h)),
                            size);
    };
    std::vector<double> columns = {about.center().x() - 0.5 * w, about.right() + Beside,
                                   about.left() - Beside - w, area.left(), area.right() - w};
    for (const QRectF& other : taken) columns.insert(columns.end(), {other.left() - w, other.right()});
    for (const double y : {about.top() - Beside - h, about.bottom() + Beside, about.center().y() - 0.5 * h}) {
        for (const double x : columns) add(x, y);
    }
    for (double y = area.top(); y + h <= area.bottom(); y += h) {
        for (const double x : columns) add(x, y);
    }
    return places;
}

}  // namespace

std::vector<HeatLabel> heatLabels(const std::vector<HeatMark>& marks,
                                  const std::function<QSizeF(double celsius)>& sizeOf, const QRectF& area,
                                  const std::vector<QRectF>& taken, const std::optional<QSizeF>& brief) {
    std::vector<HeatLabel> labels;
    /// Returns the best place for words of @p size about @p about; empty: there is none.
    const auto placeOf = [&](const QSizeF& size, const QRectF& about) {
        double least = std::numeric_limits<double>::infinity();
        std::optional<QRectF> best;
        for (const QRectF& place : placesFor(size, about, area, taken)) {
            const auto lies = [&place](const QRectF& on) { return place.intersects(on); };
            if (gapBetween(place, about) > Farthest * place.height()) continue;
            if (std::ranges::any_of(labels, lies, &HeatLabel::box) || std::ranges::any_of(taken, lies))
                continue;
            double cost = std::max(Beside, gapBetween(place, about)) +
                          0.1 * std::abs(place.center().x() - about.center().x());
            cost += OnFrame * static_cast<double>(std::ranges::count_if(marks, lies, &HeatMark::frame));
            if (cost >= least) continue;
            least = cost;
            best = place;
        }
        return best;
    };
    for (const std::vector<std::size_t>& body : bodiesOf(marks)) {
        HeatLabel label{.box = {},
                        .about = marks[body.front()].frame,
                        .celsius = marks[body.front()].celsius,
                        .marks = static_cast<int>(body.size())};
        for (const std::size_t part : body) {
            label.about = label.about.united(marks[part].frame);
            label.celsius = std::max(label.celsius, marks[part].celsius);
        }
        auto place = placeOf(sizeOf(label.celsius), label.about);
        label.brief = !place && brief;
        if (label.brief) place = placeOf(*brief, label.about);
        if (!place) continue;
        label.box = *place;
        labels.push_back(label);
    }
    return labels;
}

}  // namespace leitstand
