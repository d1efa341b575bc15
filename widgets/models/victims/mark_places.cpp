#include "widgets/models/victims/mark_places.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

namespace leitstand {
namespace {

constexpr double Between = 2.0;  // between moved marks and others [px]
constexpr int Directions = 8, Rounds = 2;

double apart(const QPointF& one, const QPointF& other) {
    return std::hypot(one.x() - other.x(), one.y() - other.y());
}

}  // namespace

std::vector<QPointF> markPlaces(const std::vector<MarkDisc>& marks) {
    std::vector<QPointF> places;
    for (const MarkDisc& mark : marks) {
        // Two marks overlap when the middle of one is under the other.
        std::optional<std::size_t> under;
        for (std::size_t i = 0; i < places.size() && !under; ++i) {
            if (apart(mark.at, places[i]) < std::max(mark.radius, marks[i].radius)) under = i;
        }
        places.push_back(mark.at);
        if (!under) continue;
        const auto isFree = [&](const QPointF& place) {
            for (std::size_t i = 0; i + 1 < places.size(); ++i) {
                if (apart(place, places[i]) < mark.radius + marks[i].radius + 0.5 * Between) return false;
            }
            return true;
        };
        const QPointF off = mark.at - places[*under];
        const double first =
            apart(mark.at, places[*under]) < 1.0 ? 0.25 * std::numbers::pi : std::atan2(off.y(), off.x());
        const double beside = mark.radius + marks[*under].radius + Between;
        for (int i = 0; i < Rounds * Directions; ++i) {
            // Nearer places first; at each distance the direction that is least off.
            const int turn = (i % Directions + 1) / 2 * (i % 2 == 0 ? 1 : -1);
            const double angle = first + 2.0 * std::numbers::pi * turn / Directions;
            const double away = beside * (1.0 + 0.6 * (i / Directions));
            const QPointF place = places[*under] + away * QPointF(std::cos(angle), std::sin(angle));
            if (!isFree(place)) continue;
            places.back() = place;
            break;
        }
    }
    return places;
}

}  // namespace leitstand
