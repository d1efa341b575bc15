#pragma once

#include <vector>

#include <QString>

#include "core/base/time.h"
#include "core/station/alarms/alarm.h"
#include "widgets/models/live/robots/robot_face.h"
#include "widgets/models/tone.h"

namespace leitstand {

/// Returns the text of an alarm, with its numbers: "link lost, silent for 4 s". It does not name the robot.
/// If a log does not have the numbers, the text is in English, as logged.
[[nodiscard]] QString alarmText(const AlarmCause& cause);

/// The stage of an alarm.
enum class AlarmStage { Standing, Acknowledged, Over };

/// An alarm as it is shown.
struct AlarmLine {
    AlarmId id;
    RobotFace face;  ///< empty for an alarm of the station
    AlarmSeverity severity = AlarmSeverity::Attention;
    AlarmStage stage = AlarmStage::Standing;
    bool acknowledged = false;
    QString text;   ///< "link lost, silent for 4 s"
    QString since;  ///< "12 s"; "over for 3 s"
    Tone tone = Tone::Normal;

    friend bool operator==(const AlarmLine&, const AlarmLine&) = default;
};

/// @p faces: faces of the robots. @p now: station's clock.
[[nodiscard]] std::vector<AlarmLine> alarmLinesOf(const std::vector<Alarm>& alarms,
                                                  const std::vector<RobotFace>& faces, Time now);

/// "muted for 48 s"; empty when tones are not muted.
[[nodiscard]] QString muteText(Time mutedUntil, Time now);
/// As muteText(), for narrow places: "48 s".
[[nodiscard]] QString muteBrief(Time mutedUntil, Time now);

}  // namespace leitstand
