#pragma once

#include <vector>

#include <QString>

#include "widgets/models/live/robots/robot_chip.h"
#include "widgets/models/live/texts/stop_line.h"

namespace leitstand {

/// Which robots a bar shows if it has not enough space for the whole team: their places in the team, rising.
struct RobotRow {
    std::vector<int> before;  ///< scrolled out at the beginning of the bar
    std::vector<int> shown;   ///< always includes the selected robot
    std::vector<int> after;   ///< scrolled out at the end of the bar
};

/// Returns the row of a bar that begins at the place @p first (from 0) and has space for @p capacity of
/// @p count robots. If the robot @p selected is scrolled out, it is shown in the last slot at that end.
/// Negative: none is selected.
[[nodiscard]] RobotRow robotRowOf(int count, int capacity, int first, int selected);
/// Returns the new first place of a row of @p capacity robots that begins at @p first, so that the row
/// contains @p robot: the nearest possible one.
[[nodiscard]] int firstToReveal(int robot, int capacity, int first);

/// What a bar shows of its hidden robots.
struct HiddenRobots {
    int count = 0;
    LinkState link = LinkState::Connected;  ///< the worst link among them
    StopLine stop;    ///< most urgent one: first not answered, then moves, then stands; stage None: no stop
    QString details;  ///< robotDetails(), one line per robot

    friend bool operator==(const HiddenRobots&, const HiddenRobots&) = default;
};
/// Returns what a bar shows of the hidden robots at @p places. @p chips and @p stops: those of the whole
/// team, by place. Robots beyond the end of @p stops are not stopped.
[[nodiscard]] HiddenRobots hiddenRobotsOf(const std::vector<int>& places, const std::vector<RobotChip>& chips,
                                          const std::vector<StopLine>& stops);

/// Returns everything known about one robot, for tooltips and screen readers: its chip and the stage of its
/// stop.
[[nodiscard]] QString robotDetails(const RobotChip& chip, const StopLine& stop);

}  // namespace leitstand
