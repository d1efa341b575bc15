#pragma once

namespace leitstand::robot_bar {

// What the parts of the bar of robots have in common.
inline constexpr int Height = 42;                 ///< of a robot, in two lines [px]
inline constexpr int Upper = 21;                  ///< of them the upper one [px]
inline constexpr int TextSize = 12;               ///< of the font [px]
inline constexpr double Sign = 10.0, Side = 3.0;  ///< of a sign; beside what is written in a line [px]

}  // namespace leitstand::robot_bar
