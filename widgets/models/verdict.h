#pragma once

#include <QString>

#include "core/mapping/map.h"

namespace leitstand {

/// How far the pose of a scan can be trusted.
enum class Verdict {
    Reference,     ///< the first scan: defines the map's frame
    Certain,       ///< converged, held in every direction
    Uncertain,     ///< converged, but some direction is hardly held (a corridor's axis)
    NotConverged,  ///< left at its guess, or where the iteration was given up
};

/// Returns the verdict by the figures of @p scan.
[[nodiscard]] Verdict verdictOf(const MapScan& scan);
/// Returns the verdict in a word or two, in the user's language.
[[nodiscard]] QString verdictText(Verdict verdict);
/// Returns the reason for the verdict and what to do, in a sentence or two.
[[nodiscard]] QString verdictReason(const MapScan& scan);

}  // namespace leitstand
