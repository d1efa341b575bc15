#pragma once

#include <array>
#include <string>
#include <string_view>

#include "core/base/phrases/coded_text.h"
#include "core/base/words.h"

/// Alarms of the log about its disk, in the form stored in the log (AlarmSample::text). The last value is the
/// file that is being written.
namespace leitstand::log_format {

inline constexpr LogPhrase DiskFilling = {
    "disk_filling",
    translatable("leitstand::LogSays", "the disk is full in {} minutes at {} MB/s"),
    {"minutes", "megabytes_per_second"}};
inline constexpr LogPhrase DiskLasts = {
    "disk_lasts", translatable("leitstand::LogSays", "the disk lasts {} minutes again"), {"minutes"}};
inline constexpr LogPhrase DiskLastsForDays = {
    "disk_lasts_for_days", translatable("leitstand::LogSays", "the disk lasts for days again")};
inline constexpr LogPhrase DiskFull = {
    "disk_full",
    translatable("leitstand::LogSays", "the disk is full; {} MB wait in memory"),
    {"waiting_megabytes"}};
inline constexpr LogPhrase DiskFree = {
    "disk_free", translatable("leitstand::LogSays", "there is space on the disk again")};
inline constexpr LogPhrase DiskSlow = {
    "disk_slow",
    translatable("leitstand::LogSays",
                 "the disk does not keep up: {} s behind, {} MB wait, {} pictures dropped"),
    {"seconds_behind", "waiting_megabytes", "dropped_pictures"}};
inline constexpr LogPhrase DiskKeepsUp = {
    "disk_keeps_up",
    translatable("leitstand::LogSays", "the disk keeps up again; {} pictures were dropped"),
    {"dropped_pictures"}};
inline constexpr LogPhrase EventsLost = {
    "events_lost", translatable("leitstand::LogSays", "{} events that are no pictures are lost"), {"events"}};
inline constexpr LogPhrase EventsKept = {
    "events_kept", translatable("leitstand::LogSays", "no more events are lost; {} were"), {"lost_events"}};
inline constexpr LogPhrase WrittenAgain = {"written_again",
                                           translatable("leitstand::LogSays", "is written again")};

inline constexpr auto All =
    std::to_array<LogPhrase>({DiskFilling, DiskLasts, DiskLastsForDays, DiskFull, DiskFree, DiskSlow,
                              DiskKeepsUp, EventsLost, EventsKept, WrittenAgain});

/// Returns @p phrase with @p values for @p file, in the form stored in the log.
template <class... Values>
[[nodiscard]] std::string about(const std::string& file, const LogPhrase& phrase, const Values&... values) {
    return logged(phrase, values...) + toString(CodedText{{}, {{"file", file}}});
}

/// Returns the one of All that @p text contains, with its figures. Also reads the English sentences of old
/// logs from before there were codes, which follow a file and ": ". Empty when a figure is no number, and for
/// failures, whose text comes from the system.
[[nodiscard]] ReadPhrase newsIn(std::string_view text);
/// Returns @p text in the window's language, after the name of the file. Other texts, such as failures, are
/// not changed.
[[nodiscard]] std::string message(const std::string& text);

}  // namespace leitstand::log_format
