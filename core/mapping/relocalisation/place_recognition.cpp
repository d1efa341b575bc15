#include "core/mapping/relocalisation/place_recognition.h"

#include <algorithm>
#include <cstddef>
#include <memory>
#include <vector>

#include "core/mapping/live/loops/places/free_space.h"
#include "core/mapping/live/map/local_map.h"

namespace leitstand {
namespace {

constexpr double Beside = 2.0;  ///< scans so near each other look through the same space [m]
/// Largest share of recent scans that may contradict earlier ones. Over so long a path even a connected map
/// is bent a little.
constexpr double MostAgainst = 0.1;
/// Used when the relative pose of two parts is not known. Half of the scans that meet the other part have at
/// most this share of their points where that part looked through. For corridors that look alike it was 4 %
/// and more, for the same ones 1 % and less.
constexpr double PartsFilled = 0.02;

/// Returns whether recent scans, or all of @p part, moved by @p correction, stand where @p earlier looked
/// through.
bool contradicts(const SoughtPlace& sought, std::uint64_t part, const LiveMap& earlier,
                 const Pose& correction, double mostFilled, const Progress& progress) {
    std::vector<double> filled;
    for (const LiveKeyScan& scan : sought.map->scans) {
        if (progress.cancelled()) return true;
        const bool along = sought.elsewhere ? scan.part == part : sought.lately.contains(scan.id);
        if (!scan.counts() || !along) continue;
        const Pose there = correction * scan.pose.scanInMap;
        const LiveKeyScan* nearest = nullptr;
        double least = Beside;
        for (const LiveKeyScan& other : earlier.scans) {
            const double distance = mapDistance(other.pose.scanInMap, there);
            if (distance >= least) continue;
            least = distance;
            nearest = &other;
        }
        if (nearest == nullptr) continue;
        const Pose inNearest = nearest->pose.scanInMap.inverse() * there;
        filled.push_back(filledShare(*nearest->scan, *scan.scan, inNearest));
    }
    if (sought.elsewhere && !filled.empty()) {
        const auto middle = filled.begin() + static_cast<std::ptrdiff_t>(filled.size() / 2);
        std::nth_element(filled.begin(), middle, filled.end());
        return *middle > PartsFilled;
    }
    const auto against =
        std::count_if(filled.begin(), filled.end(), [&](double share) { return share > mostFilled; });
    return static_cast<double>(against) > std::max(1.0, MostAgainst * static_cast<double>(filled.size()));
}

}  // namespace

bool contradictsPart(const SoughtPlace& sought, const LiveMap& rest, const Pose& correction,
                     const Progress& progress) {
    const auto& scans = sought.map->scans;
    const auto scan =
        std::find_if(scans.begin(), scans.end(), [&](const auto& one) { return one.id == sought.scan; });
    return scan == scans.end() || contradicts(sought, scan->part, rest, correction, PartsFilled, progress);
}

std::optional<Pose> recognise(const SoughtPlace& sought, const LiveSettings& settings,
                              const RelocalisationSettings& how, const Progress& progress) {
    const auto& scans = sought.map->scans;
    const auto scan =
        std::find_if(scans.begin(), scans.end(), [&](const auto& one) { return one.id == sought.scan; });
    if (scan == scans.end()) return std::nullopt;
    const auto earlier = std::make_shared<LiveMap>();
    for (const LiveKeyScan& one : scans) {
        const bool passed = sought.elsewhere ? one.part == scan->part : sought.lately.contains(one.id);
        if (one.counts() && !passed) earlier->scans.push_back(one);
    }
    const Relocaliser relocaliser(earlier, settings, how, progress);
    const Relocalisation found =
        relocaliser.find(*scan->scan, scan->reduced->unpacked(), upOf(*scan), progress);
    if (progress.cancelled() || !found.sure) return std::nullopt;
    const Pose there = found.places.front().scanInMap;
    const Pose correction = there * scan->pose.scanInMap.inverse();
    if (contradicts(sought, scan->part, *earlier, correction, 2.0 * how.mostFilled, progress))
        return std::nullopt;
    return there;
}

}  // namespace leitstand
