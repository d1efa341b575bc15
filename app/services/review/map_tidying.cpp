#include "app/services/review/map_tidying.h"

#include <algorithm>
#include <map>
#include <memory>
#include <set>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "app/services/log/live_mission.h"
#include "app/services/log/sequencer.h"
#include "app/services/mapping/live_mapping.h"
#include "app/services/places/mission_map.h"
#include "app/services/recorded/recorded_map.h"
#include "core/base/words.h"
#include "core/event/station_samples.h"
#include "core/event/station_topics.h"
#include "core/mapping/relaxation/missing_links.h"
#include "core/mission/state/decision.h"
#include "core/mission/state/decisions.h"
#include "core/mission/state/scan_state.h"
#include "core/mission/state/undo_format.h"

namespace leitstand {
namespace {

constexpr std::string_view Tidying = TidyingStation;
constexpr std::size_t LinksAtOnce = 5'000;  ///< in an event

LiveMissionSettings session(const std::string& version) {
    LiveMissionSettings settings;
    settings.station = Tidying;
    settings.title = "Tidying";
    settings.version = version;
    return settings;
}

/// Returns the changes of @p links by @p found. Of links that @p isNew selects, which nobody has written yet,
/// returns those that still count.
template <class IsNew>
std::vector<Link> changesOf(const std::vector<Link>& links, const Relaxation& found, IsNew isNew) {
    std::set<std::uint64_t> ends(found.contradicted.begin(), found.contradicted.end());
    ends.insert(found.replaced.begin(), found.replaced.end());
    std::vector<Link> changes;
    std::uint64_t next = 1;
    for (const Link& link : links) {
        next = std::max(next, link.id + 1);
        const bool ended = link.active && ends.contains(link.id);
        if (isNew(link) ? ended : !ended) continue;
        changes.push_back(link);
        changes.back().active = !ended;
    }
    for (Link link : found.matches) {
        link.id = next++;
        changes.push_back(std::move(link));
    }
    return changes;
}

Result<void> record(LiveMission& mission, std::vector<Link> links, Time now) {
    for (std::size_t first = 0; first < links.size(); first += LinksAtOnce) {
        const auto begin = links.begin() + static_cast<std::ptrdiff_t>(first);
        const auto end =
            links.begin() + static_cast<std::ptrdiff_t>(std::min(first + LinksAtOnce, links.size()));
        ScanLinksSample sample{now, std::string(Tidying), {begin, end}};
        for (Link& link : sample.links) link.station = Tidying;
        if (auto recorded = mission.record(sample, station_topic::ScanLinks); !recorded) return recorded;
    }
    return {};
}

/// Returns the poses of @p state that @p nodes change noticeably, as they are now.
std::vector<ScanPose> movedPoses(const MissionState& state, const std::vector<GraphNode>& nodes,
                                 const LoopSettings& loops) {
    std::vector<ScanPose> moved;
    for (const GraphNode& node : nodes) {
        const auto scan = state.keyScans->find(node.id);
        if (scan == state.keyScans->end()) continue;
        const ScanPose& before = scan->second.pose;
        if (!isNoticed(before.scanInMap, node.pose, loops)) continue;
        moved.push_back(before);
        moved.back().scanInMap = node.pose;
    }
    return moved;
}

/// Returns the newest decision of a tidying that is not taken back; null: none.
const Decision* newestTidying(const MissionState& state) {
    const auto& all = *state.decisions;
    const auto found = std::find_if(all.rbegin(), all.rend(), [](const Decision& decision) {
        const auto* poses = std::get_if<ScanPosesSample>(&decision.content);
        return poses != nullptr && !decision.undone && poses->station == Tidying;
    });
    return found == all.rend() ? nullptr : &*found;
}

/// Whether scans entered the map, or somebody moved some, after the event of @p sequence.
bool wentOn(const MissionState& state, std::uint64_t sequence) {
    const bool entered = std::any_of(state.keyScans->begin(), state.keyScans->end(),
                                     [&](const auto& scan) { return scan.second.sequence > sequence; });
    return entered || std::any_of(state.decisions->begin(), state.decisions->end(), [&](const Decision& one) {
               const bool ofMap = std::holds_alternative<ScanPosesSample>(one.content) ||
                                  std::holds_alternative<ScanLinksSample>(one.content);
               return ofMap && !one.undone && one.sequence > sequence;
           });
}

}  // namespace

std::string tidiedText(const TidiedMap& tidied) {
    if (tidied.moved == 0 && tidied.linked > 0)
        return fill(translate("leitstand::Station",
                              "the map is tidy: nothing moved; its scans are held together by {} links now"),
                    tidied.linked);
    if (tidied.moved == 0)
        return translate("leitstand::Station", "the map is tidy: nothing moved, nothing was written");
    std::string text =
        fill(translate("leitstand::Station", "the map is tidied: {} of {} scans moved, by up to {} m"),
             tidied.moved, tidied.scans, fmt::format("{:.2f}", tidied.relaxation.largest));
    if (!tidied.relaxation.contradicted.empty())
        text += fill(translate("leitstand::Station",
                               "; {} links of loops contradict the rest and do not count any more"),
                     tidied.relaxation.contradicted.size());
    return text;
}

bool canUntidy(const MissionState& finished) {
    const Decision* const newest = newestTidying(finished);
    return newest != nullptr && !wentOn(finished, newest->sequence);
}

std::map<std::uint64_t, Pose> posesBeforeTidying(MissionState finished) {
    const Decision* const newest = newestTidying(finished);
    if (newest == nullptr) return {};
    const std::vector<ScanPose> moved = std::get<ScanPosesSample>(newest->content).poses;
    Decision back;
    back.sequence = finished.sequence + 1;
    back.content = UndoSample{{}, std::string(Tidying), newest->sequence, {}};
    decide(finished, std::move(back));
    std::map<std::uint64_t, Pose> poses;
    for (const ScanPose& one : moved) {
        const auto scan = finished.keyScans->find(one.scan);
        if (scan != finished.keyScans->end()) poses.emplace(one.scan, scan->second.pose.scanInMap);
    }
    return poses;
}

Result<TidiedMap> tidyMap(const std::filesystem::path& folder, const TidySettings& settings,
                          const Progress& progress) {
    constexpr double Reading = 0.1;  // share of the work
    const auto read = readMap(folder);
    if (!read) return read.error();
    const MissionState& state = read->state;
    EarlierMap earlier{keyScansOf(*read->bag), posesOf(state)};
    if (earlier.scans.empty())
        return Error{fill(translate("leitstand::Station", "{}: expected a map of ours, found no key scans"),
                          folder.string())};
    std::vector<Link> links = linksOf(*read);
    earlier.bodies = *state.bodies;
    LiveSettings mapping = settings.mapping;
    mapping.crop = cropOf(state).value_or(MapCrop{});
    LiveMapper mapper{std::string(Tidying), mapping};
    restore(mapper, earlier);
    earlier.scans.clear();
    progress.done(Reading);
    TidiedMap tidied;
    const LiveMapPtr map = mapper.map();
    tidied.scans = map->scans.size();
    std::uint64_t first = 1;  // id of a link that nobody has written
    for (const Link& link : links) first = std::max(first, link.id + 1);
    const std::vector<Link> missing = missingLinks(*map, links, first);
    links.insert(links.end(), missing.begin(), missing.end());
    tidied.relaxation =
        relax(*map, links, mapping, settings.relaxation,
              {[&](double share) { progress.done(Reading + (1.0 - Reading) * share); }, progress.stop});
    if (progress.cancelled())
        return Error{translate("leitstand::Station", "cancelled: the map is as it was")};
    const std::vector<ScanPose> moved = movedPoses(state, tidied.relaxation.nodes, mapping.loops);
    tidied.moved = moved.size();
    const std::vector<Link> changes =
        changesOf(links, tidied.relaxation, [first](const Link& link) { return link.id >= first; });
    if (!missing.empty()) tidied.linked = changes.size();
    if (moved.empty() && tidied.linked == 0) return tidied;  // it is tidy
    auto mission = openAgain(*read, session(settings.version));
    if (!mission) return mission.error();
    const Time now = stationTime();
    if (auto recorded = record(**mission, changes, now); !recorded) return recorded.error();
    const ScanPosesSample poses{now, std::string(Tidying), ScanPosesSample::Cause::LoopClosure, moved};
    if (auto recorded = (*mission)->record(poses, station_topic::ScanPoses); !recorded)
        return recorded.error();
    if (auto closed = (*mission)->close(); !closed) return closed.error();
    return tidied;
}

Result<void> untidyMap(const std::filesystem::path& folder, const std::string& version) {
    const auto read = readMap(folder);
    if (!read) return read.error();
    const MissionState& state = read->state;
    const Decision* const newest = newestTidying(state);
    if (newest == nullptr)
        return Error{fill(translate("leitstand::Station", "{}: its map was not tidied"), folder.string())};
    if (wentOn(state, newest->sequence))
        return Error{fill(translate("leitstand::Station", "{}: the tidied map went on since; it stays"),
                          folder.string())};
    const Time tidied = std::get<ScanPosesSample>(newest->content).stamp;
    std::map<std::uint64_t, bool> now;  // whether links count
    for (const Link& link : linksOf(*read)) now[link.id] = link.active;
    std::vector<Link> changes;
    for (const ScanLinksSample& sample : scanLinksOf(folder)) {
        if (sample.station != Tidying || sample.stamp != tidied) continue;
        for (Link link : sample.links) {
            if (now[link.id] != link.active) continue;  // somebody decided otherwise since
            link.active = !link.active;
            changes.push_back(std::move(link));
        }
    }
    auto mission = openAgain(*read, session(version));
    if (!mission) return mission.error();
    const Time stamp = stationTime();
    if (auto recorded = record(**mission, std::move(changes), stamp); !recorded) return recorded;
    const UndoSample undo{stamp, std::string(Tidying), newest->sequence,
                          undoText({.kind = UndoneThing::Kind::TidiedMap})};
    if (auto recorded = (*mission)->record(undo, station_topic::Undo); !recorded) return recorded;
    return (*mission)->close();
}

}  // namespace leitstand
