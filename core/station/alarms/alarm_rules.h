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
    /// Tilt as a share of the angles at which the robot tips over.
    double attitude = 0.70, attitudeAct = 0.90;
    double rolledOver = degrees(60);  ///< tilt of a robot that has rolled over [rad]
    /// Attention and act: time left at the present load [min].
    double batteryMinutes = 10.0, batteryMinutesAct = 3.0;
    double batteryShare = 0.20, batteryShareAct = 0.08;  ///< attention and act: charge left, 0 to 1
    double gas = 2000.0;      ///< CO2 of a victim's breath, clearly above that of air [ppm]
    double spinning = 0.5;    ///< distance that wheels turn while the robot stands in the map [m]
    double bumped = 3.0;      ///< how long the alarm about a bump is active [s]
    double unanswered = 2.0;  ///< time without an answer to a stop [s]
    double frozen = 2.0;      ///< time for which pictures are always the same [s]
    double clock = FarClock;  ///< offset between a robot's clock and the station's [s]
    double over = 0.85;       ///< an active alarm ends below this share of its limit (or above limit / share)
};

/// What is known about one robot.
struct RobotWatch {
    const RobotDescription& description;
    const RobotView& view;
    const RobotState& reported;
    std::optional<double> bumpAge = {};  ///< since a bumper was hit [s]
    std::string bumper = {};             ///< bumper that was hit
    double spinning = 0.0;               ///< RobotInMap::spinning [m]
};

/// Returns what the operator must know about a robot at @p now (station's clock). @p book: the active alarms.
/// An alarm ends at a milder value than the one at which it is raised. Pure.
[[nodiscard]] std::vector<AlarmCause> alarmsOf(const RobotWatch& robot, const AlarmBook& book, Time now,
                                               const AlarmLimits& limits = {});

}  // namespace leitstand
