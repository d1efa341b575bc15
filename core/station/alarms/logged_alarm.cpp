#include "core/station/alarms/logged_alarm.h"

#include <algorithm>
#include <array>
#include <string>
#include <utility>

#include "core/base/known_sentence.h"
#include "core/base/pose.h"
#include "core/station/alarms/alarm_format.h"

namespace leitstand {
namespace {

constexpr std::array LogKeys = {log_key::DiskFilling, log_key::DiskSlow, log_key::DiskFull,
                                log_key::EventsLost, log_key::Failed};

/// A sentence that contains an alarm's value.
struct MeasuredSentence {
    const char* key;
    const char* words;
    double unit = 1.0;      ///< factor from the figure to the key's value
    std::size_t which = 0;  ///< index among its figures
    const char* note = "";
};

constexpr MeasuredSentence MeasuredSentences[] = {
    {alarm_key::Attitude, alarm_format::Tilted, 0.01, 2},
    {alarm_key::RollOver, alarm_format::RolledOver, degrees(1.0)},
    {alarm_key::LinkLost, alarm_format::LinkLost},
    {alarm_key::Battery, alarm_format::BatteryBoth, 1.0, 1, "minutes"},
    {alarm_key::Battery, alarm_format::BatteryMinutes, 1.0, 0, "minutes"},
    {alarm_key::Battery, alarm_format::BatteryShare, 0.01, 0, "share"},
    {alarm_key::Gas, alarm_format::Gas},
    {alarm_key::WheelsSpin, alarm_format::WheelsSpin},
    {alarm_key::StopUnanswered, alarm_format::StopUnanswered},
    {alarm_key::FrozenPicture, alarm_format::Frozen, 1.0, 1},
    {alarm_key::ClockOffset, alarm_format::ClockAhead},
    {alarm_key::ClockOffset, alarm_format::ClockBehind, -1.0},
    {alarm_key::UncertainScan, alarm_format::UncertainScan},
    {alarm_key::UncertainScan, alarm_format::UncertainScans},
};

void readValue(AlarmCause& cause) {
    for (const MeasuredSentence& one : MeasuredSentences) {
        if (cause.id.key != one.key) continue;
        const KnownSentence found = knownEnding(cause.text, std::array{one.words});
        if (found.words == nullptr) continue;
        const auto figure = figureIn(found.values[one.which]);
        if (!figure) continue;
        cause.value = *figure * one.unit;
        cause.note = one.note;
        return;
    }
}

/// Returns the message of @p part, which follows its name. The message may contain the name, too.
std::string messageOf(const std::string& part, const std::string& text) {
    const std::string name = part + ": ";
    if (const auto at = text.find(": " + name); at != std::string::npos)
        return text.substr(at + 2 + name.size());
    return text.starts_with(name) ? text.substr(name.size()) : std::string();
}

void readNote(AlarmCause& cause) {
    if (cause.id.key == alarm_key::Diagnostics) cause.note = messageOf(cause.id.detail, cause.text);
    for (const auto& [key, words] : {std::pair(alarm_key::LinkDegraded, alarm_format::LinkDegraded),
                                     std::pair(alarm_key::GrantLost, alarm_format::GrantLost),
                                     std::pair(alarm_key::NotReceived, alarm_format::NotReceived)}) {
        if (cause.id.key != key) continue;
        const KnownSentence found = knownEnding(cause.text, std::array{words});
        if (found.words != nullptr) cause.note = found.values.front();
    }
}

}  // namespace

bool isAlarmOfLog(std::string_view key) {
    return std::ranges::find(LogKeys, key, [](const char* one) { return std::string_view(one); }) !=
           LogKeys.end();
}

AlarmCause loggedCause(const AlarmSample& reported) {
    AlarmCause cause;
    cause.severity =
        reported.severity == AlarmSample::Severity::Critical ? AlarmSeverity::Act : AlarmSeverity::Attention;
    cause.text = reported.text;
    if (isAlarmOfLog(reported.key)) {
        cause.id = {{}, alarm_key::Log, reported.key};
        cause.note = reported.text;
        return cause;
    }
    const auto slash = reported.key.find('/');
    cause.id = {reported.robot, reported.key.substr(0, slash),
                slash == std::string::npos ? std::string() : reported.key.substr(slash + 1)};
    readValue(cause);
    readNote(cause);
    return cause;
}

}  // namespace leitstand
