#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "core/io/bag/bag_reader.h"
#include "core/io/bag/reading/bag_opening.h"

namespace leitstand::detail {

/// The files of an open bag as one sequence of events. If a file turns out to be damaged, it is read page by
/// page from then on (SalvagedFile).
class ReaderCore {
public:
    explicit ReaderCore(OpenBag bag);

    [[nodiscard]] const std::vector<BagSession>& sessions() const { return m_sessions; }
    [[nodiscard]] const std::vector<BagTopic>& topics() const { return m_topics; }
    [[nodiscard]] const std::vector<std::string>& problems() const { return m_bag.problems; }
    [[nodiscard]] bool ours() const;
    [[nodiscard]] std::uint64_t lastSequence() const;

    [[nodiscard]] const std::vector<BagPart>& parts() const { return m_bag.parts; }
    /// Fetches the next rows of part @p index. After damage, these are the rows that the salvage finds.
    [[nodiscard]] BagFile::Outcome fetch(std::size_t index, const RowQuery& query, std::vector<BagRow>& rows);
    /// Returns @p row of part @p index as an event. Empty when its topic is unknown or it is not CDR; this is
    /// added to problems().
    [[nodiscard]] std::optional<RawEvent> eventOf(std::size_t index, BagRow row);
    /// Returns the ids of the topics @p topics in part @p index.
    [[nodiscard]] std::set<std::int64_t> idsOf(std::size_t index,
                                               const std::vector<std::string>& topics) const;

    [[nodiscard]] std::optional<RawEvent> event(std::uint64_t sequence);
    [[nodiscard]] std::optional<RawEvent> lastUpTo(const std::string& topic, std::uint64_t sequence);
    [[nodiscard]] std::uint64_t sequenceAt(Time time);
    void count();

private:
    [[nodiscard]] bool salvage(std::size_t index);
    void report(const std::string& problem);
    void reportNew(std::size_t index);
    void listSessions();
    void listTopics();
    void takeCountsOfMetadata();

    OpenBag m_bag;
    std::vector<BagSession> m_sessions;  // one per part
    std::vector<BagTopic> m_topics;
    std::set<std::string> m_reported;
    std::set<std::size_t> m_lost;  // parts that even salvage cannot read
};

}  // namespace leitstand::detail
