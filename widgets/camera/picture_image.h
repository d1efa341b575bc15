#pragma once

#include <array>
#include <optional>

#include <QColor>
#include <QImage>

#include "core/perception/pictures/picture.h"

namespace leitstand {

/// @p picture as Qt draws it; a deep copy. Numbers (Grey16, Float32) are spread from their least to their
/// greatest. Null when sizes and bytes do not fit.
[[nodiscard]] QImage imageOf(const Picture& picture);

/// The temperatures that the palette spreads over; the same for all pictures, so that a colour keeps its
/// meaning.
struct ThermalRange {
    float coolest = 15.0F, hottest = 40.0F;  ///< [degrees C]
    friend bool operator==(const ThermalRange&, const ThermalRange&) = default;
};
enum class ThermalPalette {
    Iron,      ///< dark violet over red to pale yellow
    GreyHot,   ///< hot is white
    GreyCold,  ///< hot is black
};

/// The colour of @p celsius, cut to @p range; NaN is mid grey.
[[nodiscard]] QRgb thermalColour(float celsius, const ThermalRange& range, ThermalPalette palette);
[[nodiscard]] QImage imageOf(const ThermalPicture& picture, const ThermalRange& range = {},
                             ThermalPalette palette = ThermalPalette::Iron);
/// The temperature at @p x, @p y (0 to 1 of width and height); empty outside and where none was measured.
[[nodiscard]] std::optional<float> celsiusAt(const ThermalPicture& picture, double x, double y);
/// The least and greatest temperatures of @p picture, at least 2 K apart.
[[nodiscard]] ThermalRange rangeOf(const ThermalPicture& picture);
/// @p before, moved some way to @p now, at once where they differ much: colours that follow the picture do
/// not flicker.
[[nodiscard]] ThermalRange eased(const ThermalRange& before, const ThermalRange& now);

}  // namespace leitstand
