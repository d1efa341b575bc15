#pragma once

#include <vector>

#include <QPointF>

namespace leitstand {

/// A round mark on the map.
struct MarkDisc {
    QPointF at;           ///< position of the marked thing [px]
    double radius = 0.0;  ///< [px]
};

/// Returns where to paint @p marks so that none hides another [px]. They must be sorted, the most important
/// first. A mark that would cover an earlier one is moved beside that one, in the direction of their offset.
/// Marks that only touch are not moved, and neither are marks without free space nearby.
[[nodiscard]] std::vector<QPointF> markPlaces(const std::vector<MarkDisc>& marks);

}  // namespace leitstand
