#pragma once

#include <QString>

#include "core/robot/services/goal_tracker.h"

namespace leitstand {

/// How far a robot is on its way to the goal that its navigation follows: "3.2 m to go · 12 s"; empty:
/// nothing is known, or it has ended.
[[nodiscard]] QString goalNote(const NavigationView& navigation);

/// How the way to a goal ended, with "%1" for the robot's title; empty: it has not.
[[nodiscard]] QString goalEnd(GoalStage stage);

}  // namespace leitstand
