#pragma once

#include <vector>

#include <QPointF>

namespace leitstand {

/// A round mark on the map.
struct MarkDisc {
    QPointF at;           ///< position of the marked thing [px]
    double radius = 0.0;  ///< [px]
};

/// Returns where to paint @p marks, which are sorted with the most important first, so that none hides
/// another [px]. A mark that would lie on an earlier one moves beside that one, in the direction of their
/// offset. Marks that only touch stay, and so do marks without free room nearby.
[[nodiscard]] std::vector<QPointF> markPlaces(const std::vector<MarkDisc>& marks);

}  // namespace leitstand
