#include "tests/io/bag/foreign_database.h"

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <sqlite3.h>

namespace leitstand::test {

void makeDatabase(const std::filesystem::path& file, const std::string& sql) {
    sqlite3* database = nullptr;
    ASSERT_EQ(sqlite3_open(file.c_str(), &database), SQLITE_OK);
    char* problem = nullptr;
    EXPECT_EQ(sqlite3_exec(database, sql.c_str(), nullptr, nullptr, &problem), SQLITE_OK) << problem;
    sqlite3_close(database);
}

void makeUnfinishedDatabase(const std::filesystem::path& file, const std::string& sql,
                            const std::function<void()>& meanwhile) {
    makeDatabase(file, "PRAGMA journal_mode = WAL; CREATE TABLE other(id);");
    sqlite3* database = nullptr;
    ASSERT_EQ(sqlite3_open(file.c_str(), &database), SQLITE_OK);
    EXPECT_EQ(sqlite3_exec(database, fmt::format("PRAGMA wal_autocheckpoint = 0; {}", sql).c_str(), nullptr,
                           nullptr, nullptr),
              SQLITE_OK);
    meanwhile();
    sqlite3_close(database);
}

std::string foreignSchema(int version) {
    constexpr const char* Third =
        "CREATE TABLE schema(schema_version INTEGER PRIMARY KEY, ros_distro TEXT NOT NULL);"
        "CREATE TABLE metadata(id INTEGER PRIMARY KEY, metadata_version INTEGER NOT NULL, metadata TEXT NOT "
        "NULL);";
    constexpr const char* Fourth =
        "CREATE TABLE message_definitions(id INTEGER PRIMARY KEY, topic_type TEXT NOT NULL, encoding TEXT "
        "NOT "
        "NULL, encoded_message_definition TEXT NOT NULL, type_description_hash TEXT NOT NULL);"
        "INSERT INTO message_definitions VALUES (1, 'std_msgs/msg/String', 'ros2msg', 'string data', 'h');";
    return fmt::format(
        "CREATE TABLE topics(id INTEGER PRIMARY KEY, name TEXT NOT NULL, type TEXT NOT NULL, "
        "serialization_format TEXT NOT NULL{}{});"
        "CREATE TABLE messages(id INTEGER PRIMARY KEY, topic_id INTEGER NOT NULL, timestamp INTEGER NOT "
        "NULL, "
        "data BLOB NOT NULL); CREATE INDEX timestamp_idx ON messages (timestamp ASC); {}{}{}"
        "INSERT INTO topics VALUES (5, '/talk', 'std_msgs/msg/String', 'cdr'{}{});"
        "INSERT INTO messages VALUES (1, 5, 3000, x'00010000AA'), (2, 5, 1000, x'00010000BB'), "
        "(3, 5, 2000, x'00010000CC');",
        version >= 2 ? ", offered_qos_profiles TEXT NOT NULL" : "",
        version >= 4 ? ", type_description_hash TEXT NOT NULL" : "", version >= 3 ? Third : "",
        version >= 3 ? fmt::format("INSERT INTO schema VALUES ({}, 'humble');", version) : "",
        version >= 4 ? Fourth : "", version >= 2 ? ", '- history: 1'" : "",
        version >= 4 ? ", 'RIHS01_x'" : "");
}

}  // namespace leitstand::test
