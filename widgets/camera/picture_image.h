#pragma once

#include <array>
#include <optional>

#include <QColor>
#include <QImage>

#include "core/perception/pictures/picture.h"

namespace leitstand {

/// Returns @p picture as a QImage, a deep copy. Values of Grey16 and Float32 are scaled: the least becomes
/// black, the greatest white. Null when size and bytes do not match.
[[nodiscard]] QImage imageOf(const Picture& picture);

/// The temperatures that the palette spans; the same for all pictures, so that a colour keeps its meaning.
struct ThermalRange {
    float coolest = 15.0F, hottest = 40.0F;  ///< [degrees C]
    friend bool operator==(const ThermalRange&, const ThermalRange&) = default;
};
enum class ThermalPalette {
    Iron,      ///< dark violet over red to pale yellow
    GreyHot,   ///< hot is white
    GreyCold,  ///< hot is black
};

/// Returns the colour of @p celsius, clamped to @p range; mid grey for NaN.
[[nodiscard]] QRgb thermalColour(float celsius, const ThermalRange& range, ThermalPalette palette);
[[nodiscard]] QImage imageOf(const ThermalPicture& picture, const ThermalRange& range = {},
                             ThermalPalette palette = ThermalPalette::Iron);
/// Returns the temperature at @p x, @p y (0 to 1 of width and height) [degrees C]; empty outside or where
/// none was measured.
[[nodiscard]] std::optional<float> celsiusAt(const ThermalPicture& picture, double x, double y);
/// Returns the least and greatest temperatures of @p picture, at least 2 K apart.
[[nodiscard]] ThermalRange rangeOf(const ThermalPicture& picture);
/// Returns a range between @p before and @p now, so that colours do not flicker. Each end moves a fifth of
/// the way; an end that differs by more than 10 K moves all the way.
[[nodiscard]] ThermalRange eased(const ThermalRange& before, const ThermalRange& now);

}  // namespace leitstand
