#pragma once

#include <array>
#include <optional>

#include <QColor>
#include <QImage>

#include "core/perception/pictures/picture.h"

namespace leitstand {

/// Returns @p picture as a QImage, a deep copy. Values of Grey16 and Float32 are scaled: the lowest becomes
/// black, the highest white. Null when size and bytes do not match.
[[nodiscard]] QImage imageOf(const Picture& picture);

/// Range of temperatures of the palette. It is the same for all pictures, so that each colour keeps its
/// meaning.
struct ThermalRange {
    float coolest = 15.0F, hottest = 40.0F;  ///< [degrees C]
    friend bool operator==(const ThermalRange&, const ThermalRange&) = default;
};
enum class ThermalPalette {
    Iron,      ///< from dark violet through red to pale yellow
    GreyHot,   ///< hot is white
    GreyCold,  ///< hot is black
};

/// Returns the colour of @p celsius, clamped to @p range; mid grey for NaN.
[[nodiscard]] QRgb thermalColour(float celsius, const ThermalRange& range, ThermalPalette palette);
[[nodiscard]] QImage imageOf(const ThermalPicture& picture, const ThermalRange& range = {},
                             ThermalPalette palette = ThermalPalette::Iron);
/// Returns the temperature at (@p x, @p y), given as shares of width and height (0 to 1) [degrees C]. Empty
/// outside, or where none was measured.
[[nodiscard]] std::optional<float> celsiusAt(const ThermalPicture& picture, double x, double y);
/// Returns the lowest and highest temperatures of @p picture, at least 2 K apart.
[[nodiscard]] ThermalRange rangeOf(const ThermalPicture& picture);
/// Returns a range between @p before and @p now, so that colours do not flicker. Each end moves a fifth of
/// the difference. An end that differs by more than 10 K moves all the way.
[[nodiscard]] ThermalRange eased(const ThermalRange& before, const ThermalRange& now);

}  // namespace leitstand
