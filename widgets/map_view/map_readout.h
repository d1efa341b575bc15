#pragma once

#include <optional>

#include <QString>

#include "widgets/map_view/map_view.h"

namespace leitstand {

/// Returns a picked point as text: "x 1.20  y -0.33  z 0.05 m · wall · scan001". If a scan has no name, its
/// robot is named instead. Empty for no point.
[[nodiscard]] QString pickText(const std::optional<PickedPoint>& point, const Map& map);
/// Returns a measurement as text: "2.37 m · dx 1.20 m  dy -2.00 m  dz 0.31 m".
[[nodiscard]] QString measurementText(const Measurement& measurement);

}  // namespace leitstand
