#pragma once

#include <array>
#include <cstdint>

#include "core/perception/pictures/picture.h"

namespace leitstand {

/// Returns Matplotlib's inferno at @p share from 0 (black) to 1 (yellow to white), by straight lines between
/// nine of its colours. Shares beyond are clamped. Red, green, blue.
[[nodiscard]] std::array<std::uint8_t, 3> inferno(double share);

/// Returns @p heat as colours from black over violet, red and yellow to white. The scale is from @p coldest
/// and below to @p hottest and above [degrees C]; grey where the camera measures nothing.
[[nodiscard]] Picture heatPicture(const ThermalPicture& heat, double coldest = 15.0, double hottest = 40.0);

}  // namespace leitstand
