#include "core/io/bag/bag_reader.h"

#include <algorithm>
#include <utility>

#include "core/io/bag/reading/reader_core.h"

namespace leitstand {

class BagReader::Impl : public detail::ReaderCore {
    using detail::ReaderCore::ReaderCore;
};

class BagCursor::Impl {
public:
    Impl(detail::ReaderCore& reader, BagQuery query) : m_reader(reader), m_query(std::move(query)) {}

    std::optional<RawEvent> next() {
        while (true) {
            while (m_next < m_rows.size()) {
                detail::BagRow& row = m_rows[m_next++];
                m_rowQuery.afterId = row.id;
                m_rowQuery.afterTime = row.received;
                if (!wanted(row)) continue;
                if (auto event = m_reader.eventOf(m_part, std::move(row))) return event;
            }
            if (!fill()) return std::nullopt;
        }
    }

private:
    bool wanted(const detail::BagRow& row) const {
        const std::uint64_t sequence = row.id + m_reader.parts()[m_part].offset;
        if (sequence < m_query.fromSequence || sequence > m_query.toSequence) return false;
        return !m_query.from || row.received >= *m_query.from;
    }

    /// Fetches more rows, of this part or the next; false at the end of the bag.
    bool fill() {
        m_rows.clear();
        m_next = 0;
        if (m_begun && m_outcome == detail::BagFile::Outcome::End) {
            m_begun = false;
            ++m_part;
        }
        if (m_part >= m_reader.parts().size()) return false;
        if (!m_begun) begin();
        if (m_skip) {
            m_outcome = detail::BagFile::Outcome::End;
            return true;
        }
        // Salvage may number the topics differently, or find more of them.
        if (!m_query.topics.empty()) m_rowQuery.topics = m_reader.idsOf(m_part, m_query.topics);
        m_outcome = m_reader.fetch(m_part, m_rowQuery, m_rows);
        return true;
    }

    /// Sets up the row query for the next part.
    void begin() {
        const detail::BagPart& part = m_reader.parts()[m_part];
        const detail::BagFileFacts& facts = part.file->facts();
        const BagSession& session = m_reader.sessions()[m_part];
        m_begun = true;
        m_rowQuery = {};
        m_skip = m_query.toSequence <= part.offset;
        if (!part.live) {
            m_skip = m_skip || session.lastSequence == 0 || session.lastSequence < m_query.fromSequence ||
                     (facts.ours && session.firstSequence > m_query.toSequence);
        }
        if (m_skip) return;
        m_rowQuery.lastId = std::min(m_query.toSequence - part.offset, detail::MaxId);
        if (m_query.to) m_rowQuery.lastTime = std::max(*m_query.to, Time{}) - std::chrono::nanoseconds(1);
        if (facts.ours) {
            if (m_query.fromSequence > part.offset)
                m_rowQuery.afterId = m_query.fromSequence - part.offset - 1;
            if (m_query.from && *m_query.from > session.first) beginAt(*m_query.from, part.offset);
        } else if (m_query.from) {
            m_rowQuery.afterTime = *m_query.from;
        }
        if (facts.idsByTime && m_query.fromSequence > part.offset)
            m_rowQuery.afterId = m_query.fromSequence - part.offset - 1;
    }

    void beginAt(Time time, std::uint64_t offset) {
        const std::uint64_t sequence = m_reader.sequenceAt(time);
        if (sequence > offset) m_rowQuery.afterId = std::max(m_rowQuery.afterId, sequence - offset - 1);
    }

    detail::ReaderCore& m_reader;
    const BagQuery m_query;
    std::size_t m_part = 0, m_next = 0;
    bool m_begun = false, m_skip = false;
    detail::RowQuery m_rowQuery;
    detail::BagFile::Outcome m_outcome = detail::BagFile::Outcome::More;
    std::vector<detail::BagRow> m_rows;
};

BagCursor::BagCursor(std::unique_ptr<Impl> impl) : m_impl(std::move(impl)) {}
BagCursor::BagCursor(BagCursor&&) noexcept = default;
BagCursor& BagCursor::operator=(BagCursor&&) noexcept = default;
BagCursor::~BagCursor() = default;

std::optional<RawEvent> BagCursor::next() {
    return m_impl->next();
}

BagReader::BagReader(std::unique_ptr<Impl> impl) : m_impl(std::move(impl)) {}
BagReader::~BagReader() = default;

Result<std::unique_ptr<BagReader>> BagReader::open(const std::filesystem::path& bag) {
    auto opened = detail::openBag(bag);
    if (!opened) return opened.error();
    return std::unique_ptr<BagReader>(new BagReader(std::make_unique<Impl>(std::move(opened).value())));
}

const std::vector<BagSession>& BagReader::sessions() const {
    return m_impl->sessions();
}

const std::vector<BagTopic>& BagReader::topics() const {
    return m_impl->topics();
}

std::uint64_t BagReader::lastSequence() const {
    return m_impl->lastSequence();
}

Time BagReader::first() const {
    Time first = Time::max();
    for (const BagSession& session : sessions()) {
        if (session.lastSequence != 0) first = std::min(first, session.first);
    }
    return first == Time::max() ? Time{} : first;
}

Time BagReader::last() const {
    Time last{};
    for (const BagSession& session : sessions()) last = std::max(last, session.last);
    return last;
}

bool BagReader::ours() const {
    return m_impl->ours();
}

const std::vector<std::string>& BagReader::problems() const {
    return m_impl->problems();
}

BagCursor BagReader::read(const BagQuery& query) {
    return BagCursor(std::make_unique<BagCursor::Impl>(*m_impl, query));
}

std::optional<RawEvent> BagReader::event(std::uint64_t sequence) {
    return m_impl->event(sequence);
}

std::optional<RawEvent> BagReader::lastUpTo(const std::string& topic, std::uint64_t sequence) {
    return m_impl->lastUpTo(topic, sequence);
}

std::uint64_t BagReader::sequenceAt(Time time) {
    return m_impl->sequenceAt(time);
}

void BagReader::count() {
    m_impl->count();
}

}  // namespace leitstand
