#pragma once

#include <cstddef>
#include <string>

#include <Eigen/Core>
#include <QString>

namespace leitstand {

// Numbers as the operator reads them: of the default QLocale, with a real minus sign (U+2212).

/// @p value with @p decimals digits after the point.
[[nodiscard]] QString numberText(double value, int decimals);
/// @p value with as many digits after the point as needed, but at most @p decimals: "10", "2.5".
[[nodiscard]] QString figureText(double value, int decimals);
/// @p reported, a number from a log such as "0.40", with the same number of digits after the point. Any other
/// text is not changed.
[[nodiscard]] QString loggedFigureText(const std::string& reported);
/// A whole number, with thousands grouped.
[[nodiscard]] QString countText(std::size_t count);
/// A number of points as a short text: "812", "7.6 k", "0.24 M".
[[nodiscard]] QString shortCountText(std::size_t count);
/// A share (0 to 1) in whole per cent: "83 %".
[[nodiscard]] QString percentText(double share);
/// Metres in millimetres with one digit after the point: "12.3".
[[nodiscard]] QString millimetresText(double metres);
/// Radians as degrees with one digit after the point and the degree sign: "−0.7°".
[[nodiscard]] QString degreesText(double radians);
/// x, y and z with two digits after the point, separated by blanks, without unit.
[[nodiscard]] QString positionText(const Eigen::Vector3d& metres);

}  // namespace leitstand
