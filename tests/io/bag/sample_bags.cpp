#include "tests/io/bag/sample_bags.h"

#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <set>

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <sqlite3.h>

#include "tests/support/temporary_folder.h"

namespace leitstand::test {

namespace fs = std::filesystem;

Time at(std::int64_t milliseconds) {
    return Time(std::chrono::milliseconds(1'767'225'600'000 + milliseconds));
}

Payload payload(std::size_t size, unsigned seed) {
    auto bytes = std::make_shared<std::vector<std::byte>>(std::max<std::size_t>(size, 4));
    std::uint32_t state = seed * 2'654'435'761U + 1;
    for (std::byte& byte : *bytes) {
        state = state * 1'664'525U + 1'013'904'223U;
        byte = static_cast<std::byte>(state >> 24U);
    }
    (*bytes)[0] = (*bytes)[2] = (*bytes)[3] = std::byte{0};
    (*bytes)[1] = std::byte{1};
    return bytes;
}

std::vector<TopicInfo> sampleTopics() {
    std::vector<TopicInfo> topics(4);
    topics[0] = {.name = "/kurt3d/odom", .type = "nav_msgs/msg/Odometry"};
    topics[1] = {.name = "/kurt3d/points", .type = "sensor_msgs/msg/PointCloud2"};
    topics[2] = {.name = "/kurt3d/left/image/compressed", .type = "sensor_msgs/msg/CompressedImage"};
    topics[2].droppable = true;
    topics[3] = {.name = "/leitstand/victims", .type = "leitstand_msgs/msg/Victim"};
    for (TopicInfo& topic : topics) {
        topic.qosProfiles = qosProfilesOf({.depth = 10});
        topic.definition = "# the text of " + topic.type + "\nuint8[] data\n";
        topic.typeHash = "RIHS01_" + std::string(64, 'a');
    }
    return topics;
}

RawEvent sampleEvent(std::uint64_t sequence, std::size_t size) {
    // Most are small; a slice every tenth, a picture every seventh, a victim every hundredth.
    const std::size_t kind = sequence % 100 == 0 ? 3 : sequence % 10 == 0 ? 1 : sequence % 7 == 0 ? 2 : 0;
    constexpr std::size_t Sizes[] = {730, 50'000, 20'000, 300};
    static const std::vector<TopicInfo> topics = sampleTopics();
    return {sequence, at(static_cast<std::int64_t>(sequence) * 10), topics[kind].name, topics[kind].type,
            payload(size != 0 ? size : Sizes[kind], static_cast<unsigned>(sequence))};
}

void writeSession(const fs::path& mission, std::uint64_t first, std::uint64_t last,
                  const BagWriterSettings& settings) {
    auto opening = BagWriter::open(mission, settings);
    ASSERT_TRUE(opening.ok()) << opening.error().text;
    const auto writer = std::move(opening).value();
    for (const TopicInfo& topic : sampleTopics()) writer->addTopic(topic);
    for (std::uint64_t i = first; i <= last; ++i) {
        writer->write(sampleEvent(i));
        if (i % 500 != 0) continue;
        ASSERT_TRUE(writer->flush().ok());
    }
    const auto closed = writer->close();
    ASSERT_TRUE(closed.ok()) << closed.error().text;
}

namespace {

/// From now on, what is committed stays in the write-ahead log of the newest session: somebody reads what was
/// before, and no checkpoint goes past them. Where checkpoints fall by themselves depends on how the writer's
/// thread is served.
bool readOn(const fs::path& mission) {
    fs::path newest;
    for (const auto& entry : fs::directory_iterator(mission)) {
        if (entry.path().extension() == ".db3" && entry.path() > newest) newest = entry.path();
    }
    sqlite3* reader = nullptr;
    return sqlite3_open_v2(newest.c_str(), &reader, SQLITE_OPEN_READONLY, nullptr) == SQLITE_OK &&
           sqlite3_exec(reader, "BEGIN; SELECT count(*) FROM topics", nullptr, nullptr, nullptr) == SQLITE_OK;
}

}  // namespace

void writeUnclosedSession(const fs::path& mission, std::uint64_t first, std::uint64_t last,
                          const BagWriterSettings& settings, std::uint64_t flushEvery) {
    const pid_t child = fork();
    if (child == 0) {
        auto opening = BagWriter::open(mission, settings);
        if (!opening) _exit(1);
        const auto writer = std::move(opening).value();
        for (const TopicInfo& topic : sampleTopics()) writer->addTopic(topic);
        for (std::uint64_t i = first; i <= last; ++i) {
            const bool logged = i == last && settings.storage != BagStorage::Mcap;
            if (logged && !(writer->flush().ok() && readOn(mission))) _exit(2);
            writer->write(sampleEvent(i));
            if (flushEvery != 0 && i % flushEvery == 0 && !writer->flush().ok()) _exit(1);
        }
        _exit(writer->flush().ok() ? 0 : 1);  // nothing is closed
    }
    int status = 0;
    waitpid(child, &status, 0);
    ASSERT_TRUE(WIFEXITED(status) && WEXITSTATUS(status) == 0) << status;
}

std::vector<RawEvent> readAll(BagReader& reader, const BagQuery& query) {
    std::vector<RawEvent> events;
    BagCursor cursor = reader.read(query);
    while (auto event = cursor.next()) events.push_back(std::move(*event));
    return events;
}

std::unique_ptr<BagReader> opened(const fs::path& bag) {
    auto reader = BagReader::open(bag);
    EXPECT_TRUE(reader.ok()) << reader.error().text;
    return reader ? std::move(reader).value() : nullptr;
}

std::vector<std::uint64_t> sequences(const std::vector<RawEvent>& events) {
    std::vector<std::uint64_t> all;
    all.reserve(events.size());
    for (const RawEvent& event : events) all.push_back(event.sequence);
    return all;
}

std::size_t differing(const std::vector<RawEvent>& events, std::size_t size) {
    return static_cast<std::size_t>(
        std::count_if(events.begin(), events.end(), [size](const RawEvent& event) {
            const RawEvent expected = sampleEvent(event.sequence, size);
            return event.received != expected.received || event.topic != expected.topic ||
                   event.type != expected.type || *event.cdr != *expected.cdr;
        }));
}

std::string fingerprint(const fs::path& folder) {
    std::set<std::string> files;
    for (const auto& entry : fs::recursive_directory_iterator(folder)) {
        const std::string content = entry.is_regular_file() ? readText(entry.path()) : "";
        files.insert(fmt::format("{} {} {} {}\n", entry.path().string(), content.size(),
                                 entry.last_write_time().time_since_epoch().count(),
                                 std::hash<std::string>{}(content)));
    }
    return fmt::format("{}", fmt::join(files, ""));
}

}  // namespace leitstand::test
