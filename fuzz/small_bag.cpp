#include "fuzz/small_bag.h"

#include <sqlite3.h>

namespace leitstand::fuzz {

namespace {

/// What a bag is known by; our index makes it one of ours, in the order of its ids.
constexpr const char* Tables =
    "PRAGMA page_size = 512;"
    "CREATE TABLE topics(id INTEGER PRIMARY KEY, name TEXT, type TEXT, serialization_format TEXT);"
    "CREATE TABLE messages(id INTEGER PRIMARY KEY, topic_id INTEGER, timestamp INTEGER, data BLOB);"
    "CREATE INDEX leitstand_topic_idx ON messages (topic_id) WHERE topic_id > 0;"
    "INSERT INTO topics VALUES (1, '/a', 'std_msgs/msg/Float32', 'cdr');"
    "PRAGMA journal_mode = WAL; PRAGMA wal_autocheckpoint = 0;";

}  // namespace

sqlite3* openSmallBag(const std::filesystem::path& file) {
    sqlite3* bag = nullptr;
    if (sqlite3_open(file.c_str(), &bag) == SQLITE_OK &&
        sqlite3_exec(bag, Tables, nullptr, nullptr, nullptr) == SQLITE_OK) {
        sqlite3_db_config(bag, SQLITE_DBCONFIG_NO_CKPT_ON_CLOSE, 1, nullptr);
        return bag;
    }
    sqlite3_close(bag);
    return nullptr;
}

bool addMessages(sqlite3* bag, int transactions) {
    bool done = true;
    for (int i = 0; i < transactions; ++i) {
        done =
            done &&
            sqlite3_exec(bag,
                         "BEGIN; INSERT INTO messages(topic_id, timestamp, data) VALUES (1, 7, zeroblob(8));"
                         "INSERT INTO messages(topic_id, timestamp, data) VALUES (1, 8, zeroblob(900));"
                         "INSERT INTO messages(topic_id, timestamp, data) VALUES (1, 9, x'00010000'); COMMIT",
                         nullptr, nullptr, nullptr) == SQLITE_OK;
    }
    return done;
}

}  // namespace leitstand::fuzz
