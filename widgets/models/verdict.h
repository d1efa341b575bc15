#pragma once

#include <QString>

#include "core/mapping/map.h"

namespace leitstand {

/// How far the pose of a scan is to be trusted.
enum class Verdict {
    Reference,     ///< the first scan: defines the map's frame
    Certain,       ///< converged, held in every direction
    Uncertain,     ///< converged, but some direction is hardly held (a corridor's axis)
    NotConverged,  ///< stands at its guess or where the iteration was given up
};

/// What the figures of @p scan say.
[[nodiscard]] Verdict verdictOf(const MapScan& scan);
/// The verdict in a word or two, in the user's language.
[[nodiscard]] QString verdictText(Verdict verdict);
/// Why the verdict was given and what to do, in a sentence or two.
[[nodiscard]] QString verdictReason(const MapScan& scan);

}  // namespace leitstand
