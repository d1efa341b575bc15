#pragma once

#include <vector>

#include <QString>

#include "widgets/models/live/robots/robot_chip.h"
#include "widgets/models/live/texts/stop_line.h"

namespace leitstand {

/// The robots of a team in a bar that has no room for all, by their places in the team, ascending.
struct RobotRow {
    std::vector<int> before;  ///< scrolled out at its beginning
    std::vector<int> shown;   ///< the selected one is always among them
    std::vector<int> after;   ///< scrolled out at its end
};

/// Returns the row of @p capacity robots out of @p count that begins with the @p first, from 0. The robot @p
/// selected keeps the slot at the end where it was scrolled out; less than 0: none is selected.
[[nodiscard]] RobotRow robotRowOf(int count, int capacity, int first, int selected);
/// Returns the first robot of the row of @p capacity that contains @p robot and is nearest to the row from @p
/// first.
[[nodiscard]] int firstToReveal(int robot, int capacity, int first);

/// What a bar shows of its hidden robots.
struct HiddenRobots {
    int count = 0;
    LinkState link = LinkState::Connected;  ///< the worst of theirs
    StopLine stop;    ///< the most urgent one: not answered, moves, stands; no stage: none is stopped
    QString details;  ///< a line for each: its name and all of its state

    friend bool operator==(const HiddenRobots&, const HiddenRobots&) = default;
};
/// Returns the state of the robots at @p places. @p chips and @p stops are of the team; stops may be fewer.
[[nodiscard]] HiddenRobots hiddenRobotsOf(const std::vector<int>& places, const std::vector<RobotChip>& chips,
                                          const std::vector<StopLine>& stops);

/// Returns all that is known of one robot, for tooltips and screen readers: its chip and the stage of its
/// stop.
[[nodiscard]] QString robotDetails(const RobotChip& chip, const StopLine& stop);

}  // namespace leitstand
