#include "core/io/bag/ros1/ros1_file.h"

#include <algorithm>
#include <cstring>
#include <span>
#include <string_view>
#include <utility>

#include "core/base/words.h"
#include "core/io/bag/reading/decompression.h"

namespace leitstand::detail {
namespace {

constexpr std::string_view Magic = "#ROSBAG V2.0\n";
constexpr std::uint32_t LongestHead = 16U << 20U;                    ///< [B]
constexpr std::uint64_t MostChunk = MaxMessageBytes + (64U << 20U);  ///< unpacked [B]
constexpr int MessageData = 2, BagHead = 3, IndexData = 4, ChunkData = 5, Connection = 7;

std::uint64_t numberOf(std::span<const std::byte> bytes) {
    std::uint64_t number = 0;
    for (std::size_t i = 0; i < std::min<std::size_t>(bytes.size(), 8); ++i)
        number |= std::to_integer<std::uint64_t>(bytes[i]) << (8 * i);
    return number;
}

std::uint64_t numberOf(std::string_view bytes) {
    return numberOf(std::as_bytes(std::span(bytes.data(), bytes.size())));
}

/// Returns the moment that ROS 1 writes as seconds and nanoseconds, 4 bytes each.
Time timeOf(std::uint64_t both) {
    return Time(std::chrono::seconds(both & 0xFFFFFFFFU) + std::chrono::nanoseconds(both >> 32U));
}

/// Returns the values "name=value" in @p head; what is no such value is left out.
std::map<std::string, std::string, std::less<>> valuesOf(std::span<const std::byte> head) {
    std::map<std::string, std::string, std::less<>> values;
    while (head.size() >= 4) {
        const auto size = static_cast<std::size_t>(numberOf(head.first(4)));
        head = head.subspan(4);
        if (size > head.size()) break;
        const std::string_view text(reinterpret_cast<const char*>(head.data()), size);
        const auto equals = text.find('=');
        if (equals != std::string_view::npos)
            values[std::string(text.substr(0, equals))] = text.substr(equals + 1);
        head = head.subspan(size);
    }
    return values;
}

template <class Values>
std::uint64_t numberIn(const Values& values, std::string_view name) {
    const auto found = values.find(name);
    return found == values.end() ? 0 : numberOf(std::string_view(found->second));
}

template <class Values>
std::string textIn(const Values& values, std::string_view name) {
    const auto found = values.find(name);
    return found == values.end() ? std::string() : found->second;
}

/// Calls @p take with the op, the values, the offset and the data of each whole record in @p records, as long
/// as it returns true.
template <class Take>
void forEachRecordIn(std::span<const std::byte> records, Take take) {
    std::size_t at = 0;
    while (records.size() - at >= 8) {
        const auto head = static_cast<std::size_t>(numberOf(records.subspan(at, 4)));
        if (head > records.size() - at - 8) return;
        const auto size = static_cast<std::size_t>(numberOf(records.subspan(at + 4 + head, 4)));
        if (size > records.size() - at - 8 - head) return;
        const auto values = valuesOf(records.subspan(at + 4, head));
        if (!take(static_cast<int>(numberIn(values, "op")), values, at, records.subspan(at + 8 + head, size)))
            return;
        at += 8 + head + size;
    }
}

}  // namespace

Result<std::unique_ptr<BagFile>> Ros1File::open(const std::filesystem::path& file) {
    auto window = FileWindow::open(file);
    if (!window) return window.error();
    FileWindow bytes = std::move(window).value();
    const auto begin = bytes.at(0, Magic.size());
    if (std::string_view(reinterpret_cast<const char*>(begin.data()), begin.size()) != Magic)
        return Error{leitstand::fill(
            translate("leitstand::Error", "{}: expected a bag of ROS 1 in format 2.0"), file.string())};
    std::unique_ptr<Ros1File> bag(new Ros1File(file, std::move(bytes)));
    bag->index();
    return std::unique_ptr<BagFile>(std::move(bag));
}

void Ros1File::problem(std::uint64_t at, const std::string& what) {
    m_facts.problems.push_back(file().string() + ": " +
                               leitstand::fill(translate("leitstand::Error", "byte {}: {}"), at, what));
}

Ros1File::Record Ros1File::recordAt(std::uint64_t offset) {
    Record record;
    const auto headSize = m_window.at(offset, 4);
    if (headSize.size() < 4) return record;
    const std::uint64_t head = numberOf(headSize);
    if (head > LongestHead) return record;
    const auto bytes = m_window.at(offset + 4, head + 4);
    if (bytes.size() < head + 4) return record;
    record.values = valuesOf(bytes.first(static_cast<std::size_t>(head)));
    record.length = numberOf(bytes.subspan(static_cast<std::size_t>(head), 4));
    record.data = offset + 8 + head;
    if (record.values.contains("op")) record.op = static_cast<int>(numberIn(record.values, "op"));
    return record;
}

void Ros1File::addConnection(const Values& values, std::span<const std::byte> data) {
    const auto id = static_cast<std::uint32_t>(numberIn(values, "conn"));
    if (m_facts.topics.contains(id)) return;
    const Values described = valuesOf(data);
    FileTopic topic;
    topic.info.name = textIn(values, "topic");
    if (!topic.info.name.starts_with('/')) topic.info.name.insert(0, "/");
    const std::string type = textIn(described, "type");
    topic.info.type = ros2TypeOf(type);
    auto layout = Ros1Layout::parse(type, textIn(described, "message_definition"));
    if (layout) {
        m_layouts.emplace(id, std::move(layout).value());
    } else {
        topic.info.serialization = "ros1";
        m_facts.problems.push_back(file().string() + ": " + topic.info.name + ": " + layout.error().text);
    }
    m_facts.topics[id] = std::move(topic);
}

void Ros1File::addIndex(const Record& record, std::uint32_t chunk, std::vector<IndexEntry>& entries) {
    constexpr std::size_t Each = 12;  // time and offset [B]
    const auto connection = static_cast<std::uint32_t>(numberIn(record.values, "conn"));
    auto data = m_window.at(record.data, record.length);
    for (; data.size() >= Each && entries.size() < MostEntries; data = data.subspan(Each))
        entries.push_back({timeOf(numberOf(data.first(8))), numberOf(data.subspan(8, 4)), chunk, connection});
}

void Ros1File::scan(std::uint32_t chunk, std::vector<IndexEntry>* entries) {
    const Records records = recordsOf(chunk);
    forEachRecordIn(std::span<const std::byte>(*records),
                    [&](int op, const Values& values, std::size_t at, std::span<const std::byte> data) {
                        if (op == Connection) addConnection(values, data);
                        if (op != MessageData || entries == nullptr) return true;
                        entries->push_back({timeOf(numberIn(values, "time")), at, chunk,
                                            static_cast<std::uint32_t>(numberIn(values, "conn"))});
                        return entries->size() < MostEntries;
                    });
}

void Ros1File::index() {
    std::vector<IndexEntry> entries;
    std::vector<bool> indexed;  // by chunk
    bool closed = false;
    for (std::uint64_t at = Magic.size(); at < m_window.size();) {
        const Record record = recordAt(at);
        const bool cut = record.op < 0 || record.end() > m_window.size();
        if (record.op == BagHead) {
            const std::uint64_t index = numberIn(record.values, "index_pos");
            closed = index != 0 && index <= m_window.size();  // 0: it was never finished
        } else if (record.op == ChunkData) {
            const std::uint64_t length = std::min(record.length, m_window.size() - record.data);
            m_chunks.push_back({at, record.data, length, textIn(record.values, "compression"),
                                numberIn(record.values, "size")});
            indexed.push_back(false);
        } else if (record.op == IndexData && !cut && !m_chunks.empty()) {
            indexed.back() = true;
            addIndex(record, static_cast<std::uint32_t>(m_chunks.size() - 1), entries);
        } else if (record.op == Connection && !cut) {
            addConnection(record.values, m_window.at(record.data, record.length));
        }
        if (cut) {
            problem(at, translate("leitstand::Error",
                                  "the file ends within this record: what follows is missing"));
            closed = false;
            break;
        }
        at = record.end();
    }
    if (!closed && !indexed.empty() && indexed.back()) {
        // The writer was killed there: some of the indexes may be missing.
        const auto last = static_cast<std::uint32_t>(indexed.size() - 1);
        std::erase_if(entries, [last](const IndexEntry& one) { return one.chunk == last; });
        indexed.back() = false;
    }
    std::vector<bool> scanned(m_chunks.size());
    for (std::uint32_t chunk = 0; chunk < m_chunks.size(); ++chunk) {
        if (indexed[chunk]) continue;
        scanned[chunk] = true;
        scan(chunk, &entries);
    }
    for (std::size_t i = 0; i < entries.size(); ++i) {
        const std::uint32_t chunk = entries[i].chunk;
        if (scanned[chunk] || m_facts.topics.contains(entries[i].topic)) continue;
        scanned[chunk] = true;
        scan(chunk, nullptr);
    }
    if (entries.size() >= MostEntries)
        problem(m_window.size(),
                leitstand::fill(translate("leitstand::Error",
                                          "expected at most {} messages; those after them are left out"),
                                MostEntries));
    m_facts.closed = closed;
    for (const std::string& one : newProblems()) m_facts.problems.push_back(one);
    if (!closed && m_facts.problems.empty())
        m_facts.problems.push_back(file().string() + ": " +
                                   translate("leitstand::Error", "its writer did not finish it"));
    setEntries(std::move(entries));
}

std::vector<std::byte> Ros1File::unpackedChunk(std::uint32_t number) {
    const Chunk& chunk = m_chunks[number];
    const auto tell = [&](const std::string& what) {
        report(leitstand::fill(translate("leitstand::Error", "byte {}: {}"), chunk.at, what));
    };
    if (const std::uint64_t most = std::max(chunk.size, chunk.length); most > MostChunk) {
        tell(leitstand::fill(translate("leitstand::Error", "expected a chunk of at most {} bytes, found {}"),
                             MostChunk, most));
        return {};
    }
    const std::string format = chunk.compression == "none" ? std::string() : chunk.compression;
    auto unpacked = format == "zstd" ? std::nullopt
                                     : decompressed(m_window.at(chunk.data, chunk.length), format,
                                                    std::min(chunk.size, MostChunk) + 1);
    if (!unpacked) {
        tell(leitstand::fill(
            translate("leitstand::Error", "expected a chunk compressed by bz2 or lz4, found \"{}\""),
            chunk.compression.substr(0, 40)));
        return {};
    }
    if (!unpacked->whole || unpacked->bytes.size() != chunk.size)
        tell(leitstand::fill(
            translate("leitstand::Error", "expected a chunk of {} bytes, found {} that can be decompressed"),
            chunk.size, unpacked->bytes.size()));
    return std::move(unpacked->bytes);
}

std::optional<Payload> Ros1File::payloadAt(const IndexEntry& entry) {
    const auto layout = m_layouts.find(entry.topic);
    const Records records = recordsOf(entry.chunk);
    const std::span<const std::byte> all = *records;
    if (entry.offset >= all.size()) return std::nullopt;
    std::optional<Payload> payload;
    const auto take = [&](int op, const Values& values, std::size_t, std::span<const std::byte> data) {
        if (op != MessageData || numberIn(values, "conn") != entry.topic) return false;
        // Without a layout its topic says that this is no CDR.
        auto bytes = layout == m_layouts.end() ? std::vector<std::byte>(data.begin(), data.end())
                                               : layout->second.cdrOf(data, MaxMessageBytes);
        if (bytes) payload = std::make_shared<const std::vector<std::byte>>(std::move(*bytes));
        return false;
    };
    forEachRecordIn(all.subspan(static_cast<std::size_t>(entry.offset)), take);
    return payload;
}

}  // namespace leitstand::detail
