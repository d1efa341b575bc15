#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <string>
#include <utility>
#include <vector>

namespace leitstand::test {

/// Bytes of an MCAP file, put together by hand after the specification (https://mcap.dev/spec).
class McapText {
public:
    McapText() : m_bytes(Magic) { record(1, text("ros2") + text("test")); }

    static std::string number(std::uint64_t value, std::size_t size);
    static std::string text(const std::string& letters);

    /// Appends a record of @p op.
    McapText& record(int op, const std::string& content);
    /// The records of schema 1 "std_msgs/msg/String" and of channels 1 "/a" and 2 "/b".
    static std::string described();
    static std::string message(int channel, std::uint64_t time, const std::string& data);
    /// Appends a chunk of @p records, which stay as they are (@p compression empty), or by "lz4" or "zstd".
    /// @p index: with message indexes of these messages: channel -> time, offset. @p crc: false: a wrong one.
    McapText& chunk(const std::string& records, const std::string& compression = {},
                    const std::map<int, std::vector<std::pair<std::uint64_t, std::uint64_t>>>& index = {},
                    bool crc = true);
    /// Appends data end, and a summary of the chunks so far when @p summary is set.
    McapText& end(bool summary = true, std::uint64_t messages = 0);

    [[nodiscard]] const std::string& bytes() const { return m_bytes; }
    [[nodiscard]] std::uint64_t chunkAt() const { return m_chunks.back().offset; }  ///< the newest
    void write(const std::filesystem::path& file) const;

    static const std::string Magic;
    static std::string recordOf(int op, const std::string& content);

private:
    std::string m_bytes;
    struct Place {
        std::uint64_t offset, length, indexes, stored, size;
        std::string compression;
    };
    std::vector<Place> m_chunks;
};

}  // namespace leitstand::test
