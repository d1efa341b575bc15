#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/event/raw_event.h"
#include "core/io/bag/mcap/mcap_records.h"
#include "core/io/bag/mcap/mcap_sequences.h"
#include "core/io/bag/topic_info.h"

namespace leitstand::detail {

/// Makes the bytes of an MCAP file as rosbag2 writes it: profile ros2, chunks compressed by zstd with message
/// indexes, and a summary with statistics. Whoever has an encoder stores the bytes. One thread.
class McapEncoder {
public:
    /// Whether messages keep their sequences (mcap_sequences.h): those of missions do.
    enum class Sequences : bool { Dropped, Kept };

    /// Begins a file.
    explicit McapEncoder(Sequences sequences);

    /// Describes @p topic; again: nothing happens.
    void add(const TopicInfo& topic) { (void)channelOf(topic); }
    /// Adds a message of @p topic, which was received at @p event.received. Messages may come in any order.
    void add(const TopicInfo& topic, const RawEvent& event);
    /// Ends the chunk that is being filled. Chunks end by themselves when they hold 1 MB.
    void endChunk();
    /// Ends the file with its summary. Nothing may be added behind.
    void endFile();
    /// Returns the bytes that were made since the last call. They follow those before.
    [[nodiscard]] std::string take() { return std::exchange(m_made, {}); }
    [[nodiscard]] bool hasBytes() const { return !m_made.empty(); }
    /// Whether there are more topics than a file can have, 65,535.
    [[nodiscard]] bool hasTooManyTopics() const { return m_state.channelOf.size() > MostTopics; }

    class Mark;
    /// Where the file stands. No chunk may be half full, and all bytes must have been taken.
    [[nodiscard]] Mark mark() const;
    /// Forgets all that was added since @p mark: the bytes were not stored.
    void goBackTo(const Mark& mark);

    static constexpr std::size_t MostTopics = 65'535;

private:
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
    struct State {
        std::uint64_t length = 0;                                                ///< of the file [B]
        std::map<std::pair<std::string, std::string>, std::uint16_t> channelOf;  ///< by topic and type
        std::map<std::string, std::uint16_t> schemaOf;                           ///< by type
        std::map<std::uint16_t, std::uint64_t> counts;                           ///< messages by channel
        Span times;
        McapSequences sequences;  ///< of all messages
    };

    [[nodiscard]] std::uint16_t channelOf(const TopicInfo& topic);
    void put(std::string_view bytes);
    void putRecord(McapOp op, std::string_view content);

    const Sequences m_sequences;
    State m_state;
    std::string m_described;  ///< records of schemas and channels
    std::vector<Chunk> m_chunks;
    std::string m_made;  ///< bytes that nobody has taken yet
    // The chunk that is filled:
    std::string m_records;
    std::map<std::uint16_t, std::string> m_index;  ///< entries by channel
    McapSequences m_chunkSequences;
    Span m_chunkTimes;
};

/// Where a file stood.
class McapEncoder::Mark {
    friend class McapEncoder;
    State m_state;
    std::size_t m_described = 0, m_chunks = 0;
};

}  // namespace leitstand::detail
