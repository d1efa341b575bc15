#pragma once

#include <limits>
#include <utility>
#include <vector>

#include <QString>
#include <QStringList>

#include "core/robot/robot_description.h"
#include "core/station/alarms/alarm_rules.h"
#include "core/station/robot_figures.h"
#include "core/station/robot_view.h"
#include "widgets/models/live/robots/robot_face.h"
#include "widgets/models/live/robots/value_trend.h"
#include "widgets/models/live/texts/mode_label.h"
#include "widgets/models/tone.h"

namespace leitstand {

struct RobotState;

/// A number as it is shown in a gauge.
struct Figure {
    QString value;  ///< "0.42"; an en dash when it is unknown
    QString unit;   ///< "m/s"
    Tone tone = Tone::Normal;

    bool operator==(const Figure&) const = default;
};

struct AttitudeFigures {
    bool known = false;                    ///< whether it was measured recently
    double roll = 0.0, pitch = 0.0;        ///< positive: right side or nose down [rad]
    double maxRoll = 0.0, maxPitch = 0.0;  ///< angles at which the robot tips over; 0: unknown [rad]
    QString text;                          ///< "roll 6° · pitch −3°"; "no attitude" when unknown
    QString limits;                        ///< "tips at 25°"
    Tone tone = Tone::Normal;              ///< Attention from 70 % of a limit on, Act from 90 % on
};

struct BatteryFigures {
    Figure charge;  ///< its tone is that of the charge or of the remaining time, whichever is worse
    double fraction = std::numeric_limits<double>::quiet_NaN();  ///< 0 to 1
    QString left;                                                ///< "38 min at this load"; may be empty
    QString leftBrief;                                           ///< "38 min", for narrow places
    Tone leftTone = Tone::Muted;                                 ///< tone for the remaining time only
};

struct GasFigures {
    double alarm = 2000.0;  ///< AlarmLimits::gas [ppm]
    bool fitted = false;    ///< whether the robot measures CO2
    Figure value;
    QString arrow;                                   ///< "↑" rises, "↓" falls; empty: steady or unknown
    QString caption;                                 ///< "last 2 min · alarm at 2,000"
    std::vector<std::pair<double, double>> samples;  ///< result of ValueTrend::samples()
};

/// Speeds of the chains of a tracked robot, measured and commanded.
struct TrackFigures {
    QString text;   ///< "chains 0.21 of 0.25 · 0.20 of 0.25 m/s", left first; empty: no chains, or unknown
    QString brief;  ///< "0.21 of 0.25 · 0.20 of 0.25 m/s", for narrow places
    QString note;   ///< "the left chain does not follow"; may be empty
    Tone tone = Tone::Muted;
};

struct GrantFigures {
    enum class Choice {
        None,
        Ask,
        Asked,   ///< the station waits for the answer
        GiveUp,  ///< this station has the grant
        Answer,  ///< another station asks this one for the grant
    };
    Choice choice = Choice::None;
    QString text;
    Tone tone = Tone::Muted;
};

/// Everything that the drive strip shows about the selected robot.
struct DriveState {
    RobotFace face;
    ModeLabel mode;
    QString hint;  ///< what the driver must know or do before the robot moves
    Tone hintTone = Tone::Muted;
    Figure speed, turn, nearest;
    TrackFigures tracks;
    AttitudeFigures attitude;
    BatteryFigures battery;
    /// Figures about the link, the most important first; if there are none, the state of the link.
    QStringList link;
    QString linkReason;
    Tone linkTone = Tone::Normal;
    GasFigures gas;
    GrantFigures grant;
};

/// Returns what the strip shows. @p now: station's clock. @p limits: values from which figures have the tone
/// of an alarm.
[[nodiscard]] DriveState driveStateOf(const RobotFace& face, const RobotDescription& description,
                                      const RobotView& robot, const RobotState& reported,
                                      const ValueTrend& gas, Time now, const AlarmLimits& limits = {});

[[nodiscard]] GrantFigures grantFiguresOf(const GrantView& grant);

}  // namespace leitstand
