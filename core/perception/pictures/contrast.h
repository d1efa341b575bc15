#pragma once

#include <cstdint>

#include "core/perception/pictures/picture.h"

namespace leitstand {

/// How much contrast is added to dark pictures.
enum class ContrastHelp : std::uint8_t {
    Off,
    Gentle,  ///< more local contrast
    Strong,  ///< much more local contrast, and brighter shadows; also increases noise
};

/// Returns @p picture with more contrast in its brightness (gamma, then CLAHE: Zuiderveld 1994). Colours keep
/// their hue. Not changed: Grey16, Float32, and pictures with less than 8 pixels per side.
[[nodiscard]] Picture withContrast(const Picture& picture, ContrastHelp help);

}  // namespace leitstand
