// How SqliteFile finds its rows, and in which order.
#include <algorithm>

#include <fmt/format.h>
#include <sqlite3.h>

#include "core/io/bag/reading/sqlite_file.h"

namespace leitstand::detail {

namespace {

std::int64_t nanoseconds(Time time) {
    return time.time_since_epoch().count();
}

/// Returns "(1, 2, 3)" for a condition on topic_id.
std::string listed(const std::set<std::int64_t>& topics) {
    return fmt::format("({})", fmt::join(topics, ", "));
}

/// Rows of one topic in the order of their ids, by our index.
struct TopicRows {
    Statement statement;
    int code = SQLITE_DONE;

    std::int64_t id() const { return statement.integer(0); }
};

}  // namespace

BagRow rowOf(const Statement& statement) {
    BagRow row;
    row.id = static_cast<std::uint64_t>(statement.integer(0));
    row.topic = statement.integer(1);
    row.received = Time(std::chrono::nanoseconds(statement.integer(2)));
    const auto bytes = statement.bytes(3);
    row.cdr = std::make_shared<const std::vector<std::byte>>(bytes.begin(), bytes.end());
    return row;
}

BagFile::Outcome SqliteFile::fetch(const RowQuery& query, std::vector<BagRow>& rows) {
    if (query.topics && query.topics->empty()) return Outcome::End;
    return query.topics && m_byTopic ? fetchTopics(query, rows) : fetchOrdered(query, rows);
}

BagFile::Outcome SqliteFile::fetchOrdered(const RowQuery& query, std::vector<BagRow>& rows) {
    // Without an index on time, other bags are also read in the order of their rows.
    const bool byTime = m_byTime && !m_facts.ours;
    std::string sql =
        "SELECT id, topic_id, timestamp, data FROM messages WHERE timestamp <= ?3 AND id <= ?4 ";
    sql += byTime ? "AND timestamp >= ?2 AND (timestamp > ?2 OR id > ?1) AND id > 0 " : "AND id > ?1 ";
    if (query.topics) sql += "AND topic_id IN " + listed(*query.topics) + " ";
    sql += byTime ? "ORDER BY timestamp, id" : "ORDER BY id";
    Statement statement = m_database.prepare(sql);
    if (!statement) return Outcome::Broken;
    statement.bind(1, static_cast<std::int64_t>(query.afterId));
    statement.bind(2, nanoseconds(query.afterTime));
    statement.bind(3, nanoseconds(query.lastTime));
    statement.bind(4, static_cast<std::int64_t>(std::min(query.lastId, MaxId)));
    std::size_t bytes = 0;
    while (true) {
        const int code = statement.step();
        if (code == SQLITE_DONE) return Outcome::End;
        if (code != SQLITE_ROW) return Outcome::Broken;
        rows.push_back(rowOf(statement));
        bytes += rows.back().cdr->size();
        if (rows.size() >= FetchRows || bytes >= FetchBytes) return Outcome::More;
    }
}

BagFile::Outcome SqliteFile::fetchTopics(const RowQuery& query, std::vector<BagRow>& rows) {
    std::vector<TopicRows> sources;
    for (const std::int64_t topic : *query.topics) {
        TopicRows source{m_database.prepare(
            "SELECT id, topic_id, timestamp, data FROM messages INDEXED BY leitstand_topic_idx "
            "WHERE topic_id = ?1 AND topic_id > 0 AND id > ?2 AND id <= ?3 AND timestamp <= ?4 ORDER BY id")};
        if (!source.statement) return Outcome::Broken;
        source.statement.bind(1, topic);
        source.statement.bind(2, static_cast<std::int64_t>(query.afterId));
        source.statement.bind(3, static_cast<std::int64_t>(std::min(query.lastId, MaxId)));
        source.statement.bind(4, nanoseconds(query.lastTime));
        source.code = source.statement.step();
        sources.push_back(std::move(source));
    }
    for (std::size_t bytes = 0; rows.size() < FetchRows && bytes < FetchBytes;) {
        TopicRows* next = nullptr;
        for (TopicRows& source : sources) {
            if (source.code == SQLITE_DONE) continue;
            if (source.code != SQLITE_ROW) return Outcome::Broken;
            if (next == nullptr || source.id() < next->id()) next = &source;
        }
        if (next == nullptr) return Outcome::End;
        rows.push_back(rowOf(next->statement));
        bytes += rows.back().cdr->size();
        next->code = next->statement.step();
    }
    return Outcome::More;
}

std::optional<BagRow> SqliteFile::row(std::uint64_t id, bool& broken) {
    Statement statement =
        m_database.prepare("SELECT id, topic_id, timestamp, data FROM messages WHERE id = ?");
    statement.bind(1, static_cast<std::int64_t>(std::min(id, MaxId)));
    const int code = statement ? statement.step() : SQLITE_ERROR;
    broken = code != SQLITE_ROW && code != SQLITE_DONE;
    return code == SQLITE_ROW ? std::optional(rowOf(statement)) : std::nullopt;
}

std::optional<BagRow> SqliteFile::lastUpTo(const std::set<std::int64_t>& topics, std::uint64_t id,
                                           bool& broken) {
    std::optional<BagRow> newest;
    for (const std::int64_t topic : topics) {
        Statement statement = m_database.prepare(
            m_byTopic ? "SELECT id, topic_id, timestamp, data FROM messages INDEXED BY leitstand_topic_idx "
                        "WHERE topic_id = ?1 AND topic_id > 0 AND id <= ?2 ORDER BY id DESC LIMIT 1"
                      : "SELECT id, topic_id, timestamp, data FROM messages "
                        "WHERE topic_id = ?1 AND id <= ?2 AND id > 0 ORDER BY id DESC LIMIT 1");
        if (!statement) {
            broken = true;
            return std::nullopt;
        }
        statement.bind(1, topic);
        statement.bind(2, static_cast<std::int64_t>(std::min(id, MaxId)));
        const int code = statement.step();
        if (code != SQLITE_ROW && code != SQLITE_DONE) {
            broken = true;
            return std::nullopt;
        }
        if (code == SQLITE_ROW && (!newest || statement.integer(0) > static_cast<std::int64_t>(newest->id))) {
            newest = rowOf(statement);
        }
    }
    return newest;
}

std::uint64_t SqliteFile::idAt(Time time, bool& broken) {
    Statement statement = m_database.prepare(
        m_byTime ? "SELECT id FROM messages WHERE timestamp >= ? AND id > 0 ORDER BY timestamp, id LIMIT 1"
                 : "SELECT min(id) FROM messages WHERE timestamp >= ? AND id > 0");
    if (!statement) {
        broken = true;
        return 0;
    }
    statement.bind(1, nanoseconds(time));
    const int code = statement.step();
    broken = code != SQLITE_ROW && code != SQLITE_DONE;
    return code == SQLITE_ROW ? static_cast<std::uint64_t>(statement.integer(0)) : 0;
}

}  // namespace leitstand::detail
