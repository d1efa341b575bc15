#include "app/services/recorded/merged_map.h"

#include <algorithm>
#include <map>
#include <memory>
#include <optional>
#include <system_error>
#include <utility>

#include "app/services/log/live_mission.h"
#include "app/services/log/sequencer.h"
#include "app/services/mapping/live_mapping.h"
#include "app/services/places/mission_map.h"
#include "app/services/progress_part.h"
#include "app/services/recorded/carried_map.h"
#include "app/services/recorded/new_folder.h"
#include "app/services/recorded/recorded_map.h"
#include "core/base/words.h"
#include "core/event/station_topics.h"
#include "core/mapping/live/live_mapper.h"
#include "core/mapping/live/loops/map_problem.h"
#include "core/mapping/relocalisation/parts_meeting.h"
#include "core/mission/state/scan_state.h"

namespace leitstand {
namespace {

/// Shares of the work, by step.
constexpr double First = 0.15, Second = 0.3, Sought = 0.95;

Error cancelled() {
    return Error{translate("leitstand::Station", "cancelled")};
}

/// What holds the two maps together, and the poses of their scans by it.
struct Joined {
    ScanLinksSample links;
    ScanPosesSample poses;
};

std::optional<Joined> join(LiveMapper& mapper, const PartsMeeting& meeting, const Progress& progress) {
    const Time now = stationTime();
    auto links = mapper.join(meeting.scansInMap, now);
    if (!links) return std::nullopt;
    Joined joined{std::move(*links), {}};
    const auto problem = mapper.problem();
    if (!problem) return std::nullopt;
    auto settled = mapper.settle(solve(*problem, {{}, progress.stop}), now);
    if (!settled.poses) return std::nullopt;
    joined.poses = std::move(*settled.poses);
    return joined;
}

Result<void> write(const MergeOrder& order, Joined joined) {
    LiveMissionSettings settings;
    settings.folder = order.into;
    settings.station = CarriedStation;
    settings.title = "Merging";
    settings.version = order.version;
    auto mission = LiveMission::open(settings);
    if (!mission) return mission.error();
    joined.links.station = joined.poses.station = CarriedStation;
    for (Link& link : joined.links.links) link.station = CarriedStation;
    if (auto recorded = (*mission)->record(joined.links, station_topic::ScanLinks); !recorded)
        return recorded;
    if (auto recorded = (*mission)->record(joined.poses, station_topic::ScanPoses); !recorded)
        return recorded;
    return (*mission)->close();
}

/// Returns the part of @p map that most scans with numbers above @p behind belong to; 0: none.
std::uint64_t largestPart(const LiveMap& map, std::uint64_t behind) {
    std::map<std::uint64_t, std::size_t> sizes;
    for (const LiveKeyScan& scan : map.scans) {
        if (scan.counts() && scan.id > behind && scan.part != 0) ++sizes[scan.part];
    }
    const auto largest = std::max_element(sizes.begin(), sizes.end(),
                                          [](const auto& a, const auto& b) { return a.second < b.second; });
    return largest == sizes.end() ? 0 : largest->first;
}

Result<MergedMap> merge(const MergeOrder& order, const Progress& progress) {
    MergedMap merged;
    const CarriedInto into{order.into, {}, order.version};
    const auto first = carryMap(order.first, into, part(progress, 0.0, First));
    if (!first) return first.error();
    merged.first = *first;
    std::uint64_t behind = 0;  // highest number of the first one's scans
    {
        const auto read = readMap(order.into);
        if (!read) return read.error();
        behind = read->state.keyScans->rbegin()->first;
    }
    const auto second = addMap(order.second, into, part(progress, First, Second));
    if (!second) return second.error();
    merged.second = *second;
    LiveSettings mapping = order.mapping;
    std::optional<LiveMapper> opened;
    {
        const auto read = readMap(order.into);
        if (!read) return read.error();
        mapping.crop = cropOf(read->state).value_or(MapCrop{});
        opened.emplace(std::string(CarriedStation), mapping);
        EarlierMap earlier{keyScansOf(*read->bag), posesOf(read->state)};
        earlier.links = scanLinksOf(order.into);
        earlier.bodies = *read->state.bodies;
        if (progress.cancelled()) return cancelled();
        restore(*opened, earlier);
    }
    LiveMapper& mapper = *opened;
    const LiveMapPtr map = mapper.map();
    const std::uint64_t sought = largestPart(*map, behind);
    const PartsMeeting meeting =
        meetingOf(map, sought, mapping, order.relocalisation, part(progress, Second, Sought));
    if (progress.cancelled()) return cancelled();
    merged.sought = meeting.sought;
    merged.found = meeting.found;
    merged.agreeing = meeting.scansInMap.size();
    auto joined = join(mapper, meeting, progress);
    if (progress.cancelled()) return cancelled();
    merged.together = joined.has_value();
    for (const LiveKeyScan& scan : mapper.map()->scans)
        merged.aside += scan.counts() && scan.id > behind && scan.part != 0 ? 1 : 0;
    if (!joined) return merged;
    if (auto written = write(order, std::move(*joined)); !written) return written.error();
    return merged;
}

/// Returns when the mission @p folder began, by its station's clock.
Result<Time> beginOf(const std::filesystem::path& folder) {
    const auto read = readMap(folder);
    if (!read) return read.error();
    return read->state.first;
}

}  // namespace

Result<MergedMap> mergeMaps(const MergeOrder& order, const Progress& progress) {
    for (const std::filesystem::path& mission : {order.first, order.second}) {
        if (auto has = hasMap(mission); !has) return has.error();
    }
    std::error_code none;
    if (std::filesystem::equivalent(order.first, order.second, none))
        return Error{fill(translate("leitstand::Station", "{}: a map is merged with that of another mission"),
                          order.second.string())};
    const auto first = beginOf(order.first), second = beginOf(order.second);
    if (!first) return first.error();
    if (!second) return second.error();
    if (std::filesystem::exists(order.into, none) && !std::filesystem::is_empty(order.into, none))
        return isThere(order.into);
    MergeOrder inTime = order;
    if (*second < *first) std::swap(inTime.first, inTime.second);
    NewFolder guard(order.into);
    auto merged = merge(inTime, progress);
    if (merged) guard.keep();
    return merged;
}

}  // namespace leitstand
