#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/base/pose.h"
#include "core/base/time.h"
#include "core/mission/state/robot_state.h"
#include "core/robot/clock/far_clock.h"
#include "core/robot/robot_description.h"
#include "core/station/alarms/alarm_book.h"
#include "core/station/robot_view.h"

namespace leitstand {

/// From where on the operator is told.
struct AlarmLimits {
    double attitude = 0.70, attitudeAct = 0.90;  ///< shares of the limits where the robot tips over
    double rolledOver = degrees(60);             ///< tilt [rad]
    double batteryMinutes = 10.0, batteryMinutesAct = 3.0;  ///< left at the present load [min]
    double batteryShare = 0.20, batteryShareAct = 0.08;     ///< of a full one, 0 to 1
    double gas = 2000.0;      ///< CO2: the breath of a victim, clearly above air [ppm]
    double spinning = 0.5;    ///< way that wheels turn while the map says that the robot stands [m]
    double bumped = 3.0;      ///< a bump is told for so long [s]
    double unanswered = 2.0;  ///< a stop without an answer [s]
    double frozen = 2.0;      ///< pictures that are always the same [s]
    double clock = FarClock;  ///< a robot's clock beside the station's [s]
    double over = 0.85;       ///< what stands ends below (or above 1 /) so much of its limit
};

/// What is known of one robot.
struct RobotWatch {
    const RobotDescription& description;
    const RobotView& view;
    const RobotState& said;
    std::optional<double> bumpAge = {};  ///< since a bumper was hit [s]
    std::string bumper = {};             ///< which one
    double spinning = 0.0;               ///< RobotInMap::spinning [m]
};

/// What the operator has to be told of a robot at @p now, station's clock. @p book: what stands already,
/// which takes more to end than it took to begin. Pure.
[[nodiscard]] std::vector<AlarmCause> alarmsOf(const RobotWatch& robot, const AlarmBook& book, Time now,
                                               const AlarmLimits& limits = {});

}  // namespace leitstand
