#include "core/io/bag/reading/sqlite_file.h"

#include <algorithm>
#include <charconv>

#include <fmt/format.h>
#include <sqlite3.h>

#include "core/base/words.h"

namespace leitstand::detail {

namespace fs = std::filesystem;

namespace {

constexpr std::uint64_t CountedAtOnce = 100'000;  // rows; a file with fewer is counted on opening

Time timeAt(std::int64_t nanoseconds) {
    return Time(std::chrono::nanoseconds(nanoseconds));
}

}  // namespace

Result<std::unique_ptr<BagFile>> SqliteFile::open(const fs::path& file, bool live) {
    std::unique_ptr<SqliteFile> opened(new SqliteFile(file));
    if (auto step = opened->connect(live); !step) return step.error();
    if (auto step = opened->checkTables(); !step) return step.error();
    if (auto step = opened->readTopics(); !step) return step.error();
    opened->readDefinitions();
    if (auto step = opened->readSpan(); !step) return step.error();
    opened->readCounts();
    if (!live) opened->publishLog();
    return std::unique_ptr<BagFile>(std::move(opened));
}

Error SqliteFile::problem(std::string_view place) const {
    return Error{fmt::format("{}: {}: {}", m_file.string(), place, m_database.problem())};
}

Result<void> SqliteFile::connect(bool live) {
    std::string vfs;
    if (!live) {
        m_vfs = std::make_unique<OverlayVfs>();
        vfs = m_vfs->name();
    }
    // Without a writer, "read and write" lets SQLite roll back an interrupted transaction in memory.
    const int flags = live ? SQLITE_OPEN_READONLY : SQLITE_OPEN_READWRITE;
    std::error_code problemOfPath;
    auto opened = Database::open(fs::absolute(m_file, problemOfPath).string(), flags, vfs);
    if (!opened)
        return Error{leitstand::fill(translate("leitstand::Error", "{}: cannot be opened: {}"),
                                     m_file.string(), opened.error().text)};
    m_database = std::move(opened).value();
    sqlite3* handle = m_database.handle();
    sqlite3_busy_timeout(handle, 2'000);
    sqlite3_limit(handle, SQLITE_LIMIT_LENGTH, static_cast<int>(MaxMessageBytes));
    // The file may come from anyone.
    sqlite3_db_config(handle, SQLITE_DBCONFIG_DEFENSIVE, 1, nullptr);
    sqlite3_db_config(handle, SQLITE_DBCONFIG_TRUSTED_SCHEMA, 0, nullptr);
    sqlite3_db_config(handle, SQLITE_DBCONFIG_ENABLE_TRIGGER, 0, nullptr);
    sqlite3_db_config(handle, SQLITE_DBCONFIG_ENABLE_VIEW, 0, nullptr);
    sqlite3_db_config(handle, SQLITE_DBCONFIG_NO_CKPT_ON_CLOSE, 1, nullptr);
    const char* settings = live ? "PRAGMA cell_size_check = ON; PRAGMA temp_store = MEMORY"
                                : "PRAGMA locking_mode = EXCLUSIVE; PRAGMA cell_size_check = ON;"
                                  "PRAGMA temp_store = MEMORY; PRAGMA journal_mode";
    if (m_database.run(settings) != SQLITE_OK)
        return problem(translate("leitstand::Error", "expected an SQLite database"));
    return {};
}

Result<void> SqliteFile::checkTables() {
    Statement tables = m_database.prepare(
        "SELECT count(*) FROM sqlite_master WHERE type = 'table' AND rootpage > 0 "
        "AND name IN ('topics', 'messages')");
    if (!tables || tables.step() != SQLITE_ROW)
        return problem(translate("leitstand::Error", "expected an SQLite database"));
    if (tables.integer(0) != 2) {
        return Error{leitstand::fill(
            translate("leitstand::Error", "{}: expected the tables topics and messages of a rosbag2 bag"),
            m_file.string())};
    }
    const auto index = [this](const char* name) {
        return m_database.number(
                   fmt::format("SELECT count(*) FROM sqlite_master WHERE type = 'index' AND name = '{}' "
                               "AND tbl_name = 'messages'",
                               name),
                   0) == 1;
    };
    m_byTime = index("timestamp_idx");
    m_byTopic = index("leitstand_topic_idx");
    m_facts.ours = m_byTopic;
    Statement journal = m_database.prepare("PRAGMA journal_mode");
    const bool logged = journal && journal.step() == SQLITE_ROW && journal.text(0) == "wal";
    std::error_code none;
    const auto logSize = fs::file_size(m_file.string() + "-wal", none);
    const bool noLog = none || logSize == 0;
    m_facts.closed = !logged || (!m_facts.ours && noLog);
    m_logGone = logged && m_facts.ours && noLog;
    return {};
}

bool SqliteFile::hasColumn(const char* table, std::string_view column) const {
    return m_database.number(
               fmt::format("SELECT count(*) FROM pragma_table_info('{}') WHERE name = '{}'", table, column),
               0) > 0;
}

Result<void> SqliteFile::readTopics() {
    const bool qos = hasColumn("topics", "offered_qos_profiles");
    const bool hash = hasColumn("topics", "type_description_hash");
    Statement topics = m_database.prepare(
        fmt::format("SELECT id, name, type, serialization_format, {}, {} FROM topics ORDER BY id",
                    qos ? "offered_qos_profiles" : "''", hash ? "type_description_hash" : "''"));
    if (!topics) return problem(leitstand::fill(translate("leitstand::Error", "table {}"), "topics"));
    int code = topics.step();
    for (; code == SQLITE_ROW; code = topics.step()) {
        TopicInfo info;
        info.name = topics.text(1);
        info.type = topics.text(2);
        info.serialization = topics.text(3);
        info.qosProfiles = topics.text(4);
        info.typeHash = topics.text(5);
        m_facts.topics[topics.integer(0)] = {std::move(info), std::nullopt};
    }
    if (code != SQLITE_DONE)
        return problem(leitstand::fill(translate("leitstand::Error", "table {}"), "topics"));
    return {};
}

void SqliteFile::readDefinitions() {
    Statement definitions =
        m_database.prepare("SELECT topic_type, encoded_message_definition FROM message_definitions");
    if (!definitions) return;  // older than version 4
    int code = definitions.step();
    for (; code == SQLITE_ROW; code = definitions.step()) {
        const std::string type = definitions.text(0);
        for (auto& [id, topic] : m_facts.topics) {
            if (topic.info.type == type) topic.info.definition = definitions.text(1);
        }
    }
    if (code != SQLITE_DONE)
        m_facts.problems.push_back(
            problem(leitstand::fill(translate("leitstand::Error", "table {}"), "message_definitions")).text);
}

Result<void> SqliteFile::readSpan() {
    Statement ends = m_database.prepare(
        "SELECT (SELECT min(id) FROM messages WHERE id > 0), (SELECT max(id) FROM messages WHERE id <= ?)");
    if (!ends) return problem(leitstand::fill(translate("leitstand::Error", "table {}"), "messages"));
    ends.bind(1, static_cast<std::int64_t>(MaxId));
    if (ends.step() != SQLITE_ROW)
        return problem(leitstand::fill(translate("leitstand::Error", "table {}"), "messages"));
    if (ends.type(0) != SQLITE_INTEGER || ends.type(1) != SQLITE_INTEGER) return {};
    m_facts.firstId = static_cast<std::uint64_t>(ends.integer(0));
    m_facts.lastId = static_cast<std::uint64_t>(ends.integer(1));
    if (m_facts.firstId > m_facts.lastId) {
        m_facts.problems.push_back(leitstand::fill(
            translate("leitstand::Error", "{}: table messages: expected ids from 1 to {}, found {} to {}"),
            m_file.string(), MaxId, ends.integer(0), ends.integer(1)));
        m_facts.firstId = m_facts.lastId = 0;
        return {};
    }
    Statement times = m_database.prepare(
        m_byTime && !m_facts.ours
            ? "SELECT (SELECT min(timestamp) FROM messages), (SELECT max(timestamp) FROM messages)"
            : "SELECT (SELECT timestamp FROM messages WHERE id = ?1), "
              "(SELECT timestamp FROM messages WHERE id = ?2)");
    if (!times) return problem(leitstand::fill(translate("leitstand::Error", "table {}"), "messages"));
    times.bind(1, ends.integer(0));
    times.bind(2, ends.integer(1));
    if (times.step() != SQLITE_ROW)
        return problem(leitstand::fill(translate("leitstand::Error", "table {}"), "messages"));
    m_facts.first = timeAt(times.integer(0));
    m_facts.last = timeAt(times.integer(1));
    return {};
}

void SqliteFile::readCounts() {
    Statement row = m_database.prepare("SELECT metadata FROM metadata ORDER BY id DESC LIMIT 1");
    if (row && row.step() == SQLITE_ROW) {
        const auto metadata = parseMetadata(
            row.text(0),
            leitstand::fill(translate("leitstand::Error", "{}: table {}"), m_file.string(), "metadata"));
        if (metadata) {
            m_facts.expected = metadata->messages();
            for (const auto& counted : metadata->topics) {
                for (auto& [id, topic] : m_facts.topics) {
                    if (topic.info.name == counted.info.name && topic.info.type == counted.info.type) {
                        topic.messages = counted.messages;
                    }
                }
            }
            const auto to = metadata->custom.find(std::string(CountedKey));
            std::uint64_t countedTo = m_facts.lastId;
            if (to != metadata->custom.end()) {
                std::from_chars(to->second.data(), to->second.data() + to->second.size(), countedTo);
            }
            // A file that was finished while someone read it stays in WAL mode.
            m_logGone = m_logGone && !metadata->custom.contains(std::string(ClosedKey));
            const bool whole = m_facts.ours || metadata->messages() == m_facts.lastId - m_facts.firstId + 1;
            if (whole && addTail(countedTo)) return;
        }
    }
    for (auto& [id, topic] : m_facts.topics) topic.messages.reset();
    if (m_facts.lastId == 0 || m_facts.lastId - m_facts.firstId < CountedAtOnce) count();
}

void SqliteFile::publishLog() {
    if (!m_logGone) return;
    m_facts.problems.push_back(
        leitstand::fill(translate("leitstand::Error",
                                  "{}-wal: expected it, since the writer of {} was cut off, found nothing: "
                                  "what was written last may be missing"),
                        m_file.string(), m_file.filename().string()));
}

bool SqliteFile::addTail(std::uint64_t countedTo) {
    if (countedTo > m_facts.lastId) return m_facts.lastId == 0;
    Statement tail =
        m_database.prepare("SELECT topic_id, count(*) FROM messages WHERE id > ? GROUP BY topic_id");
    if (!tail) return false;
    tail.bind(1, static_cast<std::int64_t>(countedTo));
    int code = tail.step();
    for (; code == SQLITE_ROW; code = tail.step()) {
        const auto topic = m_facts.topics.find(tail.integer(0));
        if (topic == m_facts.topics.end()) continue;
        topic->second.messages =
            topic->second.messages.value_or(0) + static_cast<std::uint64_t>(tail.integer(1));
    }
    return code == SQLITE_DONE;
}

void SqliteFile::count() {
    Statement all = m_database.prepare("SELECT topic_id, count(*) FROM messages GROUP BY topic_id");
    if (!all) return;
    std::map<std::int64_t, std::uint64_t> counts;
    int code = all.step();
    for (; code == SQLITE_ROW; code = all.step())
        counts[all.integer(0)] = static_cast<std::uint64_t>(all.integer(1));
    if (code != SQLITE_DONE) return;
    for (auto& [id, topic] : m_facts.topics) topic.messages = counts[id];
}

}  // namespace leitstand::detail
