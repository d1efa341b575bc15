#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <map>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/base/result.h"
#include "core/base/time.h"
#include "core/event/raw_event.h"
#include "core/io/bag/topic_info.h"
#include "core/io/detail/output_file.h"

namespace leitstand {

/// Writes an MCAP file as rosbag2 does: profile ros2, chunks compressed by zstd with message indexes, and a
/// summary with statistics. The file appears whole or not at all. One thread.
class McapWriter {
public:
    /// Begins @p file. Error when it cannot be written.
    [[nodiscard]] static Result<McapWriter> create(const std::filesystem::path& file);
    McapWriter(McapWriter&&) noexcept = default;

    /// Adds a message of @p topic, which was received at @p event.received. Messages may come in any order.
    void write(const TopicInfo& topic, const RawEvent& event);
    /// Writes what is left, and the summary. Error: the disk failed at any time, or there are more than
    /// 65,535 topics.
    [[nodiscard]] Result<void> close();

private:
    explicit McapWriter(detail::OutputFile file) : m_file(std::move(file)) {}
    struct Span {
        std::uint64_t first = ~0ULL, last = 0;  ///< log times [ns]
        void add(std::uint64_t time);
    };
    struct Chunk {
        std::uint64_t offset = 0, length = 0;                 ///< of its record in the file [B]
        std::map<std::uint16_t, std::uint64_t> indexes;       ///< offsets of its message indexes, by channel
        std::uint64_t indexLength = 0, stored = 0, size = 0;  ///< [B]
        Span times;
    };
    [[nodiscard]] std::uint16_t channelOf(const TopicInfo& topic);
    void put(std::string_view bytes);
    void endChunk();

    detail::OutputFile m_file;
    std::uint64_t m_written = 0;                                               ///< [B]
    std::map<std::pair<std::string, std::string>, std::uint16_t> m_channelOf;  ///< by topic and type
    std::map<std::string, std::uint16_t> m_schemaOf;                           ///< by type
    std::string m_described;                          ///< records of schemas and channels
    std::map<std::uint16_t, std::uint64_t> m_counts;  ///< messages by channel
    std::string m_records;                            ///< of the chunk that is filled
    std::map<std::uint16_t, std::string> m_index;     ///< of that chunk: entries by channel
    Span m_chunkTimes, m_times;
    std::vector<Chunk> m_chunks;
    bool m_tooMany = false;  ///< topics
};

}  // namespace leitstand
