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

/// The files of an open bag as one sequence of events; goes over to salvage where a file turns out damaged.
class ReaderCore {
public:
    explicit ReaderCore(OpenBag bag);

    [[nodiscard]] const std::vector<BagSession>& sessions() const { return m_sessions; }
    [[nodiscard]] const std::vector<BagTopic>& topics() const { return m_topics; }
    [[nodiscard]] const std::vector<std::string>& problems() const { return m_bag.problems; }
    [[nodiscard]] bool ours() const;
    [[nodiscard]] std::uint64_t lastSequence() const;

    [[nodiscard]] const std::vector<BagPart>& parts() const { return m_bag.parts; }
    /// The next rows of part @p index; after damage, those that salvage finds.
    [[nodiscard]] BagFile::Outcome fetch(std::size_t index, const RowQuery& query, std::vector<BagRow>& rows);
    /// @p row of part @p index as an event; empty, and told, when nobody knows its topic or it is not CDR.
    [[nodiscard]] std::optional<RawEvent> eventOf(std::size_t index, BagRow row);
    /// The ids in part @p index of topics named so.
    [[nodiscard]] std::set<std::int64_t> idsOf(std::size_t index,
                                               const std::vector<std::string>& topics) const;

    [[nodiscard]] std::optional<RawEvent> event(std::uint64_t sequence);
    [[nodiscard]] std::optional<RawEvent> lastUpTo(const std::string& topic, std::uint64_t sequence);
    [[nodiscard]] std::uint64_t sequenceAt(Time time);
    void count();

private:
    [[nodiscard]] bool salvage(std::size_t index);
    void tell(const std::string& problem);
    void tellNews(std::size_t index);
    void listSessions();
    void listTopics();
    void takeCountsOfMetadata();

    OpenBag m_bag;
    std::vector<BagSession> m_sessions;  // one a part
    std::vector<BagTopic> m_topics;
    std::set<std::string> m_told;
    std::set<std::size_t> m_lost;  // parts that not even salvage reads
};

}  // namespace leitstand::detail
