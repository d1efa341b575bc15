#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <set>
#include <span>

#include "core/base/result.h"
#include "core/event/scan_links.h"
#include "core/mapping/live/growing_map.h"
#include "core/mapping/live/loops/map_problem.h"
#include "core/mapping/live/loops/places/sought_place.h"
#include "core/mapping/live/loops/submap.h"
#include "core/mapping/live/map/map_update.h"

namespace leitstand {

/// Finds links where robots return to mapped places, and applies the solution of the map. Functions are
/// documented in LiveMapper.
class MapLinks {
public:
    explicit MapLinks(GrowingMap& map) : m_map(map) {}

    void restore(const ScanLinksSample& sample);
    void followLoops(std::span<const Link> loops);
    void takeAsSolved() { m_map.unsolved = false; }
    [[nodiscard]] std::optional<SoughtPlace> sought();
    [[nodiscard]] std::optional<ScanLinksSample> recognised(const SoughtPlace& sought, const Pose& scanInMap,
                                                            Time now);
    [[nodiscard]] Result<ScanLinksSample> propose(std::uint64_t id, const Pose& scanInMap, Time now);
    [[nodiscard]] std::optional<ScanLinksSample> join(const std::map<std::uint64_t, Pose>& scansInMap,
                                                      Time now);
    [[nodiscard]] bool meetsMore() const { return !m_map.meeting.empty(); }
    [[nodiscard]] std::optional<ScanLinksSample> meetMore(Time now);
    void meetNoMore();
    [[nodiscard]] Result<ScanLinksSample> moveTo(std::uint64_t scan, SubmapKind kind, const Pose& scanInMap,
                                                 Time now);
    [[nodiscard]] std::optional<MapProblem> problem();
    [[nodiscard]] MapProblem problemWith(std::span<const Link> links) const;
    [[nodiscard]] Settled settle(const MapSolution& solution, Time now);
    void leaveUnsettled() { m_map.unsolved = true; }
    [[nodiscard]] std::set<std::uint64_t> together(std::uint64_t id) const;

private:
    GrowingMap& m_map;
    bool m_soughtElsewhere = false;  ///< whether the last scan of sought() was looked for in other parts
};

}  // namespace leitstand
