#include <numeric>
#include <thread>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/io/bag/sample_bags.h"
#include "tests/support/temporary_folder.h"

namespace leitstand {
namespace {

using test::at;
using test::readAll;
using test::sampleEvent;
using test::sequences;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

std::vector<std::uint64_t> numbers(std::uint64_t first, std::uint64_t last) {
    std::vector<std::uint64_t> all(last - first + 1);
    std::iota(all.begin(), all.end(), first);
    return all;
}

std::uint64_t messages(const BagReader& reader, const std::string& topic) {
    for (const BagTopic& known : reader.topics()) {
        if (known.info.name == topic) return known.messages.value_or(0);
    }
    return 0;
}

/// The same in files of each kind.
class BagRoundTrip : public testing::TestWithParam<BagStorage> {
protected:
    [[nodiscard]] std::unique_ptr<BagWriter> newWriter() const {
        return std::move(BagWriter::open(m_mission, {.storage = GetParam()})).value();
    }
    void writeSession(std::uint64_t first, std::uint64_t last) const {
        test::writeSession(m_mission, first, last, {.storage = GetParam()});
    }
    [[nodiscard]] std::string nameOfFile(int number) const {
        return "mission_" + std::to_string(number) + std::string(endingOf(GetParam()));
    }
    const test::TemporaryFolder m_folder;
    const std::filesystem::path m_mission = m_folder / "mission";
};

TEST_P(BagRoundTrip, GivesBackWhatWasWritten) {
    writeSession(1, 2'000);
    const auto reader = test::opened(m_mission);
    EXPECT_THAT(reader->problems(), IsEmpty());
    EXPECT_TRUE(reader->ours());
    EXPECT_EQ(reader->first(), at(10));
    EXPECT_EQ(reader->last(), at(20'000));
    const auto events = readAll(*reader);
    EXPECT_EQ(sequences(events), numbers(1, 2'000));
    EXPECT_EQ(test::differing(events), 0U);
    EXPECT_EQ(messages(*reader, "/leitstand/victims"), 20U);
    EXPECT_EQ(messages(*reader, "/kurt3d/points"), 180U);
    for (const TopicInfo& expected : test::sampleTopics()) {
        const auto found =
            std::find_if(reader->topics().begin(), reader->topics().end(),
                         [&](const BagTopic& topic) { return topic.info.name == expected.name; });
        ASSERT_NE(found, reader->topics().end()) << expected.name;
        EXPECT_EQ(found->info.type, expected.type);
        EXPECT_EQ(found->info.qosProfiles, expected.qosProfiles);
        EXPECT_EQ(found->info.definition, expected.definition);
        EXPECT_EQ(found->info.typeHash, expected.typeHash);
    }
}

TEST_P(BagRoundTrip, EmptyAndLargeMessagesAndUnannouncedTopics) {
    {
        const auto writer = newWriter();
        writer->write({0, at(1), "/a", "std_msgs/msg/Empty", std::make_shared<std::vector<std::byte>>()});
        writer->write({0, at(2), "/b", "sensor_msgs/msg/Image", test::payload(20'000'000, 1)});
        writer->write({7, at(3), "/a", "std_msgs/msg/Empty", test::payload(4, 2)});
        writer->write({5, at(4), "/a", "std_msgs/msg/Empty", test::payload(4, 3)});  // does not rise
        ASSERT_TRUE(writer->flush().ok());
        EXPECT_EQ(writer->statistics().dropped.at("/a"), 1U);
        EXPECT_EQ(writer->statistics().writtenEvents, 3U);
    }
    const auto events = readAll(*test::opened(m_mission));
    EXPECT_THAT(sequences(events), ElementsAre(1, 2, 7));
    EXPECT_TRUE(events[0].cdr->empty());
    EXPECT_EQ(*events[1].cdr, *test::payload(20'000'000, 1));
}

TEST_P(BagRoundTrip, QueriesByTimeTopicAndSequence) {
    writeSession(1, 1'000);
    writeSession(1'001, 1'500);
    const auto reader = test::opened(m_mission);
    EXPECT_EQ(sequences(readAll(*reader, {.fromSequence = 990, .toSequence = 1'010})), numbers(990, 1'010));
    EXPECT_EQ(sequences(readAll(*reader, {.from = at(9'905), .to = at(10'200)})), numbers(991, 1'019));
    EXPECT_THAT(sequences(readAll(*reader, {.fromSequence = 850, .topics = {"/leitstand/victims"}})),
                ElementsAre(900, 1'000, 1'100, 1'200, 1'300, 1'400, 1'500));
    EXPECT_EQ(readAll(*reader, {.topics = {"/leitstand/victims", "/kurt3d/points"}}).size(), 150U);
    EXPECT_THAT(readAll(*reader, {.topics = {"/nobody"}}), IsEmpty());
    EXPECT_THAT(readAll(*reader, {.from = at(15'001)}), IsEmpty());
    EXPECT_EQ(reader->event(1'234)->sequence, 1'234U);
    EXPECT_FALSE(reader->event(1'501).has_value());
    EXPECT_FALSE(reader->event(0).has_value());
    EXPECT_EQ(reader->lastUpTo("/leitstand/victims", 1'199)->sequence, 1'100U);
    EXPECT_EQ(reader->lastUpTo("/leitstand/victims", 1'050)->sequence, 1'000U);
    EXPECT_FALSE(reader->lastUpTo("/leitstand/victims", 99).has_value());
    EXPECT_EQ(reader->sequenceAt(at(0)), 1U);
    EXPECT_EQ(reader->sequenceAt(at(10'005)), 1'001U);
    EXPECT_EQ(reader->sequenceAt(at(15'001)), 1'501U);
}

TEST_P(BagRoundTrip, AResumeWritesANewFileAndLeavesTheOldOneAsItIs) {
    writeSession(1, 300);
    const auto first = m_mission / nameOfFile(0);
    const std::string before = test::readText(first);
    const auto writer = newWriter();
    EXPECT_EQ(writer->file(), m_mission / nameOfFile(1));
    EXPECT_EQ(writer->earlierSequence(), 300U);
    RawEvent next = sampleEvent(301);
    next.sequence = 0;  // numbered on
    writer->write(next);
    ASSERT_TRUE(writer->close().ok());
    EXPECT_EQ(test::readText(first), before);

    const auto reader = test::opened(m_mission);
    EXPECT_EQ(reader->sessions().size(), 2U);
    EXPECT_EQ(sequences(readAll(*reader)), numbers(1, 301));
    EXPECT_EQ(messages(*reader, "/leitstand/victims"), 3U);
    EXPECT_FALSE(std::filesystem::exists(m_mission / "mission_1.db3-wal"));
    const std::string metadata = test::readText(m_mission / "metadata.yaml");
    EXPECT_THAT(metadata, HasSubstr("message_count: 301"));
    EXPECT_THAT(metadata, HasSubstr("- " + nameOfFile(0)));
    EXPECT_THAT(metadata, HasSubstr("- " + nameOfFile(1)));
}

TEST_P(BagRoundTrip, CountsKnowOfGapsWhereEventsWereDropped) {
    {
        const auto writer = newWriter();
        for (const std::uint64_t sequence : {1U, 2U, 70U}) {
            writer->write({sequence, at(1), "/a", "x/msg/A", test::payload(10, 1)});
        }
    }
    writeSession(100, 104);
    const auto reader = test::opened(m_mission);
    EXPECT_EQ(reader->sessions()[0].messages, 3U);
    EXPECT_EQ(reader->sessions()[1].messages, 5U);
    const std::string metadata = test::readText(m_mission / "metadata.yaml");
    EXPECT_THAT(metadata, HasSubstr("message_count: 8"));
    EXPECT_THAT(metadata, HasSubstr("message_count: 3"));
    EXPECT_THAT(metadata, testing::Not(HasSubstr("message_count: 70")));
}

TEST_P(BagRoundTrip, AMissionHasOneWriter) {
    const auto writer = newWriter();
    const auto second = BagWriter::open(m_mission);
    ASSERT_FALSE(second.ok());
    EXPECT_THAT(second.error().text, HasSubstr("another program records"));
}

TEST_P(BagRoundTrip, IsReadWhileItIsWritten) {
    writeSession(1, 100);
    const auto writer = newWriter();
    for (std::uint64_t i = 101; i <= 400; ++i) writer->write(sampleEvent(i));
    ASSERT_TRUE(writer->flush().ok());
    {
        const auto reader = test::opened(m_mission);
        EXPECT_FALSE(reader->sessions().back().closed);
        EXPECT_EQ(sequences(readAll(*reader)), numbers(1, 400));
        for (std::uint64_t i = 401; i <= 500; ++i) writer->write(sampleEvent(i));
        ASSERT_TRUE(writer->flush().ok());
        EXPECT_EQ(sequences(readAll(*reader)), numbers(1, 500));
        EXPECT_EQ(reader->event(450)->sequence, 450U);
    }
    ASSERT_TRUE(writer->close().ok());
    EXPECT_FALSE(std::filesystem::exists(m_mission / "mission_1.db3-wal"));
    EXPECT_EQ(readAll(*test::opened(m_mission)).size(), 500U);
}

TEST_P(BagRoundTrip, WhatAKilledWriterLeftIsReadAndNothingIsChanged) {
    writeSession(1, 200);
    test::writeUnclosedSession(m_mission, 201, 900, {.storage = GetParam()});
    if (GetParam() == BagStorage::Sqlite) {
        ASSERT_GT(std::filesystem::file_size(m_mission / "mission_1.db3-wal"), 100'000U);
    }
    const std::string before = test::fingerprint(m_mission);
    {
        const auto reader = test::opened(m_mission);
        EXPECT_THAT(reader->problems(), IsEmpty());
        EXPECT_FALSE(reader->sessions()[1].closed);
        const auto events = readAll(*reader);
        EXPECT_EQ(sequences(events), numbers(1, 900));
        EXPECT_EQ(test::differing(events), 0U);
        EXPECT_EQ(messages(*reader, "/leitstand/victims"), 9U);  // though nobody told metadata.yaml
        EXPECT_EQ(reader->lastUpTo("/leitstand/victims", 899)->sequence, 800U);
    }
    EXPECT_EQ(test::fingerprint(m_mission), before);

    writeSession(901, 950);
    EXPECT_EQ(sequences(readAll(*test::opened(m_mission))), numbers(1, 950));
    EXPECT_THAT(test::readText(m_mission / "metadata.yaml"), HasSubstr("message_count: 950"));
}

TEST_P(BagRoundTrip, ManyThreadsWriteAndNothingWaitsOrIsLost) {
    const auto writer = newWriter();
    {
        std::vector<std::jthread> threads;
        threads.reserve(4);
        for (int t = 0; t < 4; ++t) {
            threads.emplace_back([&writer] {
                for (int i = 0; i < 500; ++i)
                    writer->write({0, at(i), "/a", "x/msg/A", test::payload(1'000, 1)});
            });
        }
    }
    ASSERT_TRUE(writer->close().ok());
    EXPECT_EQ(readAll(*test::opened(m_mission)).size(), 2'000U);
}

TEST_P(BagRoundTrip, TheNextSessionIsStoredAsTheEarlierOnesAre) {
    writeSession(1, 10);
    {
        const auto writer = std::move(BagWriter::open(m_mission)).value();
        EXPECT_EQ(writer->file().filename(), nameOfFile(1));
    }
    const BagStorage other = GetParam() == BagStorage::Mcap ? BagStorage::Sqlite : BagStorage::Mcap;
    const std::string before = test::fingerprint(m_mission);
    const auto refused = BagWriter::open(m_mission, {.storage = other});
    ASSERT_FALSE(refused.ok());
    EXPECT_THAT(refused.error().text, HasSubstr("all sessions of a mission are stored alike"));
    EXPECT_EQ(test::fingerprint(m_mission), before);
}

TEST_P(BagRoundTrip, AFileOfTheOtherKindBesideASessionHindersNobody) {
    writeSession(1, 10);
    const BagStorage other = GetParam() == BagStorage::Mcap ? BagStorage::Sqlite : BagStorage::Mcap;
    test::writeText(m_mission / ("copy" + std::string(endingOf(other))), "of whatever");
    {
        const auto writer = std::move(BagWriter::open(m_mission)).value();
        EXPECT_EQ(writer->file().filename(), nameOfFile(1));
        EXPECT_EQ(writer->earlierSequence(), 10U);
    }
    EXPECT_EQ(sequences(readAll(*test::opened(m_mission))), numbers(1, 10));
}

TEST_P(BagRoundTrip, TimesThatFallAreReadByRisingSequence) {
    {
        const auto writer = newWriter();
        for (const auto& [sequence, time] : {std::pair{1U, 500}, std::pair{2U, 100}, std::pair{3U, 300}})
            writer->write({sequence, at(time), "/a", "x/msg/A", test::payload(10, sequence)});
    }
    const auto reader = test::opened(m_mission);
    EXPECT_THAT(sequences(readAll(*reader)), ElementsAre(1, 2, 3));
    EXPECT_THAT(sequences(readAll(*reader, {.to = at(400)})), ElementsAre(2, 3));
    EXPECT_EQ(reader->sequenceAt(at(200)), 3U);
}

INSTANTIATE_TEST_SUITE_P(Storage, BagRoundTrip, testing::Values(BagStorage::Sqlite, BagStorage::Mcap),
                         [](const auto& one) { return std::string(nameOf(one.param)); });

}  // namespace
}  // namespace leitstand
