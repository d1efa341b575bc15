#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sqlite3.h>

#include "tests/io/bag/foreign_database.h"
#include "tests/io/bag/sample_bags.h"
#include "tests/support/temporary_folder.h"

namespace leitstand {
namespace {

namespace fs = std::filesystem;
using test::foreignSchema;
using test::makeDatabase;
using test::readAll;
using testing::Contains;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

class ForeignBag : public testing::Test {
protected:
    ForeignBag() { fs::create_directory(m_bag); }
    std::string errorOf(const fs::path& path) {
        const auto reader = BagReader::open(path);
        return reader ? "" : reader.error().text;
    }

    const test::TemporaryFolder m_folder;
    const fs::path m_bag = m_folder / "bag";
};

TEST_F(ForeignBag, AllVersionsOfTheSchemaAreReadByTime) {
    for (int version = 1; version <= 4; ++version) {
        const auto file = m_bag / fmt::format("bag_{}.db3", version);
        makeDatabase(file, foreignSchema(version));
        const std::string before = test::fingerprint(m_bag);
        const auto reader = test::opened(file);
        ASSERT_NE(reader, nullptr);
        EXPECT_THAT(reader->problems(), IsEmpty()) << version;
        EXPECT_FALSE(reader->ours());
        EXPECT_THAT(test::sequences(readAll(*reader)), ElementsAre(2, 3, 1)) << version;
        EXPECT_EQ(reader->topics().at(0).info.name, "/talk");
        EXPECT_EQ(reader->topics().at(0).messages, 3U);
        EXPECT_EQ(reader->topics().at(0).info.definition, version >= 4 ? "string data" : "");
        EXPECT_EQ(reader->first(), Time(std::chrono::nanoseconds(1'000)));
        EXPECT_EQ(test::sequences(readAll(*reader, {.from = Time(std::chrono::nanoseconds(1'500))})),
                  (std::vector<std::uint64_t>{3, 1}));
        EXPECT_EQ(test::fingerprint(m_bag), before);
    }
    // Four files make one bag, numbered on.
    EXPECT_EQ(test::sequences(readAll(*test::opened(m_bag))).size(), 12U);
    EXPECT_EQ(test::opened(m_bag)->lastSequence(), 12U);
    EXPECT_EQ(test::opened(m_bag)->event(12)->cdr->back(), std::byte{0xCC});
}

TEST_F(ForeignBag, AnInterruptedTransactionIsRolledBackInMemoryOnly) {
    const auto file = m_bag / "bag_0.db3", copy = m_bag / "bag_1.db3";
    makeDatabase(file, foreignSchema(3));
    // A journal that SQLite finds "hot": taken while a big transaction had spilled into the file.
    sqlite3* database = nullptr;
    ASSERT_EQ(sqlite3_open(file.c_str(), &database), SQLITE_OK);
    ASSERT_EQ(sqlite3_exec(
                  database,
                  "PRAGMA cache_size = 5; BEGIN; UPDATE messages SET data = zeroblob(9); WITH RECURSIVE n(i) "
                  "AS (SELECT 10 UNION ALL SELECT i + 1 FROM n WHERE i < 400) INSERT INTO messages SELECT i, "
                  "5, i, zeroblob(5000) FROM n;",
                  nullptr, nullptr, nullptr),
              SQLITE_OK);
    fs::copy_file(file, copy);
    fs::copy_file(file.string() + "-journal", copy.string() + "-journal");
    sqlite3_close(database);
    const std::string before = test::fingerprint(m_bag);
    {
        const auto reader = test::opened(copy);
        ASSERT_NE(reader, nullptr);
        const auto events = readAll(*reader);
        EXPECT_THAT(test::sequences(events), ElementsAre(2, 3, 1));
        EXPECT_EQ(events[0].cdr->back(), std::byte{0xBB});
    }
    EXPECT_EQ(test::fingerprint(m_bag), before);
}

TEST_F(ForeignBag, BagsOfOtherKindsAreNamed) {
    EXPECT_THAT(errorOf(m_folder / "nothing"), HasSubstr("expected a bag's folder or file"));
    EXPECT_THAT(errorOf(m_bag), HasSubstr("expected a bag"));
    test::writeText(m_bag / "bag_0.mcap", "x");
    EXPECT_THAT(errorOf(m_bag), HasSubstr("bag_0.mcap"));
    EXPECT_THAT(errorOf(m_bag / "bag_0.mcap"), HasSubstr("expected the beginning of an MCAP file"));
    fs::remove(m_bag / "bag_0.mcap");
    test::writeText(m_bag / "metadata.yaml", "rosbag2_bagfile_information:\n  storage_identifier: rocksdb\n");
    EXPECT_THAT(errorOf(m_bag), HasSubstr("found storage \"rocksdb\""));
    makeDatabase(m_bag / "bag_0.db3", foreignSchema(4));
    test::writeText(
        m_bag / "metadata.yaml",
        "rosbag2_bagfile_information:\n  storage_identifier: sqlite3\n  compression_format: lz4\n");
    EXPECT_THAT(errorOf(m_bag), HasSubstr("found compression \"lz4\""));
    const auto other = m_folder / "other.db3";
    makeDatabase(other, "CREATE TABLE cats(name TEXT); INSERT INTO cats VALUES ('Tom')");
    EXPECT_THAT(errorOf(other), HasSubstr("expected the tables topics and messages"));
}

TEST_F(ForeignBag, WhatIsUnknownIsToldAndTheRestIsRead) {
    makeDatabase(
        m_bag / "bag_0.db3",
        foreignSchema(4) +
            "INSERT INTO topics VALUES (6, '/json', 'x/msg/Y', 'json', '', '');"
            "INSERT INTO messages VALUES (4, 6, 4000, x'01'), (5, 77, 5000, x'02'), (-3, 5, 1, x'03'),"
            "(6, 5, 6000, 'text'), (7, 5, 'late', x'00010000DD'), (9223372036854775807, 5, 9, x'04');");
    const auto reader = test::opened(m_bag);
    ASSERT_NE(reader, nullptr);
    const auto events = readAll(*reader);
    EXPECT_THAT(test::sequences(events), testing::IsSupersetOf({1U, 2U, 3U}));
    for (const RawEvent& event : events) EXPECT_EQ(event.topic, "/talk");
    EXPECT_THAT(reader->problems(), Contains(HasSubstr("topic number 77")));
    EXPECT_THAT(reader->problems(), Contains(HasSubstr("/json: expected serialization \"cdr\"")));
}

TEST_F(ForeignBag, HostileSchemasAreErrorsOrRead) {
    const std::string topics =
        "CREATE TABLE topics(id INTEGER PRIMARY KEY, name, type, serialization_format);";
    const char* messages[] = {
        "CREATE VIEW messages AS SELECT 1 AS id, 1 AS topic_id, 1 AS timestamp, zeroblob(900000000) AS data;",
        "CREATE TABLE messages(id INTEGER PRIMARY KEY);",
        "CREATE TABLE messages(id TEXT, topic_id, timestamp, data); INSERT INTO messages VALUES ('x', 1, 2, "
        "3);",
        "CREATE TABLE messages(id INTEGER PRIMARY KEY, topic_id, timestamp, data) WITHOUT ROWID;",
        "CREATE TABLE messages(id INTEGER PRIMARY KEY, topic_id, timestamp, data);"
        "CREATE INDEX leitstand_topic_idx ON messages(data); INSERT INTO messages VALUES (1, 1, 1, 1);",
    };
    int number = 0;
    for (const char* table : messages) {
        const auto file = m_folder / fmt::format("hostile_{}.db3", number++);
        makeDatabase(file, topics + table);
        auto reader = BagReader::open(file);
        if (!reader) continue;
        (void)readAll(**reader);
        (void)readAll(**reader, {.topics = {"/talk"}});
        (void)(*reader)->sequenceAt(test::at(0));
    }
}

}  // namespace
}  // namespace leitstand
