#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "core/event/raw_event.h"
#include "core/io/bag/bag_reader.h"
#include "core/io/bag/bag_writer.h"

namespace leitstand::test {

/// 2026-01-01, and @p milliseconds later.
[[nodiscard]] Time at(std::int64_t milliseconds);

/// Bytes that are the same for the same @p seed, beginning with a CDR header.
[[nodiscard]] Payload payload(std::size_t size, unsigned seed);

/// Event @p sequence of a mission with four topics (odometry, points, pictures, victims), @p size bytes long
/// (0: as its topic's are), received 10 ms after the one before.
[[nodiscard]] RawEvent sampleEvent(std::uint64_t sequence, std::size_t size = 0);
/// The topics of sampleEvent().
[[nodiscard]] std::vector<TopicInfo> sampleTopics();

/// Writes a session of events @p first to @p last into @p mission, and closes it.
void writeSession(const std::filesystem::path& mission, std::uint64_t first, std::uint64_t last,
                  const BagWriterSettings& settings = {});
/// The same, but as a killed writer leaves it: a database's write-ahead log has what came last. Each @p
/// flushEvery events are a commit of their own (0: as the writer likes).
void writeUnclosedSession(const std::filesystem::path& mission, std::uint64_t first, std::uint64_t last,
                          const BagWriterSettings& settings = {}, std::uint64_t flushEvery = 0);

/// All that the query gives.
[[nodiscard]] std::vector<RawEvent> readAll(BagReader& reader, const BagQuery& query = {});
/// Opens @p bag, and fails the test when that cannot be.
[[nodiscard]] std::unique_ptr<BagReader> opened(const std::filesystem::path& bag);
/// The sequences of @p events.
[[nodiscard]] std::vector<std::uint64_t> sequences(const std::vector<RawEvent>& events);
/// How many of @p events are not just as sampleEvent() makes them.
[[nodiscard]] std::size_t differing(const std::vector<RawEvent>& events, std::size_t size = 0);

/// Name, size, time of change and content of all files below @p folder.
[[nodiscard]] std::string fingerprint(const std::filesystem::path& folder);

}  // namespace leitstand::test
