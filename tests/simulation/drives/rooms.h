#pragma once

#include "robots/simulation/arena/arena.h"

namespace leitstand::simulation::test {

/// A room of @p x by @p y m from the origin on, with walls of 1.2 m; a robot starts in the middle of its west
/// end and looks east.
[[nodiscard]] Arena room(double x, double y);
/// A wall from @p a to @p b.
[[nodiscard]] Element wall(const std::string& name, const Eigen::Vector2d& a, const Eigen::Vector2d& b);
/// A warm victim that lies open at @p place, its head to @p yaw [rad].
[[nodiscard]] Element warmVictim(const Eigen::Vector2d& place, double yaw);
/// The ground rises along x from @p x to @p x + @p length by @p angle [rad], over the whole width @p y.
[[nodiscard]] Element rampAt(double x, double length, double y, double angle);

}  // namespace leitstand::simulation::test
