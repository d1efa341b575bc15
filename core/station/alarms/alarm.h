#pragma once

#include <array>
#include <compare>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/base/time.h"

namespace leitstand {

/// How much an alarm matters; each has its own tone.
enum class AlarmSeverity : std::uint8_t {
    Attention,  ///< look there: sounds once
    Act,        ///< do something: sounds until it is acknowledged
};

/// Identifies an alarm. At most one alarm with the same id stands at a time.
struct AlarmId {
    std::string robot;   ///< "kurt3d"; empty: of the station
    std::string key;     ///< what alarms of one kind have in common: "link_lost"
    std::string detail;  ///< which of them: a camera, a part of the robot; may be empty
    friend auto operator<=>(const AlarmId&, const AlarmId&) = default;
};
/// Returns the name in the log: "link_lost", "diagnostics/motor_driver".
[[nodiscard]] std::string logKey(const AlarmId& id);

/// The keys that the alarm rules use and that views have words for.
namespace alarm_key {

inline constexpr const char* Attitude = "attitude";               ///< value: share of the limit
inline constexpr const char* RollOver = "roll_over";              ///< value: tilt [rad]
inline constexpr const char* LinkLost = "link_lost";              ///< value: silence [s]
inline constexpr const char* LinkDegraded = "link_degraded";      ///< note: logged(LinkReason)
inline constexpr const char* NotReceived = "unheard";             ///< note: toString(ReceptionFault)
inline constexpr const char* Battery = "battery";                 ///< value: minutes or share left, see note
inline constexpr const char* Gas = "gas";                         ///< value: [ppm]
inline constexpr const char* WheelsSpin = "wheels_spin";          ///< value: distance [m]
inline constexpr const char* Bump = "bump";                       ///< detail: bumper
inline constexpr const char* Diagnostics = "diagnostics";         ///< detail: part; note: its message
inline constexpr const char* StopUnanswered = "stop_unanswered";  ///< value: duration [s]
inline constexpr const char* FrozenPicture = "frozen_picture";    ///< detail: camera; value: duration [s]
inline constexpr const char* GrantLost = "grant_lost";            ///< note: who has it now
inline constexpr const char* ClockOffset = "clock_offset";        ///< value: robot's minus station's [s]
inline constexpr const char* UncertainScan = "uncertain_scan";    ///< value: how many
inline constexpr const char* Log = "log";                         ///< detail: one of log_key; note: its text

/// All of them.
inline constexpr auto All = std::to_array<std::string_view>({
    Attitude,
    RollOver,
    LinkLost,
    LinkDegraded,
    NotReceived,
    Battery,
    Gas,
    WheelsSpin,
    Bump,
    Diagnostics,
    StopUnanswered,
    FrozenPicture,
    GrantLost,
    ClockOffset,
    UncertainScan,
    Log,
});

}  // namespace alarm_key

/// A condition that holds now and that the operator must know.
struct AlarmCause {
    AlarmId id;
    AlarmSeverity severity = AlarmSeverity::Attention;
    double value = std::numeric_limits<double>::quiet_NaN();  ///< depends on the key
    std::string note = {};                                    ///< depends on the key; may be empty
    /// Further figures for the log, each with its name.
    std::vector<std::pair<std::string, std::string>> more = {};
    std::string text = {};  ///< as it was logged, if it was read from a log
    std::size_t count = 0;  ///< how many things it stands for; more than were acknowledged raise it again
};

/// An alarm as the operator sees it.
struct Alarm {
    AlarmCause cause;           ///< newest, or the last before it ended
    std::uint64_t number = 0;   ///< rises with each raising: the newest has the highest
    Time since{};               ///< when it was raised, station's clock
    std::optional<Time> ended;  ///< when it ended, after its cause was gone; empty: it stands
    bool acknowledged = false;

    [[nodiscard]] bool isLoud() const {
        return cause.severity == AlarmSeverity::Act && !acknowledged && !ended;
    }
};

}  // namespace leitstand
