#pragma once

#include <vector>

#include <QString>

#include "widgets/models/live/robots/robot_chip.h"
#include "widgets/models/live/texts/stop_line.h"

namespace leitstand {

/// Which robots of a team stand in a bar that has not room for all; by their places in the team, ascending.
struct RobotRow {
    std::vector<int> before;  ///< scrolled out at its beginning
    std::vector<int> shown;   ///< the selected one is always among them
    std::vector<int> after;   ///< scrolled out at its end
};

/// The row of @p capacity robots out of @p count that begins with the @p first, from 0. @p selected keeps the
/// slot at the end that it was scrolled out of; less than 0: none is.
[[nodiscard]] RobotRow robotRowOf(int count, int capacity, int first, int selected);
/// The first robot of a row of @p capacity that has @p robot in it and lies nearest to the one from @p first.
[[nodiscard]] int firstToReveal(int robot, int capacity, int first);

/// What a bar tells of the robots that it does not show.
struct HiddenRobots {
    int count = 0;
    LinkState link = LinkState::Connected;  ///< the worst of theirs
    StopLine stop;    ///< the one to look at first: not answered, moves, stands; no stage: none is stopped
    QString details;  ///< a line for each: its name and all of its state

    friend bool operator==(const HiddenRobots&, const HiddenRobots&) = default;
};
/// Of the robots at @p places. @p chips, @p stops: of the team; stops may be fewer.
[[nodiscard]] HiddenRobots hiddenRobotsOf(const std::vector<int>& places, const std::vector<RobotChip>& chips,
                                          const std::vector<StopLine>& stops);

/// All that is known of one robot, for tooltips and screen readers: its chip and, where it is stopped, how
/// far.
[[nodiscard]] QString robotDetails(const RobotChip& chip, const StopLine& stop);

}  // namespace leitstand
