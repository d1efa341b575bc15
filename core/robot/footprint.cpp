#include "core/robot/footprint.h"

#include <algorithm>

#include "core/base/words.h"

namespace leitstand {
namespace {

using Corner = Eigen::Vector2d;

constexpr std::size_t MostCorners = 64;
constexpr double LeastArea = 1e-4;  ///< [m^2]

/// Returns the side of the line from @p a to @p b on which @p point lies: -1, 0, 1.
int side(const Corner& a, const Corner& b, const Corner& point) {
    const Corner along = b - a, to = point - a;
    const double cross = along.x() * to.y() - along.y() * to.x();
    return (cross > 0.0) - (cross < 0.0);
}

/// Whether @p point, on the line through @p a and @p b, is between them.
bool between(const Corner& a, const Corner& b, const Corner& point) {
    return (point.array() >= a.array().min(b.array())).all() &&
           (point.array() <= a.array().max(b.array())).all();
}

bool meet(const Corner& a, const Corner& b, const Corner& c, const Corner& d) {
    const int abc = side(a, b, c), abd = side(a, b, d), cda = side(c, d, a), cdb = side(c, d, b);
    if (abc != abd && cda != cdb && abc * abd <= 0 && cda * cdb <= 0) return true;
    return (abc == 0 && between(a, b, c)) || (abd == 0 && between(a, b, d)) ||
           (cda == 0 && between(c, d, a)) || (cdb == 0 && between(c, d, b));
}

}  // namespace

double signedArea(const std::vector<Corner>& corners) {
    double twice = 0.0;
    for (std::size_t i = 0; i < corners.size(); ++i) {
        const Corner &a = corners[i], &b = corners[(i + 1) % corners.size()];
        twice += a.x() * b.y() - a.y() * b.x();
    }
    return twice / 2.0;
}

std::string footprintProblem(const std::vector<Corner>& corners) {
    const std::size_t count = corners.size();
    if (count < 3 || count > MostCorners)
        return leitstand::fill(translate("leitstand::Error", "expected 3 to {} corners, found {}"),
                               MostCorners, count);
    for (std::size_t i = 0; i < count; ++i) {
        if (corners[i] == corners[(i + 1) % count])
            return leitstand::fill(
                translate("leitstand::Error", "expected corners that differ, found [{}, {}] twice in a row"),
                corners[i].x(), corners[i].y());
    }
    for (std::size_t i = 0; i < count; ++i) {
        for (std::size_t j = i + 2; j < count; ++j) {
            if ((j + 1) % count == i) continue;  // neighbours share a corner
            if (meet(corners[i], corners[i + 1], corners[j], corners[(j + 1) % count]))
                return leitstand::fill(
                    translate("leitstand::Error",
                              "expected sides that do not cross, found side {} crossing side {}"),
                    i + 1, j + 1);
        }
    }
    if (std::abs(signedArea(corners)) < LeastArea)
        return leitstand::fill(translate("leitstand::Error", "expected an area, found {:.3g} square metres"),
                               std::abs(signedArea(corners)));
    return {};
}

}  // namespace leitstand
