#pragma once

#include <optional>

#include <QString>

#include "widgets/map_view/map_view.h"

namespace leitstand {

/// A picked point in words: "x 1.20  y -0.33  z 0.05 m · wall · scan001", or the robot that scanned it where
/// the scan has no name; empty for nothing.
[[nodiscard]] QString pickText(const std::optional<PickedPoint>& point, const Map& map);
/// A measurement in words: "2.37 m · dx 1.20 m  dy -2.00 m  dz 0.31 m".
[[nodiscard]] QString measurementText(const Measurement& measurement);

}  // namespace leitstand
