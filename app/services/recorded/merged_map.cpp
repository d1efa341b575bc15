#include "app/services/recorded/merged_map.h"

#include <algorithm>
#include <memory>
#include <optional>
#include <system_error>
#include <utility>

#include "app/services/log/live_mission.h"
#include "app/services/log/sequencer.h"
#include "app/services/mapping/live_mapping.h"
#include "app/services/places/mission_map.h"
#include "app/services/recorded/carried_map.h"
#include "app/services/recorded/recorded_map.h"
#include "core/base/words.h"
#include "core/event/station_topics.h"
#include "core/mapping/live/live_mapper.h"
#include "core/mapping/live/loops/map_problem.h"
#include "core/mapping/relocalisation/parts_meeting.h"

namespace leitstand {
namespace {

/// Shares of the work.
constexpr double First = 0.15, Second = 0.3, Sought = 0.95;

Progress between(const Progress& whole, double from, double to) {
    return {[&whole, from, to](double share) { whole.done(from + (to - from) * share); }, whole.stop};
}

Error cancelled() {
    return Error{translate("leitstand::Station", "cancelled")};
}

/// What holds the two maps together, and where their scans stand by it.
struct Joined {
    ScanLinksSample links;
    ScanPosesSample poses;
};

std::optional<Joined> join(LiveMapper& mapper, const PartsMeeting& meeting) {
    const Time now = stationTime();
    auto links = mapper.join(meeting.scansInMap, now);
    if (!links) return std::nullopt;
    Joined joined{std::move(*links), {}};
    const auto problem = mapper.problem();
    if (!problem) return std::nullopt;
    auto settled = mapper.settle(solve(*problem), now);
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
    if (auto said = (*mission)->say(joined.links, station_topic::ScanLinks); !said) return said;
    if (auto said = (*mission)->say(joined.poses, station_topic::ScanPoses); !said) return said;
    return (*mission)->close();
}

Result<MergedMap> merge(const MergeOrder& order, const Progress& progress) {
    MergedMap merged;
    const CarriedInto into{order.into, {}, order.version};
    const auto first = carryMap(order.first, into, between(progress, 0.0, First));
    if (!first) return first.error();
    merged.first = *first;
    const auto second = addMap(order.second, into, between(progress, First, Second));
    if (!second) return second.error();
    merged.second = *second;
    LiveMapper mapper{std::string(CarriedStation), order.mapping};
    {
        const auto read = readMap(order.into);
        if (!read) return read.error();
        EarlierMap earlier{keyScansOf(*read->bag), posesOf(read->state)};
        earlier.links = scanLinksOf(order.into);
        earlier.bodies = *read->state.bodies;
        restore(mapper, earlier);
    }
    const LiveMapPtr map = mapper.map();
    // The second map's own first part: what else it had in parts stays apart from it.
    const auto begin = std::find_if(map->scans.begin(), map->scans.end(),
                                    [](const LiveKeyScan& scan) { return scan.part == scan.id; });
    if (begin == map->scans.end()) return merged;
    const PartsMeeting meeting =
        meetingOf(map, begin->id, order.mapping, order.relocalisation, between(progress, Second, Sought));
    if (progress.cancelled()) return cancelled();
    merged.sought = meeting.sought;
    merged.found = meeting.found;
    merged.agreeing = meeting.scansInMap.size();
    auto joined = join(mapper, meeting);
    if (!joined) return merged;
    if (auto written = write(order, std::move(*joined)); !written) return written.error();
    merged.together = true;
    return merged;
}

}  // namespace

Result<MergedMap> mergeMaps(const MergeOrder& order, const Progress& progress) {
    for (const std::filesystem::path& mission : {order.first, order.second}) {
        if (auto has = hasMap(mission); !has) return has.error();
    }
    std::error_code none;
    const bool there = std::filesystem::exists(order.into, none);
    auto merged = merge(order, progress);
    // What was there before is another's.
    if (!merged && !there) std::filesystem::remove_all(order.into, none);
    return merged;
}

}  // namespace leitstand
