#pragma once

#include <string>
#include <string_view>

#include "core/station/alarms/alarm.h"

namespace leitstand {

struct AlarmSample;

/// The keys of alarms that the log raises by itself; each is the detail of alarm_key::Log.
namespace log_key {

inline constexpr const char* DiskFilling = "disk_filling";
inline constexpr const char* DiskSlow = "disk_slow";
inline constexpr const char* DiskFull = "disk_full";
inline constexpr const char* EventsLost = "events_lost";
inline constexpr const char* Failed = "log_failed";

}  // namespace log_key

[[nodiscard]] bool isAlarmOfLog(std::string_view key);

/// Returns @p cause as the log holds it (AlarmSample::text): its key as a code, with value, note and further
/// figures. An example: `battery value=4 note=minutes percent=12`. For an alarm of the log itself, returns
/// its note.
[[nodiscard]] std::string logText(const AlarmCause& cause);

/// Returns the cause that was logged as @p reported. Reads value and note from the text; the value is as
/// exact as the text. Also reads the English sentences of old logs, written before there were codes. What
/// cannot be read stays unknown: NaN, and empty.
[[nodiscard]] AlarmCause loggedCause(const AlarmSample& reported);

}  // namespace leitstand
