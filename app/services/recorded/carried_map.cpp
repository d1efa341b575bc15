#include "app/services/recorded/carried_map.h"

#include <algorithm>
#include <cstdint>
#include <map>
#include <memory>
#include <set>
#include <string>
#include <system_error>
#include <utility>

#include <fmt/format.h>

#include "app/services/log/live_mission.h"
#include "app/services/log/mission_robots.h"
#include "app/services/log/sequencer.h"
#include "app/services/places/mission_map.h"
#include "app/services/recorded/new_folder.h"
#include "app/services/recorded/recorded_map.h"
#include "app/services/recorded/review_log.h"
#include "core/base/words.h"
#include "core/event/map_samples.h"
#include "core/event/scan_bodies.h"
#include "core/event/scan_pose.h"
#include "core/event/station_topics.h"
#include "core/io/bag/bag_reader.h"
#include "core/mapping/comparison/map_changes.h"
#include "core/mapping/live/live_settings.h"
#include "core/mission/state/scan_state.h"

namespace leitstand {
namespace {

constexpr std::size_t AtOnce = 5'000;  ///< links or poses in an event

/// Calls @p record with all of @p all, some at a time.
template <class T, class Record>
Result<void> recordInPieces(const std::vector<T>& all, const Record& record) {
    for (std::size_t first = 0; first < all.size(); first += AtOnce) {
        const auto begin = all.begin() + static_cast<std::ptrdiff_t>(first);
        const auto end = all.begin() + static_cast<std::ptrdiff_t>(std::min(first + AtOnce, all.size()));
        if (auto recorded = record(std::vector<T>(begin, end)); !recorded) return recorded;
    }
    return {};
}

/// The place of a map in its new mission.
struct Berth {
    std::string name;  ///< of its mission there
    std::map<std::string, std::string> missions =
        {};  ///< what follows the @ in its robots' names, by what followed it before
    std::uint64_t scans = 0, links = 0;  ///< highest numbers in earlier maps: new ones start after them
    Pose aside = Pose::Identity();       ///< applied to its poses
};

/// Returns the links of @p links that hold @p scans. A closed loop becomes an ordinary match from now on.
std::vector<Link> carriedLinks(const std::vector<Link>& links, const std::set<std::uint64_t>& scans,
                               const Berth& berth) {
    std::vector<Link> carried;
    for (const Link& link : links) {
        const bool refused = !link.active && link.kind == LinkKind::Operator;
        if (!scans.contains(link.from) || !scans.contains(link.to) || (!link.active && !refused)) continue;
        carried.push_back(link);
        Link& here = carried.back();
        here.station = CarriedStation;
        here.id += berth.links;
        here.from += berth.scans;
        here.to += berth.scans;
        if (link.active && closesLoop(link.kind)) here.kind = LinkKind::Match;
    }
    return carried;
}

Error noMapIn(const std::filesystem::path& mission) {
    return Error{fill(translate("leitstand::Station", "{}: expected a map of ours, found no key scans"),
                      mission.string())};
}

std::string nameOf(const std::filesystem::path& mission) {
    std::error_code none;
    const std::filesystem::path whole = std::filesystem::weakly_canonical(mission, none);
    return (whole.has_filename() ? whole : whole.parent_path()).filename().string();
}

/// Returns @p name, with a number appended if it is one of @p taken, and adds the result to @p taken.
std::string madeUnique(const std::string& name, std::set<std::string>& taken) {
    std::string unique = name;
    for (int number = 2; !taken.insert(unique).second; ++number) unique = fmt::format("{}-{}", name, number);
    return unique;
}

/// Returns the new names of the missions that @p state is made of, in a mission that has @p taken already;
/// its own is called @p name.
std::map<std::string, std::string> missionsOf(const MissionState& state, const std::string& name,
                                              std::set<std::string> taken) {
    std::map<std::string, std::string> missions;
    for (const auto& [id, scan] : *state.keyScans) {
        const std::string mission = carriedFrom(scan.entry.robot);
        if (!missions.contains(mission))
            missions.emplace(mission, madeUnique(mission.empty() ? name : mission, taken));
    }
    return missions;
}

/// Returns @p scan as it is in another mission.
KeyScanSample moved(KeyScanSample scan, const Berth& berth) {
    Scan other = *scan.scan;
    const std::string mission = carriedFrom(other.robot);
    other.robot = other.robot.substr(0, other.robot.find('@')) + "@" + berth.missions.at(mission);
    scan.scan = std::make_shared<const Scan>(std::move(other));
    scan.stamp = stationTime();
    scan.id += berth.scans;
    if (scan.matched != 0) scan.matched += berth.scans;
    scan.scanInMap = berth.aside * scan.scanInMap;
    return scan;
}

/// Returns the place beside the map of @p there for the map of @p state, whose mission is called @p name.
Berth berthBeside(const RecordedMap& there, const MissionState& state, const std::string& name) {
    constexpr double ReachOfScans = 20.0;  // so that the two do not overlap [m]
    Berth berth{name};
    double lowest = 0.0, highest = 0.0;
    for (const ScanPose& pose : posesOf(there.state)) {
        berth.scans = std::max(berth.scans, pose.scan);
        lowest = std::min(lowest, pose.scanInMap.translation().y());
    }
    for (const ScanPose& pose : posesOf(state)) highest = std::max(highest, pose.scanInMap.translation().y());
    for (const ScanLinksSample& sample : scanLinksOf(there.folder)) {
        for (const Link& link : sample.links) berth.links = std::max(berth.links, link.id);
    }
    std::set<std::string> taken;
    for (const auto& [id, scan] : *there.state.keyScans) taken.insert(carriedFrom(scan.entry.robot));
    berth.missions = missionsOf(state, name, std::move(taken));
    berth.aside.translation().y() = lowest - highest - LoopSettings().partsApart - ReachOfScans;
    return berth;
}

Result<std::size_t> carry(const RecordedMap& map, const CarriedInto& into, const Berth& berth,
                          const Progress& progress) {
    std::vector<ScanPose> poses;
    std::set<std::uint64_t> carried;
    std::size_t counting = 0;
    for (const ScanPose& pose : posesOf(map.state)) {
        const bool counts = pose.trust == ScanTrust::Certain;
        // The first scan of a part distinguishes it from others, even when that scan does not count any more.
        if (!counts && map.state.keyScans->at(pose.scan).entry.matched != 0) continue;
        poses.push_back(pose);
        if (!counts) poses.back().trust = ScanTrust::SetAside;
        carried.insert(pose.scan);
        if (counts) ++counting;
    }
    std::vector<KeyScanSample> scans = keyScansOf(*map.bag);
    std::erase_if(scans, [&](const KeyScanSample& scan) { return !scan.scan || !carried.contains(scan.id); });
    if (scans.empty() || counting == 0) return noMapIn(map.folder);
    LiveMissionSettings settings;
    settings.folder = into.folder;
    settings.robots = into.robots;
    carryMapping(map.folder, settings.robots);  // the map goes on with the scanners that made it
    settings.station = CarriedStation;
    settings.title = berth.name;
    settings.version = into.version;
    auto mission = LiveMission::open(settings);
    if (!mission) return mission.error();
    for (std::size_t i = 0; i < scans.size(); ++i) {
        if (progress.cancelled()) return Error{translate("leitstand::Station", "cancelled")};
        if (auto recorded = (*mission)->record(moved(std::move(scans[i]), berth), station_topic::KeyScans);
            !recorded)
            return recorded.error();
        // What waits for the disk stays in memory.
        if (i % 50 == 49) {
            if (auto kept = (*mission)->flush(); !kept) return kept.error();
        }
        progress.done(static_cast<double>(i + 1) / static_cast<double>(scans.size()));
    }
    const Time now = stationTime();
    auto recorded = recordInPieces(carriedLinks(linksOf(map), carried, berth), [&](std::vector<Link> links) {
        return (*mission)->record(ScanLinksSample{now, std::string(CarriedStation), std::move(links)},
                                  station_topic::ScanLinks);
    });
    if (!recorded) return recorded.error();
    for (ScanPose& pose : poses) {
        pose.scan += berth.scans;
        pose.scanInMap = berth.aside * pose.scanInMap;
    }
    recorded = recordInPieces(poses, [&](std::vector<ScanPose> some) {
        return (*mission)->record(ScanPosesSample{now, std::string(CarriedStation),
                                                  ScanPosesSample::Cause::Registration, std::move(some)},
                                  station_topic::ScanPoses);
    });
    if (!recorded) return recorded.error();
    std::map<std::uint64_t, std::vector<BodyInScan>> bodies;
    for (const auto& [scan, those] : *map.state.bodies) {
        if (carried.contains(scan)) bodies.emplace(scan + berth.scans, those);
    }
    for (ScanBodiesSample& sample : inSamples(std::move(bodies), now)) {
        sample.station = CarriedStation;
        if (auto kept = (*mission)->record(sample, station_topic::ScanBodies); !kept) return kept.error();
    }
    if (const auto crop = cropOf(map.state); crop && berth.scans == 0) {
        const MapCropSample area{now, std::string(CarriedStation), crop->polygon, crop->ceiling};
        if (auto kept = (*mission)->record(area, station_topic::MapCrop); !kept) return kept.error();
    }
    if (auto closed = (*mission)->close(); !closed) return closed.error();
    return counting;
}

}  // namespace

Error isThere(const std::filesystem::path& folder) {
    return Error{
        fill(translate("leitstand::Station", "{}: it is there already: a map is carried into a new mission"),
             folder.string())};
}

Result<void> hasMap(const std::filesystem::path& mission) {
    auto bag = BagReader::open(mission);
    if (!bag) return bag.error();
    const auto& topics = (*bag)->topics();
    const bool any = std::any_of(topics.begin(), topics.end(), [](const BagTopic& topic) {
        return topic.info.name == station_topic::KeyScans && topic.messages.value_or(1) > 0;
    });
    if (!any || isOfOthers(mission)) return noMapIn(mission);
    return {};
}

Result<std::size_t> carryMap(const std::filesystem::path& from, const CarriedInto& into,
                             const Progress& progress) {
    std::error_code none;
    if (std::filesystem::exists(into.folder, none) && !std::filesystem::is_empty(into.folder, none))
        return isThere(into.folder);
    NewFolder guard(into.folder);  // half a map is none
    const auto read = readMap(from);
    if (!read) return read.error();
    const std::string name = nameOf(from);
    auto carried = carry(*read, into, {name, missionsOf(read->state, name, {})}, progress);
    if (carried) guard.keep();
    return carried;
}

Result<std::size_t> addMap(const std::filesystem::path& from, const CarriedInto& into,
                           const Progress& progress) {
    const auto read = readMap(from);
    if (!read) return read.error();
    const auto there = readMap(into.folder);
    if (!there) return there.error();
    return carry(*read, into, berthBeside(*there, read->state, nameOf(from)), progress);
}

}  // namespace leitstand
