#pragma once

namespace leitstand::robot_bar {

// Sizes shared by the parts of the robot bar.
inline constexpr int Height = 42;                 ///< height of a robot's button with two lines [px]
inline constexpr int Upper = 21;                  ///< height of the upper line [px]
inline constexpr int TextSize = 12;               ///< size of the font [px]
inline constexpr double Sign = 10.0, Side = 3.0;  ///< side of a sign; margin beside a line's text [px]

}  // namespace leitstand::robot_bar
