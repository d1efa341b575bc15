#pragma once

#include <QString>

#include "core/mapping/map.h"

namespace leitstand {

/// How far the pose of a scan can be trusted.
enum class Verdict {
    Reference,     ///< the first scan: defines the map's frame
    Certain,       ///< converged, and constrained in every direction
    Uncertain,     ///< converged, but hardly constrained in some direction (a corridor's axis)
    NotConverged,  ///< left at the guess, or where the iteration gave up
};

/// Returns the verdict by the figures of @p scan.
[[nodiscard]] Verdict verdictOf(const MapScan& scan);
/// Returns the verdict in a word or two, in the user's language.
[[nodiscard]] QString verdictText(Verdict verdict);
/// Returns the reason for the verdict and what to do, in a sentence or two.
[[nodiscard]] QString verdictReason(const MapScan& scan);

}  // namespace leitstand
