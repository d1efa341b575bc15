#pragma once

#include <string>
#include <string_view>

#include "core/station/alarms/alarm.h"

namespace leitstand {

struct AlarmSample;

/// The keys of alarms that the log raises itself. Each is the detail of alarm_key::Log.
namespace log_key {

inline constexpr const char* DiskFilling = "disk_filling";
inline constexpr const char* DiskSlow = "disk_slow";
inline constexpr const char* DiskFull = "disk_full";
inline constexpr const char* EventsLost = "events_lost";
inline constexpr const char* Failed = "log_failed";

}  // namespace log_key

[[nodiscard]] bool isAlarmOfLog(std::string_view key);

/// Returns @p cause in the form stored in the log (AlarmSample::text): its key as a code, with value, note
/// and further figures. An example: `battery value=4 note=minutes percent=12`. For an alarm of the log
/// itself, returns its note.
[[nodiscard]] std::string logText(const AlarmCause& cause);

/// Returns the cause that was logged as @p reported. Value and note are read from the text, with its
/// precision. Also reads the English sentences of old logs, from before there were codes. What cannot be read
/// is NaN or empty.
[[nodiscard]] AlarmCause loggedCause(const AlarmSample& reported);

}  // namespace leitstand
