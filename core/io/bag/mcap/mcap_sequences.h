#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace leitstand::detail {

// In MCAP, messages have no numbers, but a mission needs them: undos and finds name events by their sequence.
// Our missions have them in records of opcode 0x80 (McapOp::Sequences). The specification leaves such opcodes
// to applications, and other programs pass over them. One without sequences stands behind the header, and
// marks the file as a mission's. One stands before each chunk, for its messages in the order of their places.
// One in the summary has them all.
//
// Content: a text that tells the record from those of others, then runs of sequences that follow each other.
// Of each run: the first sequence (8 bytes), and how many there are (4 bytes).

/// Sequences of messages, as runs of those that follow each other.
class McapSequences {
public:
    void add(std::uint64_t sequence);
    /// Adds those of @p other behind.
    void add(const McapSequences& other);
    void clear() { *this = {}; }
    [[nodiscard]] std::size_t count() const { return m_count; }
    /// Returns the first @p most of them, or all when there are fewer.
    [[nodiscard]] std::vector<std::uint64_t> first(std::size_t most) const;

    /// Returns the content of the record.
    [[nodiscard]] std::string content() const;
    /// Parses the content of a record; empty when another program wrote it, when it is cut short, or when it
    /// states more than @p most sequences, or any beyond MaxId.
    [[nodiscard]] static std::optional<McapSequences> parse(std::span<const std::byte> content,
                                                            std::size_t most);

private:
    struct Run {
        std::uint64_t first = 0;
        std::uint32_t count = 0;
    };
    std::vector<Run> m_runs;
    std::size_t m_count = 0;
};

}  // namespace leitstand::detail
