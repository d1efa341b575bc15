#pragma once

#include <optional>
#include <string>
#include <string_view>

#include <Eigen/Core>

namespace leitstand::detail {

/// What separates the fields of a line.
enum class Separators : bool { Blanks, BlanksAndCommas };  ///< commas: semicolons too

/// Takes the next field off the front of @p line; empty when there is none. Runs of separators count as one.
[[nodiscard]] std::string_view takeField(std::string_view& line, Separators separators = Separators::Blanks);

/// The whole of @p field as a number ("nan" and "inf" included); nothing when it is none or overflows.
[[nodiscard]] std::optional<double> toNumber(std::string_view field);

/// Scans end well before this, and float32 still resolves 8 mm there [m].
inline constexpr double MaxCoordinate = 100'000.0;
inline constexpr std::string_view CoordinateExpectation = "finite coordinates within 100 km";

/// A point [m], all NaN (no echo) when any coordinate is; nothing beyond MaxCoordinate or infinite.
[[nodiscard]] std::optional<Eigen::Vector3f> toPoint(double x, double y, double z);

/// The point that stands for "no echo".
[[nodiscard]] Eigen::Vector3f noEcho();

/// Appends the shortest text that reads back as the very same number.
void appendNumber(std::string& text, float value);
void appendNumber(std::string& text, double value);

/// Appends @p metres in centimetres, with just enough digits that reading and dividing by 100 gives the very
/// same float.
void appendCentimetres(std::string& text, float metres);

}  // namespace leitstand::detail
