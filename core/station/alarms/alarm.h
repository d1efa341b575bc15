#pragma once

#include <array>
#include <chrono>
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

/// How important an alarm is; each severity has its own tone.
enum class AlarmSeverity : std::uint8_t {
    Attention,  ///< the operator should look: sounds once
    Act,        ///< the operator must act: sounds until it is acknowledged
};

/// Identifies an alarm. At most one alarm with the same id is active at a time.
struct AlarmId {
    std::string robot;   ///< "kurt3d"; empty: an alarm of the station
    std::string key;     ///< kind of alarm: "link_lost"
    std::string detail;  ///< camera or part of the robot that it is about; may be empty
    friend auto operator<=>(const AlarmId&, const AlarmId&) = default;
};
/// Returns the alarm's name in the log: "link_lost", "diagnostics/motor_driver".
[[nodiscard]] std::string logKey(const AlarmId& id);

/// The keys of alarms that the rules raise. Views have words for them.
namespace alarm_key {

inline constexpr const char* Attitude = "attitude";           ///< value: tilt as a share of the limit
inline constexpr const char* RollOver = "roll_over";          ///< value: tilt [rad]
inline constexpr const char* LinkLost = "link_lost";          ///< value: silence [s]
inline constexpr const char* LinkDegraded = "link_degraded";  ///< note: logged(LinkReason)
inline constexpr const char* NotReceived = "unheard";         ///< note: toString(ReceptionFault)
inline constexpr const char* Battery = "battery";  ///< value: minutes or share that is left, see `note`
inline constexpr const char* Gas = "gas";          ///< value: concentration [ppm]
inline constexpr const char* Reading = "reading";  ///< detail: its title; value: in its unit; note: unit
inline constexpr const char* WheelsSpin = "wheels_spin";          ///< value: distance [m]
inline constexpr const char* Bump = "bump";                       ///< detail: bumper
inline constexpr const char* Diagnostics = "diagnostics";         ///< detail: part; note: its message
inline constexpr const char* StopUnanswered = "stop_unanswered";  ///< value: duration [s]
inline constexpr const char* FrozenPicture = "frozen_picture";    ///< detail: camera; value: duration [s]
inline constexpr const char* GrantLost = "grant_lost";            ///< note: station that has it now
inline constexpr const char* ClockOffset = "clock_offset";      ///< value: robot's clock minus station's [s]
inline constexpr const char* UncertainScan = "uncertain_scan";  ///< value: number of scans
inline constexpr const char* Log = "log";                       ///< detail: one of log_key; note: its text

/// All of these keys.
inline constexpr auto All = std::to_array<std::string_view>({
    Attitude,
    RollOver,
    LinkLost,
    LinkDegraded,
    NotReceived,
    Battery,
    Gas,
    Reading,
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

/// A condition that exists now and that the operator must know about.
struct AlarmCause {
    AlarmId id;
    AlarmSeverity severity = AlarmSeverity::Attention;
    double value = std::numeric_limits<double>::quiet_NaN();  ///< its meaning depends on the key
    std::string note = {};  ///< its meaning depends on the key; may be empty
    /// Further figures for the log, with their names.
    std::vector<std::pair<std::string, std::string>> more = {};
    std::string text = {};  ///< text in the log, if the alarm was read from a log
    /// How many things it is about; the alarm is raised again if there are more than were acknowledged.
    std::size_t count = 0;
    /// How long it must last to raise its alarm, if that is longer than AlarmTiming::raiseAfter: for a rule
    /// such as "for 5 s", since rules see one moment only.
    std::chrono::nanoseconds persists{0};
};

/// An alarm as the operator sees it.
struct Alarm {
    AlarmCause cause;           ///< newest cause, or the last one before the alarm ended
    std::uint64_t number = 0;   ///< increases each time an alarm is raised: the newest has the highest
    Time since{};               ///< when it was raised, station's clock
    std::optional<Time> ended;  ///< when it ended, because its cause had gone; empty: it is active
    bool acknowledged = false;

    [[nodiscard]] bool isLoud() const {
        return cause.severity == AlarmSeverity::Act && !acknowledged && !ended;
    }
};

}  // namespace leitstand
