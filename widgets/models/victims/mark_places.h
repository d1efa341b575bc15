#pragma once

#include <vector>

#include <QPointF>

namespace leitstand {

/// A round mark on the map.
struct MarkDisc {
    QPointF at;           ///< place of what it marks [px]
    double radius = 0.0;  ///< [px]
};

/// Returns where to paint @p marks, the most important first, so that none hides another. A mark that would
/// lie on an earlier one goes beside it, in the direction of its offset. Marks that only touch stay; so do
/// those without room around.
[[nodiscard]] std::vector<QPointF> markPlaces(const std::vector<MarkDisc>& marks);

}  // namespace leitstand
