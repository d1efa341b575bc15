#include "tests/io/bag/mcap_bytes.h"

#include <lz4frame.h>
#include <zlib.h>
#include <zstd.h>

#include "tests/support/temporary_folder.h"

namespace leitstand::test {

const std::string McapText::Magic("\x89MCAP0\r\n", 8);

std::string McapText::number(std::uint64_t value, std::size_t size) {
    std::string bytes;
    for (std::size_t i = 0; i < size; ++i) bytes += static_cast<char>(value >> (8 * i) & 0xFFU);
    return bytes;
}

std::string McapText::text(const std::string& letters) {
    return number(letters.size(), 4) + letters;
}

std::string McapText::recordOf(int op, const std::string& content) {
    return std::string(1, static_cast<char>(op)) + number(content.size(), 8) + content;
}

McapText& McapText::record(int op, const std::string& content) {
    m_bytes += recordOf(op, content);
    return *this;
}

std::string McapText::described() {
    const std::string schema =
        number(1, 2) + text("std_msgs/msg/String") + text("ros2msg") + text("string data");
    const auto channel = [](int id, const std::string& topic) {
        return recordOf(4, number(static_cast<std::uint64_t>(id), 2) + number(1, 2) + text(topic) +
                               text("cdr") + text(text("offered_qos_profiles") + text("[]")));
    };
    return recordOf(3, schema) + channel(1, "/a") + channel(2, "/b");
}

std::string McapText::message(int channel, std::uint64_t time, const std::string& data) {
    return recordOf(5, number(static_cast<std::uint64_t>(channel), 2) + number(0, 4) + number(time, 8) +
                           number(time, 8) + data);
}

McapText& McapText::chunk(const std::string& records, const std::string& compression,
                          const std::map<int, std::vector<std::pair<std::uint64_t, std::uint64_t>>>& index,
                          bool crc) {
    std::string stored = records;
    if (compression == "zstd") {
        stored.resize(ZSTD_compressBound(records.size()));
        stored.resize(ZSTD_compress(stored.data(), stored.size(), records.data(), records.size(), 3));
    } else if (compression == "lz4") {
        stored.resize(LZ4F_compressFrameBound(records.size(), nullptr));
        stored.resize(
            LZ4F_compressFrame(stored.data(), stored.size(), records.data(), records.size(), nullptr));
    }
    const auto sum = crc32_z(0, reinterpret_cast<const Bytef*>(records.data()), records.size());
    Place place{m_bytes.size(), 0, 0, stored.size(), records.size(), compression};
    record(6, number(0, 8) + number(0, 8) + number(records.size(), 8) + number(crc ? sum : sum + 1, 4) +
                  text(compression) + number(stored.size(), 8) + stored);
    place.length = m_bytes.size() - place.offset;
    for (const auto& [channel, entries] : index) {
        std::string pairs;
        for (const auto& [time, offset] : entries) pairs += number(time, 8) + number(offset, 8);
        record(7, number(static_cast<std::uint64_t>(channel), 2) + text(pairs));
    }
    place.indexes = m_bytes.size() - place.offset - place.length;
    m_chunks.push_back(place);
    return *this;
}

McapText& McapText::end(bool summary, std::uint64_t messages) {
    record(15, number(0, 4));
    const std::uint64_t at = summary ? m_bytes.size() : 0;
    if (summary) {
        m_bytes += described();
        for (const Place& one : m_chunks) {
            record(8, number(0, 8) + number(0, 8) + number(one.offset, 8) + number(one.length, 8) + text("") +
                          number(one.indexes, 8) + text(one.compression) + number(one.stored, 8) +
                          number(one.size, 8));
        }
        record(11, number(messages, 8) + number(1, 2) + number(2, 4) + number(0, 4) + number(0, 4) +
                       number(m_chunks.size(), 4) + number(0, 8) + number(0, 8) + text(""));
    }
    record(2, number(at, 8) + number(0, 8) + number(0, 4));
    m_bytes += Magic;
    return *this;
}

void McapText::write(const std::filesystem::path& file) const {
    writeText(file, m_bytes);
}

}  // namespace leitstand::test
