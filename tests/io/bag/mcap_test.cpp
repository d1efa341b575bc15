// Bags in MCAP files: with an index and without, compressed and not, cut off and damaged.
#include <filesystem>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <zstd.h>

#include "core/io/bag/bag_conversion.h"
#include "core/io/bag/mcap/mcap_sequences.h"
#include "core/io/bag/mcap/mcap_writer.h"
#include "tests/io/bag/foreign_database.h"
#include "tests/io/bag/mcap_bytes.h"
#include "tests/io/bag/sample_bags.h"
#include "tests/support/temporary_folder.h"

namespace leitstand {
namespace {

namespace fs = std::filesystem;
using test::McapText;
using test::opened;
using test::readAll;
using testing::Contains;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

/// A CDR header, and @p what.
std::string cdr(const std::string& what) {
    return std::string("\0\1\0\0", 4) + what;
}

/// "/a first" of each event.
std::vector<std::string> told(const std::vector<RawEvent>& events) {
    std::vector<std::string> all;
    for (const RawEvent& event : events) {
        const auto* const bytes = reinterpret_cast<const char*>(event.cdr->data());
        all.push_back(event.topic + " " + std::string(bytes + 4, bytes + event.cdr->size()));
    }
    return all;
}

class McapBag : public testing::Test {
protected:
    McapBag() {
        m_early = McapText::message(1, 1'000, cdr("first")) + McapText::message(2, 3'000, cdr("third"));
        m_late = McapText::message(1, 2'000, cdr("second")) + McapText::message(1, 4'000, cdr("fourth"));
    }
    using Index = std::map<int, std::vector<std::pair<std::uint64_t, std::uint64_t>>>;
    /// Where the messages are in a chunk that begins with @p before bytes and goes on with m_early, m_late.
    [[nodiscard]] Index early(std::size_t before) const {
        const std::size_t one = McapText::message(1, 0, cdr("first")).size();
        return {{1, {{1'000, before}}}, {2, {{3'000, before + one}}}};
    }
    [[nodiscard]] Index late(std::size_t before) const {
        const std::size_t one = McapText::message(1, 0, cdr("second")).size();
        return {{1, {{2'000, before}, {4'000, before + one}}}};
    }
    [[nodiscard]] std::string errorOf(const fs::path& path) const {
        const auto reader = BagReader::open(path);
        return reader ? "" : reader.error().text;
    }
    void expectAll(const McapText& text, const char* what) const {
        text.write(m_file);
        const auto reader = opened(m_file);
        ASSERT_NE(reader, nullptr) << what;
        EXPECT_THAT(told(readAll(*reader)), ElementsAre("/a first", "/a second", "/b third", "/a fourth"))
            << what;
        EXPECT_THAT(reader->problems(), IsEmpty()) << what;
    }

    const test::TemporaryFolder m_folder;
    const fs::path m_file = m_folder / "bag_0.mcap";
    std::string m_early, m_late;
};

TEST_F(McapBag, IsReadByItsIndexInTheOrderOfLogTimes) {
    const std::string described = McapText::described();
    for (const char* compression : {"", "lz4", "zstd"}) {
        McapText text;
        text.chunk(described + m_early, compression, early(described.size()))
            .chunk(m_late, compression, late(0))
            .end(true, 4);
        expectAll(text, compression);
    }
}

TEST_F(McapBag, IsReadWithoutAnIndexOrASummaryOrChunks) {
    const std::string described = McapText::described();
    expectAll(McapText().chunk(described + m_early, "zstd").chunk(m_late, "lz4").end(true, 4),
              "no message index");
    expectAll(McapText()
                  .chunk(described + m_early, "zstd", early(described.size()))
                  .chunk(m_late, "", late(0))
                  .end(false),
              "no summary");
    expectAll(McapText().chunk(described + m_early).chunk(m_late).end(false), "neither");
    McapText loose;
    const auto add = [&](const std::string& records) {
        for (std::size_t at = 0; at < records.size();) {
            const auto length = static_cast<std::size_t>(static_cast<unsigned char>(records[at + 1]));
            loose.record(records[at], records.substr(at + 9, length));
            at += 9 + length;
        }
    };
    add(described + m_early + m_late);
    expectAll(loose.end(false), "no chunks");
}

TEST_F(McapBag, TopicsHaveTypeQosDefinitionAndCounts) {
    McapText().chunk(McapText::described() + m_early + m_late).end(true, 4).write(m_file);
    const auto reader = opened(m_file);
    ASSERT_EQ(reader->topics().size(), 2U);
    const BagTopic& a = reader->topics().front();
    EXPECT_EQ(a.info.name, "/a");
    EXPECT_EQ(a.info.type, "std_msgs/msg/String");
    EXPECT_EQ(a.info.definition, "string data");
    EXPECT_EQ(a.info.qosProfiles, "[]");
    EXPECT_EQ(a.messages, 3U);
    EXPECT_FALSE(reader->ours());
    EXPECT_EQ(reader->first(), Time(std::chrono::nanoseconds(1'000)));
    EXPECT_EQ(reader->last(), Time(std::chrono::nanoseconds(4'000)));
    EXPECT_TRUE(reader->sessions().front().closed);
}

TEST_F(McapBag, AnswersQueries) {
    McapText().chunk(McapText::described() + m_early + m_late, "zstd").end(true, 4).write(m_file);
    const auto reader = opened(m_file);
    EXPECT_THAT(told(readAll(*reader, {.topics = {"/b"}})), ElementsAre("/b third"));
    EXPECT_THAT(told(readAll(*reader, {.fromSequence = 2, .toSequence = 3})),
                ElementsAre("/a second", "/b third"));
    EXPECT_THAT(told(readAll(*reader, {.from = Time(std::chrono::nanoseconds(2'000)),
                                       .to = Time(std::chrono::nanoseconds(4'000))})),
                ElementsAre("/a second", "/b third"));
    EXPECT_EQ(reader->sequenceAt(Time(std::chrono::nanoseconds(2'500))), 3U);
    EXPECT_EQ(reader->sequenceAt(Time(std::chrono::nanoseconds(9'000))), 5U);
    EXPECT_EQ(told({*reader->lastUpTo("/a", 3)}).front(), "/a second");
    EXPECT_FALSE(reader->lastUpTo("/b", 2));
    EXPECT_EQ(told({*reader->event(4)}).front(), "/a fourth");
    EXPECT_FALSE(reader->event(5));
}

TEST_F(McapBag, OneThatIsCutOffIsReadAsFarAsItGoes) {
    const std::string described = McapText::described();
    const std::string whole = McapText()
                                  .chunk(described + m_early, "zstd", early(described.size()))
                                  .chunk(m_late, "", late(0))
                                  .bytes();
    const std::size_t one =
        McapText().chunk(described + m_early, "zstd").bytes().size();  // without its indexes
    for (std::size_t size = McapText::Magic.size(); size < whole.size(); ++size) {
        test::writeText(m_file, whole.substr(0, size));
        const auto reader = opened(m_file);
        ASSERT_NE(reader, nullptr) << size;
        const auto events = told(readAll(*reader));
        EXPECT_FALSE(reader->sessions().front().closed) << size;
        EXPECT_THAT(reader->problems(), testing::Not(IsEmpty())) << size;
        if (size < one) continue;
        EXPECT_THAT(events, Contains("/a first")) << size;
        EXPECT_THAT(events, Contains("/b third")) << size;
    }
    test::writeText(m_file, whole.substr(0, whole.size() - late(0).size()));
    EXPECT_EQ(readAll(*opened(m_file)).size(), 4U) << "of the cut index nothing is needed";
}

TEST_F(McapBag, AChunkThatIsListedAgainAndAgainIsReadOnce) {
    const std::string described = McapText::described();
    McapText text;
    text.chunk(described + m_early + m_late);
    const std::string index = McapText::number(0, 16) + McapText::number(text.chunkAt(), 8) +
                              McapText::number(text.bytes().size() - text.chunkAt(), 8) + McapText::text("") +
                              McapText::number(0, 8) + McapText::text("") + McapText::number(0, 16);
    text.record(15, McapText::number(0, 4));
    const std::size_t summary = text.bytes().size();
    for (int i = 0; i < 1'000; ++i) text.record(8, index);
    text.record(2, McapText::number(summary, 8) + McapText::number(0, 12));
    test::writeText(m_file, text.bytes() + McapText::Magic);
    EXPECT_EQ(readAll(*opened(m_file)).size(), 4U);
}

TEST_F(McapBag, MessagesThatAreCountedAndNotThereAreMissed) {
    McapText().chunk(McapText::described() + m_early + m_late).end(true, 9).write(m_file);
    const auto reader = opened(m_file);
    EXPECT_EQ(readAll(*reader).size(), 4U);
    EXPECT_THAT(reader->problems(), Contains(HasSubstr("5 are missing")));
    EXPECT_EQ(reader->sessions().front().missing, 5U);
}

TEST_F(McapBag, ADamagedChunkIsNamedAndTheOthersAreRead) {
    const std::string described = McapText::described();
    McapText text;
    text.chunk(described + m_early, "zstd", early(described.size()))
        .chunk(m_late, "zstd", late(0), false)
        .end(true, 4)
        .write(m_file);
    const auto reader = opened(m_file);
    EXPECT_THAT(told(readAll(*reader)), ElementsAre("/a first", "/b third"));
    EXPECT_THAT(reader->problems(), Contains(HasSubstr("its checksum is wrong")));
    EXPECT_THAT(reader->problems(), Contains(HasSubstr("bag_0.mcap: byte ")));
}

TEST_F(McapBag, HostileNumbersAreRefused) {
    const auto tells = [&](const std::string& bytes) {
        test::writeText(m_file, bytes);
        const auto reader = opened(m_file);
        (void)readAll(*reader);
        return reader->problems();
    };
    const std::string huge = McapText::number(~0ULL, 8), magic = McapText::Magic;
    EXPECT_THAT(tells(magic + "\x06" + huge), Contains(HasSubstr("ends within this record")));
    EXPECT_THAT(tells(magic + "\x04" + huge), Contains(HasSubstr("ends within this record")));
    // A chunk that claims an exabyte, and one that unpacks to more than it says.
    std::string bomb(1U << 20U, '\0'), packed(4096, '\0');
    packed.resize(ZSTD_compress(packed.data(), packed.size(), bomb.data(), bomb.size(), 19));
    const auto chunk = [&](std::uint64_t size) {
        return McapText()
            .record(6, McapText::number(0, 16) + McapText::number(size, 8) + McapText::number(0, 4) +
                           McapText::text("zstd") + McapText::number(packed.size(), 8) + packed)
            .end(false)
            .bytes();
    };
    EXPECT_THAT(tells(chunk(1ULL << 60U)), Contains(HasSubstr("expected a chunk of")));
    EXPECT_THAT(tells(chunk(100)), Contains(HasSubstr("expected a chunk of 100 bytes")));
    EXPECT_THAT(tells(McapText().chunk("", "brotli").end(false).bytes()),
                Contains(HasSubstr("found \"brotli\"")));
    // Indexes that lead nowhere.
    EXPECT_THAT(
        tells(McapText().chunk(McapText::described(), "", {{1, {{1, ~0ULL}, {2, 3}}}}).end(false).bytes()),
        Contains(HasSubstr("expected a message where the index says")));
}

TEST_F(McapBag, WhatIsNoMcapFileIsSaid) {
    test::writeText(m_file, "not at all");
    EXPECT_THAT(errorOf(m_file), HasSubstr("bag_0.mcap: byte 0: expected the beginning of an MCAP file"));
    test::writeText(m_file, "");
    EXPECT_THAT(errorOf(m_file), HasSubstr("empty"));
}

TEST_F(McapBag, MessagesThatAreNoCdrAreLeftOutAndNamed) {
    const std::string other =
        McapText::recordOf(4, McapText::number(3, 2) + McapText::number(0, 2) + McapText::text("/c") +
                                  McapText::text("ros1") + McapText::text(""));
    McapText()
        .chunk(McapText::described() + other + McapText::message(3, 1, "x") + m_early)
        .end(false)
        .write(m_file);
    const auto reader = opened(m_file);
    EXPECT_EQ(readAll(*reader).size(), 2U);
    EXPECT_THAT(reader->problems(),
                Contains(HasSubstr("topic /c: expected serialization \"cdr\", found \"ros1\"")));
}

TEST_F(McapBag, AConvertedMissionStaysAMissionThereAndBack) {
    test::writeSession(m_folder / "mission", 1, 200);
    test::writeSession(m_folder / "mission", 301, 400);  // numbers are missing between the sessions
    const auto mission = readAll(*opened(m_folder / "mission"));
    const auto there = convertBag(m_folder / "mission", m_folder / "mcap", BagStorage::Mcap);
    ASSERT_TRUE(there) << there.error().text;
    EXPECT_EQ(there->messages, 300U);
    EXPECT_TRUE(fs::exists(m_folder / "mcap" / "mcap_0.mcap"));
    const auto mcap = opened(m_folder / "mcap");
    EXPECT_THAT(mcap->problems(), IsEmpty());
    EXPECT_TRUE(mcap->ours());
    EXPECT_EQ(test::differing(readAll(*mcap)), 0U);
    EXPECT_EQ(test::sequences(readAll(*mcap)), test::sequences(mission));
    const auto whole = opened(m_folder / "mission");
    ASSERT_EQ(mcap->topics().size(), whole->topics().size());
    for (std::size_t i = 0; i < mcap->topics().size(); ++i) {
        const BagTopic &was = whole->topics()[i], &is = mcap->topics()[i];
        EXPECT_EQ(is.info.name, was.info.name);
        EXPECT_EQ(is.info.type, was.info.type);
        EXPECT_EQ(is.info.qosProfiles, was.info.qosProfiles);
        EXPECT_EQ(is.info.definition, was.info.definition);
        EXPECT_EQ(is.info.typeHash, was.info.typeHash);
        EXPECT_EQ(is.messages, was.messages);
    }
    const auto back = convertBag(m_folder / "mcap", m_folder / "back", BagStorage::Sqlite);
    ASSERT_TRUE(back) << back.error().text;
    const auto again = opened(m_folder / "back");
    EXPECT_TRUE(again->ours());
    EXPECT_EQ(test::differing(readAll(*again)), 0U);
    EXPECT_EQ(test::sequences(readAll(*again)), test::sequences(mission));
    // It is gone on with, too.
    test::writeSession(m_folder / "mcap", 401, 410, {.storage = BagStorage::Mcap});
    EXPECT_EQ(test::sequences(readAll(*opened(m_folder / "mcap"))).back(), 410U);
}

TEST_F(McapBag, ACopyOfAMissionWithoutSequencesIsForOtherPrograms) {
    test::writeSession(m_folder / "mission", 1, 300);
    const auto mission = opened(m_folder / "mission");
    auto writer = std::move(McapWriter::create(m_file, McapWriter::Sequences::Dropped)).value();
    for (const RawEvent& event : readAll(*mission)) {
        for (const BagTopic& topic : mission->topics()) {
            if (topic.info.name == event.topic) writer.write(topic.info, event);
        }
    }
    ASSERT_TRUE(writer.close().ok());
    EXPECT_FALSE(opened(m_file)->ours());
    const auto back = convertBag(m_file, m_folder / "back", BagStorage::Sqlite);
    ASSERT_FALSE(back) << "finds would name other messages";
    EXPECT_THAT(back.error().text, HasSubstr("expected the mission itself"));
    EXPECT_FALSE(fs::exists(m_folder / "back"));
}

/// A mission's file of one chunk, whose sequences are @p stated.
std::string missionOf(const std::string& records, const detail::McapSequences& stated) {
    return McapText()
        .record(0x80, detail::McapSequences().content())
        .record(0x80, stated.content())
        .chunk(records)
        .end(false)
        .bytes();
}

TEST_F(McapBag, HostileSequencesNeitherCrashNorMakeUpMessages) {
    const auto read = [&](const std::string& bytes) {
        test::writeText(m_file, bytes);
        return test::sequences(readAll(*opened(m_file)));
    };
    const auto problems = [&] { return opened(m_file)->problems(); };
    const std::string records = McapText::described() + m_early + m_late;
    detail::McapSequences right, few, twice, huge;
    for (const std::uint64_t one : {7U, 8U, 9U, 20U}) right.add(one);
    for (const std::uint64_t one : {7U, 8U}) few.add(one);
    for (const std::uint64_t one : {7U, 8U, 8U, 9U}) twice.add(one);
    huge.add(~0ULL);
    EXPECT_THAT(read(missionOf(records, right)), ElementsAre(7, 8, 9, 20));
    EXPECT_THAT(problems(), IsEmpty());
    EXPECT_THAT(read(missionOf(records, few)), ElementsAre(7, 8));
    EXPECT_THAT(problems(), Contains(HasSubstr("expected sequences of 4 messages, found 2")));
    EXPECT_THAT(read(missionOf(records, twice)), ElementsAre(7, 8, 9));
    EXPECT_THAT(problems(), Contains(HasSubstr("a sequence of its own for each message; 1 are left out")));
    EXPECT_THAT(read(missionOf(records, huge)), IsEmpty());
    // Counts that claim the whole memory, and records that end within a number.
    const std::string name = detail::McapSequences().content();
    const auto record = [&](const std::string& content) {
        return McapText().record(0x80, name).record(0x80, content);
    };
    for (const std::string& content :
         {name + McapText::number(1, 8) + McapText::number(~0U, 4),
          name + McapText::number(0, 8) + McapText::number(4, 4), name + McapText::number(1, 8),
          name + McapText::number(1, 8) + McapText::number(0, 4), std::string(3, '\1')})
        EXPECT_THAT(read(record(content).chunk(records).end(false).bytes()), IsEmpty());
    // A record of the same number by another program is none of ours.
    EXPECT_THAT(read(McapText().record(0x80, "theirs").chunk(records).end(false).bytes()),
                ElementsAre(1, 2, 3, 4));
}

TEST_F(McapBag, AMissionThatIsCutOffAnywhereKeepsItsNumbers) {
    test::writeSession(m_folder / "mission", 1, 60, {.storage = BagStorage::Mcap});
    const std::string whole = test::readText(m_folder / "mission" / "mission_0.mcap");
    std::size_t most = 0;
    for (std::size_t size = McapText::Magic.size(); size <= whole.size(); size += 1 + size / 40) {
        test::writeText(m_file, whole.substr(0, size));
        const auto events = readAll(*opened(m_file));
        EXPECT_GE(events.size(), most) << size;
        most = events.size();
        for (std::size_t i = 0; i < events.size(); ++i) ASSERT_EQ(events[i].sequence, i + 1) << size;
        EXPECT_EQ(test::differing(events), 0U) << size;
    }
    EXPECT_GT(most, 0U);
}

TEST_F(McapBag, BagsOfOthersAreConvertedThereAndBack) {
    McapText().chunk(McapText::described() + m_early + m_late, "lz4").end(true, 4).write(m_file);
    ASSERT_TRUE(convertBag(m_file, m_folder / "database", BagStorage::Sqlite));
    ASSERT_TRUE(convertBag(m_folder / "database", m_folder / "again", BagStorage::Mcap));
    for (const char* copy : {"database", "again"})
        EXPECT_THAT(told(readAll(*opened(m_folder / copy))),
                    ElementsAre("/a first", "/a second", "/b third", "/a fourth"))
            << copy;
    EXPECT_EQ(opened(m_folder / "again")->topics().front().info.definition, "string data");
}

TEST_F(McapBag, IsNeverConvertedOverWhatIsThere) {
    test::writeSession(m_folder / "mission", 1, 3);
    const auto refused = convertBag(m_folder / "mission", m_folder / "mission", BagStorage::Mcap);
    ASSERT_FALSE(refused);
    EXPECT_THAT(refused.error().text, HasSubstr("expected a folder that does not exist yet"));
    const auto within =
        convertBag(m_folder / "mission", m_folder / "mission" / "robots" / "x", BagStorage::Mcap);
    ASSERT_FALSE(within);
    EXPECT_THAT(within.error().text, HasSubstr("expected a folder outside of the bag"));
    EXPECT_FALSE(convertBag(m_folder / "absent", m_folder / "out", BagStorage::Mcap));
    EXPECT_FALSE(fs::exists(m_folder / "out"));
}

TEST_F(McapBag, TheFolderOfABagIsReadByItsMetadata) {
    const fs::path bag = m_folder / "walk";
    fs::create_directory(bag);
    McapText().chunk(McapText::described() + m_early).end(true, 2).write(bag / "walk_0.mcap");
    McapText().chunk(McapText::described() + m_late).end(true, 2).write(bag / "walk_1.mcap");
    test::writeText(bag / "metadata.yaml",
                    "rosbag2_bagfile_information:\n  version: 9\n  storage_identifier: mcap\n"
                    "  relative_file_paths: [walk_0.mcap, walk_1.mcap]\n");
    const auto reader = opened(bag);
    ASSERT_NE(reader, nullptr);
    EXPECT_THAT(reader->problems(), IsEmpty());
    EXPECT_EQ(readAll(*reader).size(), 4U);
    EXPECT_EQ(reader->lastSequence(), 4U);
    EXPECT_EQ(reader->sessions().size(), 2U);
}

TEST_F(McapBag, MessagesCompressedByZstdAreReadOfAnyBag) {
    std::string packed(200, '\0');
    const std::string plain = cdr("small");
    packed.resize(ZSTD_compress(packed.data(), packed.size(), plain.data(), plain.size(), 3));
    McapText()
        .chunk(McapText::described() + McapText::message(1, 5, packed) +
               McapText::message(1, 6, packed.substr(0, 9)))
        .end(true, 2)
        .write(m_file);
    const auto reader = opened(m_file);
    EXPECT_THAT(told(readAll(*reader)), ElementsAre("/a small"));
    EXPECT_THAT(reader->problems(), Contains(HasSubstr("found one that is damaged")));
}

}  // namespace
}  // namespace leitstand
