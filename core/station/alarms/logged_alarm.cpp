#include "core/station/alarms/logged_alarm.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <utility>

#include "core/base/phrases/coded_text.h"
#include "core/base/pose.h"
#include "core/event/station_samples.h"

namespace leitstand {
namespace {

constexpr std::array LogKeys = {log_key::DiskFilling, log_key::DiskSlow, log_key::DiskFull,
                                log_key::EventsLost, log_key::Failed};

/// A sentence of old logs that contains an alarm's value.
struct MeasuredSentence {
    const char* key;
    const char* words;
    double unit = 1.0;      ///< factor from the figure to the key's value
    std::size_t which = 0;  ///< index among its figures
    const char* note = "";
};

constexpr MeasuredSentence MeasuredSentences[] = {
    {alarm_key::Attitude, "roll {}, pitch {} degrees: {} % of where it tips over", 0.01, 2},
    {alarm_key::RollOver, "rolled over, tilted by {} degrees", degrees(1.0)},
    {alarm_key::LinkLost, "link lost, silent for {} s"},
    {alarm_key::Battery, "battery {} %, {} min left", 1.0, 1, "minutes"},
    {alarm_key::Battery, "battery, {} min left", 1.0, 0, "minutes"},
    {alarm_key::Battery, "battery {} %", 0.01, 0, "share"},
    {alarm_key::Gas, "CO2 {} ppm"},
    {alarm_key::WheelsSpin, "its wheels turned for {} m, the map says it stands"},
    {alarm_key::StopUnanswered, "does not answer the stop for {} s"},
    {alarm_key::FrozenPicture, "camera {} repeats one picture for {} s", 1.0, 1},
    {alarm_key::ClockOffset, "its clock is {} s ahead of the station's"},
    {alarm_key::ClockOffset, "its clock is {} s behind the station's", -1.0},
    {alarm_key::UncertainScan, "{} uncertain scan to be decided on"},
    {alarm_key::UncertainScan, "{} uncertain scans to be decided on"},
};

void readOldValue(AlarmCause& cause) {
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

void readOldNote(AlarmCause& cause) {
    if (cause.id.key == alarm_key::Diagnostics) cause.note = messageOf(cause.id.detail, cause.text);
    for (const auto& [key, words] : {std::pair(alarm_key::LinkDegraded, "link: {}"),
                                     std::pair(alarm_key::GrantLost, "the grant to drive was lost to {}"),
                                     std::pair(alarm_key::NotReceived, "not heard: {}")}) {
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

std::string logText(const AlarmCause& cause) {
    if (cause.id.key == alarm_key::Log) return cause.note;
    CodedText coded{cause.id.key, {}};
    if (std::isfinite(cause.value)) coded.values.emplace_back("value", fmt::format("{:.6g}", cause.value));
    if (!cause.note.empty()) coded.values.emplace_back("note", cause.note);
    coded.values.insert(coded.values.end(), cause.more.begin(), cause.more.end());
    return toString(coded);
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
    if (const auto coded = codedText(reported.text); coded && coded->code == cause.id.key) {
        cause.value = coded->figure("value").value_or(cause.value);
        cause.note = coded->value("note").value_or(std::string());
        return cause;
    }
    readOldValue(cause);
    readOldNote(cause);
    return cause;
}

}  // namespace leitstand
