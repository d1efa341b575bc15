#pragma once

#include <QString>

#include "core/mapping/map.h"

namespace leitstand {

/// How reliable the pose of a scan is.
enum class Verdict {
    Reference,     ///< the first scan: defines the map's frame
    Certain,       ///< converged, and determined in every direction
    Uncertain,     ///< converged, but hardly determined in some direction (a corridor's axis)
    NotConverged,  ///< at the guess, or where the iteration stopped
};

/// Returns the verdict that follows from the figures of @p scan.
[[nodiscard]] Verdict verdictOf(const MapScan& scan);
/// Returns the verdict in one or two words, in the user's language.
[[nodiscard]] QString verdictText(Verdict verdict);
/// Returns the reason for the verdict and what to do, in one or two sentences.
[[nodiscard]] QString verdictReason(const MapScan& scan);

}  // namespace leitstand
