#include "core/io/bag/writing/sqlite_store.h"

#include <cerrno>
#include <system_error>

#include <fmt/format.h>
#include <sqlite3.h>

namespace leitstand::detail {

namespace {

// rosbag2's schema 4. The last index is ours: it gives the rows of one topic in order. Its condition is
// always true. SQLite therefore does not choose it for the queries of others, which do not state it.
constexpr const char* Tables = R"(
CREATE TABLE schema(schema_version INTEGER PRIMARY KEY, ros_distro TEXT NOT NULL);
CREATE TABLE metadata(id INTEGER PRIMARY KEY, metadata_version INTEGER NOT NULL, metadata TEXT NOT NULL);
CREATE TABLE topics(id INTEGER PRIMARY KEY, name TEXT NOT NULL, type TEXT NOT NULL,
    serialization_format TEXT NOT NULL, offered_qos_profiles TEXT NOT NULL, type_description_hash TEXT NOT NULL);
CREATE TABLE message_definitions(id INTEGER PRIMARY KEY, topic_type TEXT NOT NULL, encoding TEXT NOT NULL,
    encoded_message_definition TEXT NOT NULL, type_description_hash TEXT NOT NULL);
CREATE TABLE messages(id INTEGER PRIMARY KEY, topic_id INTEGER NOT NULL, timestamp INTEGER NOT NULL,
    data BLOB NOT NULL);
CREATE INDEX timestamp_idx ON messages (timestamp ASC);
CREATE INDEX leitstand_topic_idx ON messages (topic_id) WHERE topic_id > 0;
INSERT INTO schema VALUES (4, '');
)";

constexpr int MaxWalFrames = 512;  // 4 MiB until a checkpoint: a lost log costs no more

}  // namespace

Result<std::unique_ptr<BagStore>> SqliteStore::create(SessionFolder folder) {
    std::unique_ptr<SqliteStore> store(new SqliteStore(std::move(folder)));
    if (const auto failed = store->createTables()) return Error{failed->text};
    store->m_folder.writeMetadata(store->m_books);
    store->m_folder.sync();
    return std::unique_ptr<BagStore>(std::move(store));
}

std::optional<StoreProblem> SqliteStore::createTables() {
    auto opened = Database::open(file().string(), SQLITE_OPEN_READWRITE | SQLITE_OPEN_CREATE);
    if (!opened) return StoreProblem{.text = file().string() + ": cannot be made: " + opened.error().text};
    m_database = std::move(opened).value();
    sqlite3_busy_timeout(m_database.handle(), 2'000);
    // The tables are written before the write-ahead log is switched on, since SQLite discards the log of a
    // file that is still empty.
    for (const char* sql :
         {"PRAGMA page_size = 8192", "PRAGMA auto_vacuum = NONE", "PRAGMA secure_delete = OFF",
          "PRAGMA cache_size = -16000", "PRAGMA temp_store = MEMORY", "BEGIN", Tables, "COMMIT",
          "PRAGMA journal_mode = WAL", "PRAGMA synchronous = FULL", "PRAGMA wal_autocheckpoint = 0",
          "PRAGMA journal_size_limit = 16777216"}) {
        if (auto failed = checked(m_database.run(sql))) return failed;
    }
    sqlite3_wal_hook(
        m_database.handle(),
        [](void* store, sqlite3*, const char*, int frames) {
            static_cast<SqliteStore*>(store)->m_walFrames = frames;
            return SQLITE_OK;
        },
        this);
    m_begin = m_database.prepare("BEGIN");
    m_commit = m_database.prepare("COMMIT");
    m_rollback = m_database.prepare("ROLLBACK");
    m_insert = m_database.prepare("INSERT INTO messages(id, topic_id, timestamp, data) VALUES (?, ?, ?, ?)");
    m_insertTopic = m_database.prepare("INSERT INTO topics VALUES (?, ?, ?, ?, ?, ?)");
    m_insertDefinition = m_database.prepare(
        "INSERT INTO message_definitions(topic_type, encoding, encoded_message_definition, "
        "type_description_hash) VALUES (?, 'ros2msg', ?, ?)");
    m_metadata = m_database.prepare("INSERT OR REPLACE INTO metadata VALUES (1, ?, ?)");
    return commit({.topics = {}, .events = {}, .metadata = true});
}

std::optional<StoreProblem> SqliteStore::checked(int code, std::size_t event) const {
    if (code == SQLITE_OK || code == SQLITE_DONE) return std::nullopt;
    StoreProblem problem{StoreProblem::Kind::Failed, {}, event};
    const int reason = sqlite3_system_errno(m_database.handle());
    const bool noSpace = reason == ENOSPC || reason == EDQUOT || reason == EFBIG;
    switch (code & 0xff) {
        case SQLITE_FULL:
            problem.kind = StoreProblem::Kind::DiskFull;
            break;
        case SQLITE_IOERR:
            if (noSpace) problem.kind = StoreProblem::Kind::DiskFull;
            break;
        case SQLITE_CONSTRAINT:
        case SQLITE_TOOBIG:
            problem.kind = StoreProblem::Kind::Refused;
            break;
        default:
            break;
    }
    problem.text = fmt::format("{}: cannot be written: {}", file().string(), m_database.problem());
    if ((code & 0xff) == SQLITE_IOERR && reason != 0) {
        problem.text += fmt::format(" ({})", std::generic_category().message(reason));
    }
    return problem;
}

std::optional<StoreProblem> SqliteStore::commit(const BagBatch& batch) {
    if (batch.empty()) return std::nullopt;
    if (auto failed = checked(m_begin.run())) return failed;
    Books books = m_books;
    auto failed = writeAll(batch, books);
    if (!failed) failed = checked(m_commit.run());
    if (failed) {
        if (sqlite3_get_autocommit(m_database.handle()) == 0) (void)m_rollback.run();
        return failed;
    }
    m_books = std::move(books);
    checkpointWhenLong();
    if (batch.metadata) m_folder.writeMetadata(m_books);
    return std::nullopt;
}

std::optional<StoreProblem> SqliteStore::writeAll(const BagBatch& batch, Books& books) {
    for (const TopicInfo& topic : batch.topics) {
        if (auto failed = insertTopic(topic, books)) return failed;
    }
    for (std::size_t i = 0; i < batch.events.size(); ++i) {
        if (auto failed = insertEvent(batch.events[i], i, books)) return failed;
    }
    return batch.metadata ? storeMetadata(books) : std::nullopt;
}

std::optional<StoreProblem> SqliteStore::insertTopic(const TopicInfo& topic, Books& books) {
    if (!books.add(topic)) return std::nullopt;
    m_insertTopic.bind(1, static_cast<std::int64_t>(books.ids.size()));
    m_insertTopic.bind(2, topic.name);
    m_insertTopic.bind(3, topic.type);
    m_insertTopic.bind(4, topic.serialization);
    m_insertTopic.bind(5, topic.qosProfiles);
    m_insertTopic.bind(6, topic.typeHash);
    if (auto failed = checked(m_insertTopic.run())) return failed;
    if (topic.definition.empty() || !books.definitions.insert(topic.type).second) return std::nullopt;
    m_insertDefinition.bind(1, topic.type);
    m_insertDefinition.bind(2, topic.definition);
    m_insertDefinition.bind(3, topic.typeHash);
    return checked(m_insertDefinition.run());
}

std::optional<StoreProblem> SqliteStore::insertEvent(const RawEvent& event, std::size_t index, Books& books) {
    const auto topic = books.topicOfNext(event);
    if (!topic) return m_folder.refusal(event, index, books);
    m_insert.bind(1, static_cast<std::int64_t>(event.sequence));
    m_insert.bind(2, *topic);
    m_insert.bind(3, static_cast<std::int64_t>(event.received.time_since_epoch().count()));
    m_insert.bind(4, std::span<const std::byte>(*event.cdr));
    if (auto failed = checked(m_insert.run(), index)) return failed;
    books.count(event, *topic);
    return std::nullopt;
}

std::optional<StoreProblem> SqliteStore::storeMetadata(const Books& books) {
    BagMetadata metadata = books.metadata;
    metadata.custom[std::string(CountedKey)] = std::to_string(books.lastSequence);
    if (m_closing) metadata.custom[std::string(ClosedKey)] = "true";
    m_metadata.bind(1, static_cast<std::int64_t>(metadata.version));
    m_metadata.bind(2, yamlOf(metadata, /*bare=*/true));
    return checked(m_metadata.run());
}

void SqliteStore::checkpointWhenLong() {
    if (m_walFrames < MaxWalFrames) return;
    // On a full disk this fails. The log stays, nothing is lost, and the next commit tries again.
    sqlite3_wal_checkpoint_v2(m_database.handle(), nullptr, SQLITE_CHECKPOINT_PASSIVE, nullptr, nullptr);
}

std::optional<StoreProblem> SqliteStore::close() {
    if (!m_database) return std::nullopt;
    m_closing = true;
    auto failed = commit({.topics = {}, .events = {}, .metadata = true});
    for (Statement* statement :
         {&m_begin, &m_commit, &m_rollback, &m_insert, &m_insertTopic, &m_insertDefinition, &m_metadata}) {
        *statement = {};
    }
    if (!failed) failed = checked(m_database.run("PRAGMA wal_checkpoint(TRUNCATE)"));
    // Some readers know no write-ahead log, so the finished file has none. One of our readers may prevent
    // that for now.
    if (!failed) (void)m_database.run("PRAGMA journal_mode = DELETE");
    m_database.close();
    return failed;
}

}  // namespace leitstand::detail
