#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

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

// Neither SQLite's build, nor the schema, nor the texts, nor the decoder are ours there.
TEST(BagPeer, ListsOurBagAndDecodesEveryMessage) {
    const TemporaryFolder folder;
    const auto mission = folder / "mission";
    std::size_t types = 0;
    {
        const auto writer = std::move(BagWriter::open(mission)).value();
        const auto samples = sampleCases();
        for (const SampleCase& one : samples) {
            const MessageType* type = findMessageType(one.type);
            ASSERT_NE(type, nullptr) << one.type;
            TopicInfo topic;
            topic.name = eventOf(one).topic;
            topic.type = one.type;
            topic.qosProfiles = qosProfilesOf({.depth = 10});
            topic.definition = std::string(type->definition);
            topic.typeHash = std::string(type->hash);
            writer->addTopic(topic);
            for (int round = 0; round < Rounds; ++round) writer->write(eventOf(one));
        }
        types = samples.size();
        const auto closed = writer->close();
        ASSERT_TRUE(closed.ok()) << closed.error().text;
    }
    const auto tests = std::filesystem::path(sourceFolder()) / "tests";
    const auto outcome = runProcess(
        tests / "npm" / "run", {(tests / "bag_peer" / "read_bag.js").string(),
                                (mission / "mission_0.db3").string(), (mission / "metadata.yaml").string()});
    LEITSTAND_NEEDS(outcome);
    ASSERT_EQ(outcome.exitCode, 0) << outcome.out << outcome.err;
    EXPECT_THAT(outcome.out, testing::HasSubstr(fmt::format("\"messages\":{}", types * Rounds)));
    EXPECT_THAT(outcome.out, testing::HasSubstr("\"file\":\"mission_0.db3\""));
}

}  // namespace
}  // namespace leitstand::test
