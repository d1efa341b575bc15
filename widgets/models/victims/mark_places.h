#pragma once

#include <vector>

#include <QPointF>

namespace leitstand {

/// A round mark on the map.
struct MarkDisc {
    QPointF at;           ///< where what it marks is [px]
    double radius = 0.0;  ///< [px]
};

/// Where to paint @p marks, the most important first, so that none hides another: one that would lie on an
/// earlier one is beside it, in the direction in which it is off. Marks that only touch stay; so do those
/// for which there is no room around.
[[nodiscard]] std::vector<QPointF> markPlaces(const std::vector<MarkDisc>& marks);

}  // namespace leitstand
