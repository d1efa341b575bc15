#pragma once

#include <cstdint>

#include "core/perception/pictures/picture.h"

namespace leitstand {

/// Contrast enhancement for pictures in the dark.
enum class ContrastHelp : std::uint8_t {
    Off,
    Gentle,  ///< local contrast
    Strong,  ///< much local contrast, and shadows are lifted: noise rises too
};

/// Returns @p picture with more contrast in its brightness (gamma, then CLAHE: Zuiderveld 1994); colours keep
/// their hue. Grey16, Float32, and pictures smaller than 8 pixels a side are returned unchanged.
[[nodiscard]] Picture withContrast(const Picture& picture, ContrastHelp help);

}  // namespace leitstand
