#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/io/bag/bag_conversion.h"
#include "core/io/bag/bag_reader.h"
#include "core/io/bag/bag_writer.h"
#include "tests/support/missing_tool.h"
#include "tests/support/places.h"
#include "tests/support/process.h"
#include "tests/support/samples.h"
#include "tests/support/temporary_folder.h"
#include "transport/convert/encode.h"
#include "transport/convert/message_catalog.h"

namespace leitstand::test {
namespace {

constexpr int Rounds = 3;

/// One event of @p one, on a topic of its type alone.
RawEvent eventOf(const SampleCase& one) {
    const auto payload = encode(one.sample, one.type);
    EXPECT_TRUE(payload.ok()) << payload.error().text;
    std::string topic = "/peer/" + one.type.substr(one.type.rfind('/') + 1);
    return {0, Time(std::chrono::seconds(1'700'000'000)), std::move(topic), one.type, *payload};
}

/// Writes a mission with messages of all types into @p mission. Returns their number.
std::size_t writeAllTypes(const std::filesystem::path& mission) {
    const auto writer = std::move(BagWriter::open(mission)).value();
    const auto samples = sampleCases();
    for (const SampleCase& one : samples) {
        const MessageType* type = findMessageType(one.type);
        EXPECT_NE(type, nullptr) << one.type;
        if (type == nullptr) continue;
        TopicInfo topic;
        topic.name = eventOf(one).topic;
        topic.type = one.type;
        topic.qosProfiles = qosProfilesOf({.depth = 10});
        topic.definition = std::string(type->definition);
        topic.typeHash = std::string(type->hash);
        writer->addTopic(topic);
        for (int round = 0; round < Rounds; ++round) writer->write(eventOf(one));
    }
    const auto closed = writer->close();
    EXPECT_TRUE(closed.ok()) << closed.error().text;
    return samples.size() * Rounds;
}

std::filesystem::path peers() {
    return std::filesystem::path(sourceFolder()) / "tests" / "bag_peer";
}

ProcessOutcome node(std::vector<std::string> arguments) {
    return runProcess(peers().parent_path() / "npm" / "run", arguments);
}

// Neither SQLite's build, nor the schema, nor the texts, nor the decoder are ours there.
TEST(BagPeer, ListsOurBagAndDecodesEveryMessage) {
    const TemporaryFolder folder;
    const auto mission = folder / "mission";
    const std::size_t messages = writeAllTypes(mission);
    const auto outcome = node({(peers() / "read_bag.js").string(), (mission / "mission_0.db3").string(),
                               (mission / "metadata.yaml").string()});
    LEITSTAND_NEEDS(outcome);
    ASSERT_EQ(outcome.exitCode, 0) << outcome.out << outcome.err;
    EXPECT_THAT(outcome.out, testing::HasSubstr(fmt::format("\"messages\":{}", messages)));
    EXPECT_THAT(outcome.out, testing::HasSubstr("\"file\":\"mission_0.db3\""));
}

TEST(BagPeer, ListsOurMcapFileAndDecodesEveryMessage) {
    const TemporaryFolder folder;
    const std::size_t messages = writeAllTypes(folder / "mission");
    const auto converted = convertBag(folder / "mission", folder / "mcap", BagStorage::Mcap);
    ASSERT_TRUE(converted) << converted.error().text;
    const auto outcome =
        node({(peers() / "read_mcap.js").string(), (folder / "mcap" / "mcap_0.mcap").string()});
    LEITSTAND_NEEDS(outcome);
    ASSERT_EQ(outcome.exitCode, 0) << outcome.out << outcome.err;
    EXPECT_THAT(outcome.out, testing::HasSubstr(fmt::format("\"messages\":{}", messages)));
}

TEST(BagPeer, McapFilesOfTheFormatsOwnWriterAreRead) {
    const TemporaryFolder folder;
    for (const char* how : {"chunked", "plain"}) {
        const auto file = folder / (std::string(how) + ".mcap");
        const auto outcome = node({(peers() / "write_mcap.js").string(), file.string(), how});
        LEITSTAND_NEEDS(outcome);
        ASSERT_EQ(outcome.exitCode, 0) << outcome.out << outcome.err;
        auto reader = BagReader::open(file);
        ASSERT_TRUE(reader) << reader.error().text;
        EXPECT_THAT((*reader)->problems(), testing::IsEmpty()) << how;
        int number = 0;
        auto cursor = (*reader)->read();
        for (auto event = cursor.next(); event; event = cursor.next(), ++number) {
            EXPECT_EQ(event->topic, number % 2 == 0 ? "/talk" : "/walk");
            const std::string bytes(reinterpret_cast<const char*>(event->cdr->data()), event->cdr->size());
            EXPECT_EQ(bytes.substr(8), fmt::format("number {}", number) + '\0');
        }
        EXPECT_EQ(number, 500) << how;
        EXPECT_EQ((*reader)->topics().front().messages, 250U);
        EXPECT_TRUE((*reader)->sessions().front().closed);
    }
}

}  // namespace
}  // namespace leitstand::test
