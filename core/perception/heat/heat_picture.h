#pragma once

#include <array>
#include <cstdint>

#include "core/perception/pictures/picture.h"

namespace leitstand {

/// Returns red, green and blue of Matplotlib's colour map inferno at @p share, from 0 (black) to 1 (pale
/// yellow). Interpolates linearly between nine of its colours. Other shares are clamped.
[[nodiscard]] std::array<std::uint8_t, 3> inferno(double share);

/// Returns @p heat as a picture with colours from black over violet, red and yellow to white. Temperatures up
/// to @p coldest are black, those from @p hottest on are white [degrees C]. Pixels without a measurement are
/// grey.
[[nodiscard]] Picture heatPicture(const ThermalPicture& heat, double coldest = 15.0, double hottest = 40.0);

}  // namespace leitstand
