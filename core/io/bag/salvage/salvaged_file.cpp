#include "core/io/bag/salvage/salvaged_file.h"

#include <algorithm>
#include <tuple>

#include <fmt/format.h>

#include "core/base/words.h"

namespace leitstand::detail {

namespace {

constexpr std::size_t MostGapsReported = 20;

}  // namespace

Result<std::unique_ptr<BagFile>> SalvagedFile::open(const std::filesystem::path& file,
                                                    const std::string& why) {
    std::vector<std::size_t> sizes = {PageFile::pageSizeOf(file)};
    if (sizes.front() == 0) sizes = {8'192, 4'096, 16'384, 32'768, 65'536, 1'024};  // ours, SQLite's, others
    for (const std::size_t size : sizes) {
        std::unique_ptr<SalvagedFile> salvaged(new SalvagedFile(file, size));
        salvaged->search();
        if (salvaged->m_found.empty()) continue;
        salvaged->finish(why);
        return std::unique_ptr<BagFile>(std::move(salvaged));
    }
    return Error{
        leitstand::fill(translate("leitstand::Error", "{}; and no page of it holds messages, either"), why)};
}

void SalvagedFile::search() {
    eachCell(m_pages, [this](const PageCell& cell) { takeCell(cell); });
    const auto byId = [](const Found& a, const Found& b) { return a.id < b.id; };
    const auto sameId = [](const Found& a, const Found& b) { return a.id == b.id; };
    // A row may be found twice, once in an outdated page; the complete one counts.
    const auto firstTorn = std::stable_partition(m_found.begin(), m_found.end(), [this](const Found& found) {
        return m_pages.isWhole(found.cell.overflow, found.cell.size - found.cell.local);
    });
    std::vector<Found> torn(firstTorn, m_found.end());
    m_found.erase(firstTorn, m_found.end());
    for (auto* rows : {&m_found, &torn}) {
        std::stable_sort(rows->begin(), rows->end(), byId);
        rows->erase(std::unique(rows->begin(), rows->end(), sameId), rows->end());
    }
    std::erase_if(torn, [&](const Found& row) {
        return std::binary_search(m_found.begin(), m_found.end(), row, byId);
    });
    for (std::size_t i = 0; i < std::min(torn.size(), MostGapsReported); ++i)
        m_facts.problems.push_back(fewerBytes(torn[i]));
    if (torn.size() <= MostGapsReported) return;
    m_facts.problems.push_back(
        leitstand::fill(translate("leitstand::Error", "{}: and {} more messages with fewer bytes"),
                        m_file.string(), torn.size() - MostGapsReported));
}

std::string SalvagedFile::fewerBytes(const Found& found) const {
    return leitstand::fill(
        translate("leitstand::Error", "{}: message {} on page {}: expected {} bytes, found fewer"),
        m_file.string(), found.id, found.cell.page, found.cell.size);
}

void SalvagedFile::takeCell(const PageCell& cell) {
    const std::vector<PageColumn> columns = columnsOf(cell);
    if (columns.empty() || !columns[0].isNull()) return;  // all tables of a bag begin with the row's id
    if (takeMessage(cell, columns)) return;
    takeTexts(cell, columns);
}

bool SalvagedFile::takeMessage(const PageCell& cell, const std::vector<PageColumn>& columns) {
    if (columns.size() != 4 || !columns[1].isInteger() || !columns[2].isInteger() || !columns[3].isBlob()) {
        return false;
    }
    const auto topic = integerIn(cell.begin, columns[1]);
    const auto time = integerIn(cell.begin, columns[2]);
    if (!topic || !time || cell.row == 0 || cell.row > MaxId) return false;
    Found found{cell.row, *topic, Time(std::chrono::nanoseconds(*time)), cell, columns[3].offset};
    found.cell.begin = {};
    m_found.push_back(found);
    return true;
}

void SalvagedFile::takeTexts(const PageCell& cell, const std::vector<PageColumn>& columns) {
    const bool metadata = columns.size() == 3 && columns[1].isInteger() && columns[2].isText();
    const bool texts = columns.size() >= 4 && std::all_of(columns.begin() + 1, columns.end(),
                                                          [](const auto& c) { return c.isText(); });
    if (!metadata && !texts) return;
    const auto record = wholeRecord(m_pages, cell);
    if (!record) return;
    const auto text = [&](std::size_t i) { return textIn(*record, columns[i]).value_or(""); };
    if (metadata) {
        auto parsed = parseMetadata(text(2), m_file.string());
        // Pages of replaced copies may remain.
        if (parsed && (!m_metadata || parsed->messages() >= m_metadata->messages()))
            m_metadata = std::move(parsed).value();
    } else if (text(1).starts_with('/')) {
        TopicInfo info{.name = text(1), .type = text(2), .serialization = text(3)};
        if (columns.size() > 4) info.qosProfiles = text(4);
        if (columns.size() > 5) info.typeHash = text(5);
        m_facts.topics[static_cast<std::int64_t>(cell.row)] = {std::move(info), std::nullopt};
    } else if (columns.size() == 5) {
        m_definitions[text(1)] = text(3);
    }
}

void SalvagedFile::finish(const std::string& why) {
    m_facts.closed = false;
    m_facts.ours = m_metadata && m_metadata->custom.contains(std::string(CountedKey));
    if (m_metadata) m_facts.expected = m_metadata->messages();
    // Our copy of the metadata lists the topics in the order of their ids.
    if (m_facts.ours) {
        for (std::size_t i = 0; i < m_metadata->topics.size(); ++i) {
            m_facts.topics.try_emplace(static_cast<std::int64_t>(i + 1),
                                       FileTopic{m_metadata->topics[i].info, std::nullopt});
        }
    }
    for (auto& [id, topic] : m_facts.topics) {
        const auto definition = m_definitions.find(topic.info.type);
        if (definition != m_definitions.end()) topic.info.definition = definition->second;
    }
    m_facts.problems.push_back(leitstand::fill(
        translate("leitstand::Error", "{}; read page by page: {} messages found"), why, m_found.size()));
    m_facts.firstId = m_found.front().id;
    m_facts.lastId = m_found.back().id;
    reportGaps();
    if (!m_facts.ours) {
        std::stable_sort(m_found.begin(), m_found.end(),
                         [](const Found& a, const Found& b) { return a.received < b.received; });
    }
    m_facts.first = m_found.front().received;
    m_facts.last = m_found.back().received;
    count();
}

void SalvagedFile::reportGaps() {
    std::size_t stated = 0;
    for (std::size_t i = 1; i < m_found.size() && stated < MostGapsReported; ++i) {
        const std::uint64_t before = m_found[i - 1].id, after = m_found[i].id;
        if (after == before + 1) continue;
        m_facts.problems.push_back(
            leitstand::fill(translate("leitstand::Error",
                                      "{}: messages {} to {}: expected in a page of the table messages, "
                                      "found nowhere (or never written)"),
                            m_file.string(), before + 1, after - 1));
        if (++stated == MostGapsReported)
            m_facts.problems.push_back(
                leitstand::fill(translate("leitstand::Error", "{}: and further gaps"), m_file.string()));
    }
}

std::optional<BagRow> SalvagedFile::rowOf(const Found& found) {
    const auto record = wholeRecord(m_pages, found.cell);
    if (!record) {
        if (m_unread++ < MostGapsReported) m_news.push_back(fewerBytes(found));
        return std::nullopt;
    }
    BagRow row{found.id, found.topic, found.received, nullptr};
    row.cdr = std::make_shared<const std::vector<std::byte>>(
        record->begin() + static_cast<std::ptrdiff_t>(found.dataOffset), record->end());
    return row;
}

BagFile::Outcome SalvagedFile::fetch(const RowQuery& query, std::vector<BagRow>& rows) {
    const auto after =
        m_facts.ours
            ? std::upper_bound(m_found.begin(), m_found.end(), query.afterId,
                               [](std::uint64_t id, const Found& found) { return id < found.id; })
            : std::upper_bound(m_found.begin(), m_found.end(), std::tuple(query.afterTime, query.afterId),
                               [](const auto& position, const Found& found) {
                                   return position < std::tuple(found.received, found.id);
                               });
    std::size_t bytes = 0;
    for (auto found = after; found != m_found.end(); ++found) {
        if (found->id > query.lastId || found->received > query.lastTime) continue;
        if (query.topics && !query.topics->contains(found->topic)) continue;
        auto row = rowOf(*found);
        if (!row) continue;
        bytes += row->cdr->size();
        rows.push_back(std::move(*row));
        if (rows.size() >= FetchRows || bytes >= FetchBytes) return Outcome::More;
    }
    return Outcome::End;
}

std::optional<BagRow> SalvagedFile::row(std::uint64_t id, bool&) {
    const auto found =
        std::find_if(m_found.begin(), m_found.end(), [id](const Found& one) { return one.id == id; });
    return found == m_found.end() ? std::nullopt : rowOf(*found);
}

std::optional<BagRow> SalvagedFile::lastUpTo(const std::set<std::int64_t>& topics, std::uint64_t id, bool&) {
    std::vector<const Found*> candidates;
    for (const Found& found : m_found) {
        if (found.id <= id && topics.contains(found.topic)) candidates.push_back(&found);
    }
    std::sort(candidates.begin(), candidates.end(),
              [](const Found* a, const Found* b) { return a->id > b->id; });
    for (const Found* found : candidates) {
        if (auto row = rowOf(*found)) return row;
    }
    return std::nullopt;
}

std::uint64_t SalvagedFile::idAt(Time time, bool&) {
    const Found* first = nullptr;
    for (const Found& found : m_found) {
        if (found.received < time) continue;
        if (first == nullptr || found.received < first->received) first = &found;
    }
    return first == nullptr ? 0 : first->id;
}

void SalvagedFile::count() {
    for (auto& [id, topic] : m_facts.topics) topic.messages = 0;
    for (const Found& found : m_found) {
        const auto topic = m_facts.topics.find(found.topic);
        if (topic != m_facts.topics.end()) ++*topic->second.messages;
    }
}

std::vector<std::string> SalvagedFile::newProblems() {
    return std::exchange(m_news, {});
}

}  // namespace leitstand::detail
