#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <zstd.h>

#include "tests/io/bag/foreign_database.h"
#include "tests/io/bag/sample_bags.h"
#include "tests/support/temporary_folder.h"

namespace leitstand {
namespace {

namespace fs = std::filesystem;
using test::makeDatabase;
using test::readAll;
using testing::Contains;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::SizeIs;

Time nanoseconds(std::int64_t count) {
    return Time(std::chrono::nanoseconds(count));
}

/// A bag of others in several files, as rosbag2 splits by size or time.
class SplitBag : public testing::Test {
protected:
    SplitBag() { fs::create_directory(m_bag); }

    /// Part @p number holds @p messages of a topic, from @p first on, a nanosecond apart. Ids begin anew in
    /// every part, and so do the numbers of topics.
    void makePart(int number, int topic, int messages, int first) const {
        std::string sql =
            "CREATE TABLE topics(id INTEGER PRIMARY KEY, name TEXT NOT NULL, type TEXT NOT NULL, "
            "serialization_format TEXT NOT NULL, offered_qos_profiles TEXT NOT NULL);"
            "CREATE TABLE messages(id INTEGER PRIMARY KEY, topic_id INTEGER NOT NULL, timestamp INTEGER NOT "
            "NULL, data BLOB NOT NULL); CREATE INDEX timestamp_idx ON messages (timestamp ASC);";
        sql +=
            fmt::format("INSERT INTO topics VALUES ({}, '/talk', 'std_msgs/msg/String', 'cdr', '');", topic);
        for (int i = 0; i < messages; ++i) {
            sql += fmt::format("INSERT INTO messages VALUES ({}, {}, {}, x'00010000{:02X}');", i + 1, topic,
                               first + i, first + i);
        }
        makeDatabase(m_bag / fmt::format("bag_{}.db3", number), sql);
    }
    void makeMetadata(const std::string& more) const {
        test::writeText(m_bag / "metadata.yaml",
                        "rosbag2_bagfile_information:\n  storage_identifier: sqlite3\n" + more);
    }
    std::string errorOf(const fs::path& path) const {
        const auto reader = BagReader::open(path);
        return reader ? "" : reader.error().text;
    }

    const test::TemporaryFolder m_folder;
    const fs::path m_bag = m_folder / "bag";
};

TEST_F(SplitBag, ItsPartsAreOneBagInTheOrderOfTheirNumbers) {
    makePart(0, 1, 3, 10);
    makePart(9, 7, 2, 20);
    makePart(10, 2, 4, 30);  // by name it would come before 9
    makeMetadata("  relative_file_paths: [bag/bag_0.db3, bag_9.db3, bag_10.db3]\n");
    const std::string before = test::fingerprint(m_bag);
    const auto reader = test::opened(m_bag);
    ASSERT_NE(reader, nullptr);
    EXPECT_THAT(reader->problems(), IsEmpty());
    ASSERT_THAT(reader->sessions(), SizeIs(3));
    EXPECT_EQ(reader->sessions()[2].firstSequence, 6U);
    EXPECT_EQ(reader->sessions()[2].messages, 4U);
    ASSERT_THAT(reader->topics(), SizeIs(1));
    EXPECT_EQ(reader->topics()[0].messages, 9U);
    const auto events = readAll(*reader);
    EXPECT_THAT(test::sequences(events), ElementsAre(1, 2, 3, 4, 5, 6, 7, 8, 9));
    for (const RawEvent& event : events) {
        EXPECT_EQ(std::to_integer<std::int64_t>(event.cdr->back()),
                  event.received.time_since_epoch().count());
    }
    EXPECT_EQ(reader->first(), nanoseconds(10));
    EXPECT_EQ(reader->last(), nanoseconds(33));
    EXPECT_EQ(reader->sequenceAt(nanoseconds(15)), 4U);
    EXPECT_EQ(reader->event(7)->received, nanoseconds(31));
    EXPECT_EQ(reader->lastUpTo("/talk", 5)->received, nanoseconds(21));
    EXPECT_THAT(test::sequences(readAll(*reader, {.from = nanoseconds(21), .to = nanoseconds(32)})),
                ElementsAre(5, 6, 7));
    EXPECT_EQ(test::fingerprint(m_bag), before);
}

TEST_F(SplitBag, APartThatWasNotCopiedAlongIsTold) {
    makePart(0, 1, 3, 10);
    makePart(2, 1, 3, 30);
    makeMetadata("  relative_file_paths: [bag_0.db3, bag_1.db3, bag_2.db3]\n");
    const auto reader = test::opened(m_bag);
    ASSERT_NE(reader, nullptr);
    EXPECT_THAT(reader->problems(), ElementsAre(HasSubstr("bag_1.db3: expected it, since metadata.yaml")));
    EXPECT_THAT(readAll(*reader), SizeIs(6));
}

TEST_F(SplitBag, APartOfAnotherKindIsToldAndTheRestIsRead) {
    makePart(0, 1, 3, 10);
    test::writeText(m_bag / "bag_1.mcap", "\x89MCAP0\r\n");
    test::writeText(m_bag / "bag_2.db3.zstd", "\x28\xb5\x2f\xfd");
    test::writeText(m_bag / "bag_3.db3", "\x89MCAP0\r\n and so on");  // whatever it is called
    makeMetadata("");
    const auto reader = test::opened(m_bag);
    ASSERT_NE(reader, nullptr);
    EXPECT_THAT(reader->problems(), Contains(HasSubstr("bag_1.mcap")));
    EXPECT_THAT(reader->problems(), Contains(HasSubstr("bag_2.db3.zstd")));
    EXPECT_THAT(reader->problems(), Contains(HasSubstr("bag_3.db3: byte 8: the file ends within")));
    EXPECT_THAT(readAll(*reader), SizeIs(3));
}

/// Compresses @p file into @p file + ".zstd", and removes it.
void compress(const fs::path& file, bool whole = true) {
    const std::string plain = test::readText(file);
    std::string packed(ZSTD_compressBound(plain.size()), '\0');
    packed.resize(ZSTD_compress(packed.data(), packed.size(), plain.data(), plain.size(), 3));
    test::writeText(file.string() + ".zstd", whole ? packed : packed.substr(0, packed.size() / 2));
    fs::remove(file);
}

TEST_F(SplitBag, FilesCompressedByZstdAreReadAndLeaveNothingBehind) {
    const test::TemporaryFolder temporary;
    ASSERT_EQ(::setenv("TMPDIR", temporary.path().c_str(), 1), 0);
    makePart(0, 1, 3, 10);
    makePart(1, 1, 3, 20);
    compress(m_bag / "bag_0.db3");
    compress(m_bag / "bag_1.db3");
    for (const bool described : {true, false}) {
        if (described) {
            makeMetadata(
                "  compression_format: zstd\n  compression_mode: FILE\n"
                "  relative_file_paths: [bag_0.db3.zstd, bag_1.db3.zstd]\n");
        } else {
            fs::remove(m_bag / "metadata.yaml");
        }
        const auto reader = test::opened(m_bag);
        ASSERT_NE(reader, nullptr);
        EXPECT_THAT(readAll(*reader), SizeIs(6));
        EXPECT_FALSE(fs::is_empty(temporary.path())) << "unpacked while it is read";
    }
    EXPECT_TRUE(fs::is_empty(temporary.path()));
    EXPECT_THAT(readAll(*test::opened(m_bag / "bag_1.db3.zstd")), SizeIs(3));
    ::unsetenv("TMPDIR");
}

TEST_F(SplitBag, CompressedFilesThatAreDamagedAndOtherCompressionsAreNamed) {
    makePart(0, 1, 3, 10);
    compress(m_bag / "bag_0.db3", false);
    EXPECT_THAT(errorOf(m_bag / "bag_0.db3.zstd"), HasSubstr("found one that is cut off"));
    test::writeText(m_bag / "bag_0.db3.zstd", "\x28\xb5\x2f\xfd and so on");
    EXPECT_THAT(errorOf(m_bag / "bag_0.db3.zstd"),
                HasSubstr("bag_0.db3.zstd: expected a file compressed by zstd"));
    makeMetadata("  compression_format: fake\n  compression_mode: file\n");
    EXPECT_THAT(errorOf(m_bag), HasSubstr("found compression \"fake\""));
    makePart(0, 1, 3, 10);  // compression that was configured and not used
    fs::remove(m_bag / "bag_0.db3.zstd");
    makeMetadata("  compression_format: zstd\n  compression_mode: NONE\n");
    EXPECT_EQ(errorOf(m_bag), "");
}

TEST_F(SplitBag, CompressedMessagesAreToldAndNeverTakenForCdr) {
    const auto file = m_bag / "bag_0.db3";
    makeDatabase(file, test::foreignSchema(3) + "INSERT INTO messages VALUES (4, 5, 4000, x'28B52FFD2004');");
    const auto reader = test::opened(file);
    ASSERT_NE(reader, nullptr);
    EXPECT_THAT(readAll(*reader), SizeIs(3));
    EXPECT_THAT(reader->problems(),
                ElementsAre(HasSubstr("/talk: expected messages compressed by zstd, found one")));
}

TEST_F(SplitBag, RecordersOfOthersLeaveTheWalFormatAndWeLeaveNothing) {
    // As rosbag2 closes a file: no log is left, but its header still says that there may be one.
    makeDatabase(m_bag / "bag_0.db3", test::foreignSchema(4) + "PRAGMA journal_mode = WAL;");
    makeMetadata("");
    ASSERT_FALSE(fs::exists(m_bag / "bag_0.db3-wal"));
    const std::string before = test::fingerprint(m_bag);
    {
        const auto reader = test::opened(m_bag);
        ASSERT_NE(reader, nullptr);
        EXPECT_TRUE(reader->sessions()[0].closed);
        EXPECT_THAT(readAll(*reader), SizeIs(3));
        EXPECT_EQ(test::fingerprint(m_bag), before) << "no -wal, no -shm";
    }
    EXPECT_EQ(test::fingerprint(m_bag), before);
}

TEST_F(SplitBag, ALogThatAKilledRecorderOfOthersLeftIsReadWhereItStands) {
    const auto from = m_folder / "killed.db3", file = m_bag / "bag_0.db3";
    test::makeUnfinishedDatabase(from, test::foreignSchema(4), [&] {
        fs::copy_file(from, file);
        fs::copy_file(from.string() + "-wal", file.string() + "-wal");
    });
    makeMetadata("");
    const std::string before = test::fingerprint(m_bag);
    {
        const auto reader = test::opened(m_bag);
        ASSERT_NE(reader, nullptr);
        EXPECT_FALSE(reader->sessions()[0].closed);
        EXPECT_THAT(test::sequences(readAll(*reader)), ElementsAre(2, 3, 1));
        EXPECT_EQ(test::fingerprint(m_bag), before) << "no -shm";
    }
    EXPECT_EQ(test::fingerprint(m_bag), before);
}

TEST_F(SplitBag, TimesThatMakeNoSenseAreTakenForTheBeginningOr2106) {
    makeDatabase(m_bag / "bag_0.db3",
                 test::foreignSchema(4) +
                     "INSERT INTO messages VALUES (4, 5, -9223372036854775808, x'00010000EE');"
                     "INSERT INTO messages VALUES (5, 5, 9223372036854775807, x'00010000FF');");
    const auto reader = test::opened(m_bag);
    ASSERT_NE(reader, nullptr);
    EXPECT_EQ(reader->first(), Time{});
    EXPECT_EQ(reader->last(), Time(std::chrono::seconds(1LL << 32))) << "2106: it can be added to";
    const auto events = readAll(*reader);
    EXPECT_EQ(events.size(), 5U);
    EXPECT_EQ(events.front().received, Time{});
}

TEST_F(SplitBag, NobodyRecordsIntoABagOfOthers) {
    const auto refused = [this] {
        const std::string before = test::fingerprint(m_bag);
        const auto writer = BagWriter::open(m_bag);
        EXPECT_THAT(writer ? "" : writer.error().text, HasSubstr("found a bag of others"));
        EXPECT_EQ(test::fingerprint(m_bag), before);
    };
    test::writeText(m_bag / "metadata.yaml", "rosbag2_bagfile_information:\n  storage_identifier: mcap\n");
    refused();
    makeMetadata("  compression_format: zstd\n  compression_mode: MESSAGE\n");
    makePart(0, 1, 3, 10);
    refused();
    makeMetadata("");
    refused();
    fs::remove(m_bag / "metadata.yaml");
    refused();
    fs::remove(m_bag / "bag_0.db3");
    test::writeText(m_bag / "metadata.yaml", "something: else\n");
    refused();
}

TEST_F(SplitBag, OursGoesOnWhateverBecameOfItsMetadata) {
    test::writeSession(m_bag, 1, 20);
    makeMetadata("");  // as `ros2 bag reindex` makes it
    test::writeSession(m_bag, 21, 40);
    fs::remove(m_bag / "metadata.yaml");
    test::writeSession(m_bag, 41, 60);
    const auto reader = test::opened(m_bag);
    EXPECT_THAT(reader->sessions(), SizeIs(3));
    EXPECT_EQ(reader->lastSequence(), 60U);
}

}  // namespace
}  // namespace leitstand
