#include "core/mapping/relocalisation/parts_meeting.h"

#include <algorithm>
#include <memory>
#include <utility>
#include <vector>

#include "core/base/pose.h"
#include "core/mapping/live/map/local_map.h"
#include "core/mapping/relocalisation/place_recognition.h"

namespace leitstand {
namespace {

constexpr std::size_t MostSought = 60;
constexpr double Apart = 0.3;          ///< two places that agree differ by at most so much ...
constexpr double ApartOfWay = 0.03;    ///< ... and this share of the distance between them: maps are bent
constexpr double Turned = degrees(5);  ///< and in their headings by at most so much [rad]

/// Returns scans of @p part that count, at least @p apart [m] from each other, and farther if there are too
/// many.
std::vector<const LiveKeyScan*> spread(const LiveMap& map, std::uint64_t part, double apart) {
    std::vector<const LiveKeyScan*> chosen;
    do {
        chosen.clear();
        for (const LiveKeyScan& scan : map.scans) {
            const bool fresh = std::all_of(chosen.begin(), chosen.end(), [&](const LiveKeyScan* one) {
                return mapDistance(one->pose.scanInMap, scan.pose.scanInMap) >= apart;
            });
            if (scan.counts() && scan.part == part && fresh) chosen.push_back(&scan);
        }
        apart *= 1.5;
    } while (chosen.size() > MostSought);
    return chosen;
}

/// A scan that was found on its own.
struct Found {
    const LiveKeyScan* scan = nullptr;
    Pose there = Pose::Identity();       ///< scan in map
    Pose correction = Pose::Identity();  ///< moves its part there, in the map
};

bool agree(const Found& a, const Found& b) {
    const Pose there = a.correction * b.scan->pose.scanInMap;
    const double between = distanceBetween(a.scan->pose.scanInMap, b.scan->pose.scanInMap);
    return distanceBetween(there, b.there) <= Apart + ApartOfWay * between &&
           angleBetween(there, b.there) <= Turned;
}

/// Returns those of @p found that agree with the one that most agree with. Also returns how many of the rest
/// agree on something else.
std::pair<std::vector<const Found*>, std::size_t> agreeing(const std::vector<Found>& found) {
    std::vector<const Found*> best;
    for (const Found& one : found) {
        std::vector<const Found*> with;
        for (const Found& other : found) {
            if (agree(one, other)) with.push_back(&other);
        }
        if (with.size() > best.size()) best = std::move(with);
    }
    std::vector<const Found*> rest;
    for (const Found& one : found) {
        if (std::find(best.begin(), best.end(), &one) == best.end()) rest.push_back(&one);
    }
    std::size_t others = 0;
    for (const Found* one : rest) {
        const auto with = std::count_if(rest.begin(), rest.end(),
                                        [one](const Found* other) { return agree(*one, *other); });
        others = std::max(others, static_cast<std::size_t>(with));
    }
    return {std::move(best), others};
}

}  // namespace

PartsMeeting meetingOf(const LiveMapPtr& map, std::uint64_t part, const LiveSettings& settings,
                       const RelocalisationSettings& how, const Progress& progress) {
    PartsMeeting meeting;
    const auto first = std::make_shared<LiveMap>();
    for (const LiveKeyScan& scan : map->scans) {
        if (scan.counts() && scan.part == 0) first->scans.push_back(scan);
    }
    if (part == 0 || first->scans.empty()) return meeting;
    const Progress quiet{{}, progress.stop};  // progress within a single scan is not reported
    const Relocaliser relocaliser(first, settings, how, quiet);
    const std::vector<const LiveKeyScan*> sought = spread(*map, part, settings.loops.seekPartsEvery);
    std::vector<Found> found;
    for (const LiveKeyScan* const scan : sought) {
        const Relocalisation place =
            relocaliser.find(*scan->scan, scan->reduced->unpacked(), upOf(*scan), quiet);
        if (progress.cancelled()) return {};
        ++meeting.sought;
        progress.done(static_cast<double>(meeting.sought) / static_cast<double>(sought.size()));
        if (!place.sure) continue;
        const Pose& there = place.places.front().scanInMap;
        found.push_back({scan, there, there * scan->pose.scanInMap.inverse()});
    }
    meeting.found = found.size();
    const auto [best, others] = agreeing(found);
    if (best.size() < std::max(settings.loops.partsAgree, 2 * others)) return meeting;
    // The one in the middle: where the two maps are bent differently, both ends are off.
    const Found* const middle = best[best.size() / 2];
    if (contradictsPart({middle->scan->id, map, {}, true}, *first, middle->correction, quiet)) return meeting;
    for (const Found* const one : best) meeting.scansInMap.emplace(one->scan->id, one->there);
    return meeting;
}

}  // namespace leitstand
