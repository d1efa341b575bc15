#pragma once

#include "core/perception/picture.h"

namespace leitstand {

/// @p heat as colours from black over violet, red and yellow to white, @p coldest and below to @p hottest and
/// above [degrees C]; grey where the camera tells nothing.
[[nodiscard]] Picture heatPicture(const ThermalPicture& heat, double coldest = 15.0, double hottest = 40.0);

}  // namespace leitstand
