#include "app/services/places/mission_map.h"

#include <map>
#include <memory>
#include <set>
#include <string>
#include <string_view>
#include <system_error>
#include <utility>

#include "core/event/map_samples.h"
#include "core/event/raw_event.h"
#include "core/event/scan_bodies.h"
#include "core/event/scan_pose.h"
#include "core/event/station_topics.h"
#include "core/io/bag/bag_reader.h"
#include "core/io/bag/raw_events.h"
#include "core/mapping/graph/map_parts.h"
#include "core/mapping/graph/scan_graph.h"
#include "core/mission/state/crop_state.h"
#include "core/mission/state/scan_state.h"
#include "core/mission/state/scans_in_parts.h"
#include "transport/convert/decode.h"

namespace leitstand {

namespace {

/// Calls @p take for each sample that @p bag has on @p topic of the stations, in order; skips what makes no
/// sense.
template <class Kind, class Take>
void read(BagReader& bag, std::string_view topic, const Take& take) {
    BagQuery query;
    query.topics = {std::string(topic)};
    forEachRaw(bag, query, [&take](const RawEvent& raw) {
        const auto event = decodeStationEvent(raw);
        const auto* const sample = event ? event->sample.as<Kind>() : nullptr;
        if (sample != nullptr) take(*sample);
        return true;
    });
}

/// Returns the log of the mission @p folder. Null when there is no mission yet, or none that can be read,
/// which LiveMission reports.
std::unique_ptr<BagReader> bagOf(const std::filesystem::path& folder) {
    std::error_code ignored;
    if (!std::filesystem::exists(folder, ignored)) return nullptr;
    auto bag = BagReader::open(folder);
    return bag ? std::move(bag).value() : nullptr;
}

}  // namespace

std::vector<KeyScanSample> keyScansOf(BagReader& bag) {
    std::vector<KeyScanSample> scans;
    std::map<std::uint64_t, std::size_t> places;  // by id
    read<KeyScanSample>(bag, station_topic::KeyScans, [&](KeyScanSample scan) {
        // The newest of a number counts, as in the fold.
        const auto [at, fresh] = places.try_emplace(scan.id, scans.size());
        if (fresh)
            scans.push_back(std::move(scan));
        else
            scans[at->second] = std::move(scan);
    });
    return scans;
}

std::vector<KeyScanSample> keyScansOf(const std::filesystem::path& folder) {
    const auto bag = bagOf(folder);
    return bag ? keyScansOf(*bag) : std::vector<KeyScanSample>();
}

std::vector<ScanLinksSample> scanLinksOf(const std::filesystem::path& folder) {
    std::vector<ScanLinksSample> links;
    if (const auto bag = bagOf(folder)) {
        read<ScanLinksSample>(*bag, station_topic::ScanLinks,
                              [&](ScanLinksSample sample) { links.push_back(std::move(sample)); });
    }
    return links;
}

std::vector<ScanBodiesSample> inSamples(std::map<std::uint64_t, std::vector<BodyInScan>> bodies, Time now) {
    constexpr std::size_t MostBodies = 1'000, MostScans = 200;
    std::vector<ScanBodiesSample> samples;
    std::size_t held = 0;
    for (auto& [scan, known] : bodies) {
        const bool full = !samples.empty() &&
                          (held + known.size() > MostBodies || samples.back().scans.size() >= MostScans);
        if (samples.empty() || full) {
            samples.push_back({now, {}, {}});
            held = 0;
        }
        held += known.size();
        samples.back().scans.push_back({scan, std::move(known)});
    }
    return samples;
}

std::vector<ScanPose> posesOf(const MissionState& mission) {
    std::vector<ScanPose> poses;
    for (const auto& [id, scan] : *mission.keyScans) poses.push_back(scan.pose);
    return poses;
}

std::optional<MapCrop> cropOf(const MissionState& mission) {
    if (!mission.crop) return std::nullopt;
    return MapCrop{areaInMap(mission), mission.crop->sample.ceiling};
}

std::vector<Link> linksOf(const std::filesystem::path& folder, const MissionState& mission) {
    ScanGraph graph;
    for (const ScanLinksSample& sample : scanLinksOf(folder)) {
        for (const Link& link : sample.links) graph.add(link);
    }
    for (const Link& link : loopsOf(mission)) graph.add(link);
    std::vector<Link> links = graph.links();
    const std::set<std::uint64_t> unheld = unheldLoops(links, scansInParts(*mission.keyScans));
    for (Link& link : links) link.active = link.active && !unheld.contains(link.id);
    return links;
}

std::map<std::uint64_t, std::uint64_t> partsOf(const MissionState& mission, const std::vector<Link>& links) {
    std::vector<ScanInPart> scans = scansInParts(*mission.keyScans);
    findParts(scans, MapParts(links));
    std::map<std::uint64_t, std::uint64_t> parts;
    for (const ScanInPart& scan : scans) parts.emplace(scan.id, scan.part);
    return parts;
}

}  // namespace leitstand
