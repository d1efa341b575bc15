#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/base/pose.h"
#include "core/base/time.h"
#include "core/robot/clock/far_clock.h"
#include "core/robot/robot_description.h"
#include "core/station/alarms/alarm_book.h"
#include "core/station/robot_view.h"

namespace leitstand {

struct RobotState;

/// Limits beyond which the operator is alarmed.
struct AlarmLimits {
    double attitude = 0.70, attitudeAct = 0.90;  ///< shares of the limits where the robot tips over
    double rolledOver = degrees(60);             ///< tilt [rad]
    double batteryMinutes = 10.0, batteryMinutesAct = 3.0;  ///< left at the present load [min]
    double batteryShare = 0.20, batteryShareAct = 0.08;     ///< of a full one, 0 to 1
    double gas = 2000.0;      ///< CO2: the breath of a victim, clearly above air [ppm]
    double spinning = 0.5;    ///< distance that wheels turn while the robot stands in the map [m]
    double bumped = 3.0;      ///< how long a bump lasts as an alarm [s]
    double unanswered = 2.0;  ///< a stop without an answer [s]
    double frozen = 2.0;      ///< pictures that are always the same [s]
    double clock = FarClock;  ///< offset between a robot's clock and the station's [s]
    double over = 0.85;       ///< a standing alarm ends below this share (or above 1 / share) of its limit
};

/// What is known of one robot.
struct RobotWatch {
    const RobotDescription& description;
    const RobotView& view;
    const RobotState& reported;
    std::optional<double> bumpAge = {};  ///< since a bumper was hit [s]
    std::string bumper = {};             ///< bumper that was hit
    double spinning = 0.0;               ///< RobotInMap::spinning [m]
};

/// Returns what the operator must know of a robot at @p now (station's clock). @p book: the standing alarms;
/// an alarm ends at a milder value than the one that raised it. Pure.
[[nodiscard]] std::vector<AlarmCause> alarmsOf(const RobotWatch& robot, const AlarmBook& book, Time now,
                                               const AlarmLimits& limits = {});

}  // namespace leitstand
