#include "core/mapping/live/loops/places/place_finder.h"

#include <algorithm>
#include <map>
#include <utility>
#include <vector>

#include "core/mapping/live/scan_work.h"

namespace leitstand {

PlaceFinder::Excluded PlaceFinder::connectedWith(const LiveKeyScan& scan) const {
    return [id = scan.id, near = m_graph.sameAge(scan.id)](const LiveKeyScan& other) {
        return other.id == id || near.contains(other.id);
    };
}

const LiveKeyScan* PlaceFinder::nearestTo(const Pose& guess, const LiveMap& map,
                                          const Excluded& excluded) const {
    const LiveKeyScan* nearest = nullptr;
    double least = m_settings.reach;
    for (const LiveKeyScan& scan : map.scans) {
        if (!scan.counts() || excluded(scan)) continue;
        const double distance = mapDistance(scan.pose.scanInMap, guess);
        if (distance < least) {
            least = distance;
            nearest = &scan;
        }
    }
    return nearest;
}

const LiveKeyScan* PlaceFinder::olderAt(const LiveKeyScan& scan, const Pose& guess, const LiveMap& map,
                                        bool samePart) const {
    return nearestTo(guess, map, [&, connected = connectedWith(scan)](const LiveKeyScan& other) {
        return connected(other) || (samePart && other.part != scan.part);
    });
}

LocalMap PlaceFinder::localAbout(const LiveKeyScan& older, const LiveMap& map,
                                 const Excluded& excluded) const {
    const std::map<std::uint64_t, double> about = m_graph.about(older.id);
    std::vector<LiveKeyScan> others;
    for (const LiveKeyScan& scan : map.scans) {
        if (scan.counts() && about.contains(scan.id) && !excluded(scan)) others.push_back(scan);
    }
    return localMap(others, older.pose.scanInMap);
}

std::optional<MatchedPlace> PlaceFinder::look(const LiveKeyScan& scan, const LiveKeyScan& older,
                                              const Pose& guess, const LiveMap& map,
                                              const Excluded& excluded) const {
    return m_verifier.verify(scan, older, localAbout(older, map, excluded), guess);
}

std::optional<MatchedPlace> PlaceFinder::look(const LiveKeyScan& scan, const LiveKeyScan& older,
                                              const Pose& guess, const LiveMap& map) const {
    return look(scan, older, guess, map, connectedWith(scan));
}

std::optional<MatchedPlace> PlaceFinder::look(const LiveKeyScan& scan, const Pose& guess, const LiveMap& map,
                                              bool samePart) const {
    const LiveKeyScan* const older = olderAt(scan, guess, map, samePart);
    if (older == nullptr || m_graph.wasRefused(older->id, scan.id)) return std::nullopt;
    return look(scan, *older, guess, map);
}

bool PlaceFinder::fitsBeside(const MatchedPlace& found, const LiveKeyScan& scan, const LiveMap& map) const {
    const double expected = m_settings.askBeyond * m_graph.deviation(found.link.from, found.link.to);
    const double within = std::min(m_settings.reach, std::max(expected, found.shift()));
    const auto older = std::find_if(map.scans.begin(), map.scans.end(),
                                    [&](const LiveKeyScan& one) { return one.id == found.link.from; });
    if (older == map.scans.end() || !PlaceVerifier::mayFitBeside(found, within)) return false;
    return m_verifier.fitsBeside(found, scan, *older, localAbout(*older, map, connectedWith(scan)), within);
}

}  // namespace leitstand
