#include "core/io/bag/reading/reader_core.h"

#include <algorithm>
#include <utility>

#include "core/base/words.h"
#include "core/io/bag/reading/decompression.h"
#include "core/io/bag/reading/other_kinds.h"
#include "core/io/bag/salvage/salvaged_file.h"
#include "core/mission/state/robot_state.h"

namespace leitstand::detail {

namespace {

/// Clamps a time from a file, which may be anything, to 1970 to 2106. Such times can be added to and
/// subtracted from each other, and robots' stamps (68 years from 1970) from them.
Time sane(Time stated) {
    constexpr Time Latest{std::chrono::seconds(1LL << 32)};
    return std::clamp(stated, Time{}, Latest);
}

}  // namespace

ReaderCore::ReaderCore(OpenBag bag) : m_bag(std::move(bag)) {
    listSessions();
    listTopics();
}

void ReaderCore::listSessions() {
    m_sessions.clear();
    for (const BagPart& part : m_bag.parts) {
        const BagFileFacts& facts = part.file->facts();
        BagSession session{.file = part.path};
        if (facts.lastId != 0) {
            session.firstSequence = facts.firstId + part.offset;
            session.lastSequence = facts.lastId + part.offset;
            session.first = sane(facts.first);
            session.last = sane(facts.last);
        }
        session.messages = facts.messages();
        session.missing = part.missing;
        session.closed = facts.closed && !part.live;
        session.damaged = part.damaged;
        m_sessions.push_back(std::move(session));
    }
}

void ReaderCore::listTopics() {
    std::map<std::pair<std::string, std::string>, BagTopic> merged;
    for (const BagPart& part : m_bag.parts) {
        for (const auto& [id, topic] : part.file->facts().topics) {
            const auto [known, fresh] =
                merged.try_emplace({topic.info.name, topic.info.type}, BagTopic{topic.info, topic.messages});
            if (fresh) continue;
            auto& sum = known->second.messages;
            sum = sum && topic.messages ? std::optional(*sum + *topic.messages) : std::nullopt;
            if (known->second.info.definition.empty()) known->second.info.definition = topic.info.definition;
        }
    }
    m_topics.clear();
    for (auto& [key, topic] : merged) m_topics.push_back(std::move(topic));
    takeCountsOfMetadata();
}

void ReaderCore::takeCountsOfMetadata() {
    std::uint64_t rows = 0;
    for (const BagSession& session : m_sessions) {
        if (session.lastSequence != 0) rows += session.lastSequence - session.firstSequence + 1;
    }
    if (!m_bag.metadata || m_bag.metadata->messages() != rows) return;
    for (BagTopic& topic : m_topics) {
        if (topic.messages) continue;
        for (const auto& counted : m_bag.metadata->topics) {
            if (counted.info.name == topic.info.name && counted.info.type == topic.info.type) {
                topic.messages = counted.messages;
            }
        }
    }
}

bool ReaderCore::ours() const {
    return std::any_of(m_bag.parts.begin(), m_bag.parts.end(),
                       [](const BagPart& part) { return part.file->facts().ours; });
}

std::uint64_t ReaderCore::lastSequence() const {
    std::uint64_t last = 0;
    for (const BagSession& session : m_sessions) last = std::max(last, session.lastSequence);
    return last;
}

void ReaderCore::report(const std::string& problem) {
    if (m_reported.insert(problem).second) m_bag.problems.push_back(problem);
}

void ReaderCore::reportNew(std::size_t index) {
    for (const std::string& problem : m_bag.parts[index].file->newProblems()) report(problem);
}

bool ReaderCore::salvage(std::size_t index) {
    BagPart& part = m_bag.parts[index];
    if (part.damaged || part.live || m_lost.contains(index)) return false;
    auto salvaged = SalvagedFile::open(
        part.path,
        leitstand::fill(translate("leitstand::Error", "{}: table messages: is damaged"), part.path.string()));
    if (!salvaged) {
        m_lost.insert(index);
        report(salvaged.error().text);
        return false;
    }
    part.file = std::move(salvaged).value();
    part.damaged = true;
    for (const std::string& problem : part.file->facts().problems) report(problem);
    if (const std::string missing = judgeMissing(part, m_bag.metadata); !missing.empty()) report(missing);
    listSessions();
    listTopics();
    return true;
}

BagFile::Outcome ReaderCore::fetch(std::size_t index, const RowQuery& query, std::vector<BagRow>& rows) {
    auto outcome = m_bag.parts[index].file->fetch(query, rows);
    // A caller that fetches again after the rows of a broken file gets the rows that salvage finds.
    if (outcome == BagFile::Outcome::Broken) {
        outcome = salvage(index) ? BagFile::Outcome::More : BagFile::Outcome::End;
        if (m_bag.parts[index].live)
            report(leitstand::fill(translate("leitstand::Error", "{}: cannot be read on while it is written"),
                                   m_bag.parts[index].path.string()));
    }
    reportNew(index);
    return outcome;
}

std::optional<RawEvent> ReaderCore::eventOf(std::size_t index, BagRow row) {
    const BagPart& part = m_bag.parts[index];
    const auto& topics = part.file->facts().topics;
    const auto topic = topics.find(row.topic);
    if (topic == topics.end()) {
        report(leitstand::fill(
            translate("leitstand::Error", "{}: messages of topic number {}: expected it in the table topics"),
            part.path.string(), row.topic));
        return std::nullopt;
    }
    const TopicInfo& info = topic->second.info;
    if (info.serialization != "cdr") {
        report(leitstand::fill(
            translate("leitstand::Error", "{}: topic {}: expected serialization \"cdr\", found \"{}\""),
            part.path.string(), info.name, info.serialization));
        return std::nullopt;
    }
    if (isCompressed(row.cdr)) {
        auto plain = decompressed(*row.cdr, "zstd", MaxMessageBytes);
        if (!plain || !plain->whole) {
            report(leitstand::fill(
                translate("leitstand::Error",
                          "{}: topic {}: expected messages compressed by zstd, found one that is damaged"),
                part.path.string(), info.name));
            return std::nullopt;
        }
        row.cdr = std::make_shared<const std::vector<std::byte>>(std::move(plain->bytes));
    }
    return RawEvent{row.id + part.offset, sane(row.received), info.name, info.type, std::move(row.cdr)};
}

std::set<std::int64_t> ReaderCore::idsOf(std::size_t index, const std::vector<std::string>& topics) const {
    std::set<std::int64_t> ids;
    for (const auto& [id, topic] : m_bag.parts[index].file->facts().topics) {
        if (std::find(topics.begin(), topics.end(), topic.info.name) != topics.end()) ids.insert(id);
    }
    return ids;
}

std::optional<RawEvent> ReaderCore::event(std::uint64_t sequence) {
    for (std::size_t index = m_bag.parts.size(); index-- > 0;) {
        const BagPart& part = m_bag.parts[index];
        if (sequence <= part.offset || sequence < m_sessions[index].firstSequence) continue;
        const std::uint64_t id = sequence - part.offset;
        bool broken = false;
        auto row = part.file->row(id, broken);
        if (broken && salvage(index)) row = m_bag.parts[index].file->row(id, broken);
        reportNew(index);
        if (row) return eventOf(index, std::move(*row));
    }
    return std::nullopt;
}

std::optional<RawEvent> ReaderCore::lastUpTo(const std::string& topic, std::uint64_t sequence) {
    for (std::size_t index = m_bag.parts.size(); index-- > 0;) {
        const std::uint64_t offset = m_bag.parts[index].offset;
        if (sequence <= offset) continue;
        bool broken = false;
        auto row = m_bag.parts[index].file->lastUpTo(idsOf(index, {topic}), sequence - offset, broken);
        if (broken && salvage(index)) {
            row = m_bag.parts[index].file->lastUpTo(idsOf(index, {topic}), sequence - offset, broken);
        }
        reportNew(index);
        if (row) return eventOf(index, std::move(*row));
    }
    return std::nullopt;
}

std::uint64_t ReaderCore::sequenceAt(Time time) {
    for (std::size_t index = 0; index < m_bag.parts.size(); ++index) {
        if (m_sessions[index].lastSequence == 0 && !m_bag.parts[index].live) continue;
        if (m_sessions[index].last < time && !m_bag.parts[index].live) continue;
        bool broken = false;
        std::uint64_t id = m_bag.parts[index].file->idAt(time, broken);
        if (broken && salvage(index)) id = m_bag.parts[index].file->idAt(time, broken);
        if (id != 0) return id + m_bag.parts[index].offset;
    }
    return lastSequence() + 1;
}

void ReaderCore::count() {
    for (std::size_t index = 0; index < m_bag.parts.size(); ++index) {
        if (m_bag.parts[index].file->facts().messages()) continue;
        m_bag.parts[index].file->count();
        // What SQLite cannot count it cannot read either.
        if (!m_bag.parts[index].file->facts().messages()) (void)salvage(index);
    }
    listSessions();
    listTopics();
}

}  // namespace leitstand::detail
