#pragma once

#include <compare>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <string>

#include "core/base/time.h"

namespace leitstand {

/// How much an alarm matters; each has its own tone.
enum class AlarmSeverity : std::uint8_t {
    Attention,  ///< look there: told once
    Act,        ///< do something: told until it is acknowledged
};

/// What alarms are told apart by: at most one of an id stands.
struct AlarmId {
    std::string robot;   ///< "kurt3d"; empty: of the station
    std::string key;     ///< what alarms of one kind have in common: "link_lost"
    std::string detail;  ///< which of them: a camera, a part of the robot; may be empty
    friend auto operator<=>(const AlarmId&, const AlarmId&) = default;
};
/// "link_lost", "diagnostics/motor_driver": as the log names it.
[[nodiscard]] std::string logKey(const AlarmId& id);

/// The keys that AlarmRules uses, and which views have words for.
namespace alarm_key {

inline constexpr const char* Attitude = "attitude";               ///< value: share of the limit
inline constexpr const char* RollOver = "roll_over";              ///< value: tilt [rad]
inline constexpr const char* LinkLost = "link_lost";              ///< value: silence [s]
inline constexpr const char* LinkDegraded = "link_degraded";      ///< note: why, in words
inline constexpr const char* Unheard = "unheard";                 ///< note: what is announced, in words
inline constexpr const char* Battery = "battery";                 ///< value: minutes or share left, see note
inline constexpr const char* Gas = "gas";                         ///< value: [ppm]
inline constexpr const char* WheelsSpin = "wheels_spin";          ///< value: for such a way [m]
inline constexpr const char* Bump = "bump";                       ///< detail: bumper
inline constexpr const char* Diagnostics = "diagnostics";         ///< detail: part; note: what it says
inline constexpr const char* StopUnanswered = "stop_unanswered";  ///< value: for so long [s]
inline constexpr const char* FrozenPicture = "frozen_picture";    ///< detail: camera; value: for so long [s]
inline constexpr const char* GrantLost = "grant_lost";            ///< note: who has it now
inline constexpr const char* ClockOffset = "clock_offset";        ///< value: robot's minus station's [s]
inline constexpr const char* UncertainScan = "uncertain_scan";    ///< value: how many
inline constexpr const char* Log = "log";  ///< detail: one of log_key; note: what it says

}  // namespace alarm_key

/// Something that is so now and that the operator has to know.
struct AlarmCause {
    AlarmId id;
    AlarmSeverity severity = AlarmSeverity::Attention;
    std::string text = {};  ///< whole, with numbers, in English: for the log
    double value = std::numeric_limits<double>::quiet_NaN();  ///< as the key says
    std::string note = {};                                    ///< likewise; may be empty
    std::size_t count = 0;  ///< of what it stands for: one more than was acknowledged is news
};

/// An alarm as the operator has it.
struct Alarm {
    AlarmCause cause;           ///< newest, or the last before it ended
    std::uint64_t number = 0;   ///< rises with each raising: the newest has the highest
    Time since{};               ///< station's clock: raised
    std::optional<Time> ended;  ///< the cause is gone
    bool acknowledged = false;

    [[nodiscard]] bool isLoud() const {
        return cause.severity == AlarmSeverity::Act && !acknowledged && !ended;
    }
};

}  // namespace leitstand
