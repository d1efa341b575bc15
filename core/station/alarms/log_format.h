#pragma once

#include <array>
#include <string_view>

#include "core/base/known_sentence.h"
#include "core/base/words.h"

/// Texts of the log's own alarms about the disk. They are logged in English, after a file and ": ", and shown
/// in the window's language. "{}" stands for a figure.
namespace leitstand::log_format {

constexpr auto DiskFilling = translatable("leitstand::LogSays", "the disk is full in {} minutes at {} MB/s");
constexpr auto DiskLasts = translatable("leitstand::LogSays", "the disk lasts {} minutes again");
constexpr auto DiskLastsForDays = translatable("leitstand::LogSays", "the disk lasts for days again");
constexpr auto DiskFull = translatable("leitstand::LogSays", "the disk is full; {} MB wait in memory");
constexpr auto DiskFree = translatable("leitstand::LogSays", "there is space on the disk again");
constexpr auto DiskSlow = translatable(
    "leitstand::LogSays", "the disk does not keep up: {} s behind, {} MB wait, {} pictures dropped");
constexpr auto DiskKeepsUp =
    translatable("leitstand::LogSays", "the disk keeps up again; {} pictures were dropped");
constexpr auto EventsLost = translatable("leitstand::LogSays", "{} events that are no pictures are lost");
constexpr auto EventsKept = translatable("leitstand::LogSays", "no more events are lost; {} were");
constexpr auto WrittenAgain = translatable("leitstand::LogSays", "is written again");

inline constexpr auto All =
    std::to_array<const char*>({DiskFilling, DiskLasts, DiskLastsForDays, DiskFull, DiskFree, DiskSlow,
                                DiskKeepsUp, EventsLost, EventsKept, WrittenAgain});

/// Returns which of All an alarm of the log contains, with its figures. Empty when one of them is no number,
/// and for failures, whose text is the system's.
[[nodiscard]] KnownSentence newsIn(std::string_view text);

}  // namespace leitstand::log_format
