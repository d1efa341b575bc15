#include "app/services/places/mission_map.h"

#include <map>
#include <string>
#include <system_error>
#include <variant>

#include "core/event/station_topics.h"
#include "core/io/bag/bag_reader.h"
#include "transport/convert/decode.h"

namespace leitstand {

std::vector<KeyScanSample> keyScansOf(BagReader& bag) {
    std::vector<KeyScanSample> scans;
    std::map<std::uint64_t, std::size_t> places;  // by id
    BagQuery query;
    query.topics = {std::string(station_topic::KeyScans)};
    BagCursor cursor = bag.read(query);
    while (const auto raw = cursor.next()) {
        const auto event = decodeStationEvent(*raw);
        if (!event) continue;
        const auto* scan = std::get_if<KeyScanSample>(&event->sample);
        if (scan == nullptr) continue;
        // The newest of a number counts, as in the fold.
        const auto [at, fresh] = places.try_emplace(scan->id, scans.size());
        if (fresh)
            scans.push_back(*scan);
        else
            scans[at->second] = *scan;
    }
    return scans;
}

std::vector<KeyScanSample> keyScansOf(const std::filesystem::path& folder) {
    std::error_code ignored;
    if (!std::filesystem::exists(folder, ignored)) return {};
    const auto bag = BagReader::open(folder);
    return bag ? keyScansOf(**bag) : std::vector<KeyScanSample>();  // LiveMission says why
}

std::vector<ScanLinksSample> scanLinksOf(const std::filesystem::path& folder) {
    std::vector<ScanLinksSample> links;
    std::error_code ignored;
    if (!std::filesystem::exists(folder, ignored)) return links;
    const auto bag = BagReader::open(folder);
    if (!bag) return links;  // LiveMission says why
    BagQuery query;
    query.topics = {std::string(station_topic::ScanLinks)};
    BagCursor cursor = (*bag)->read(query);
    while (const auto raw = cursor.next()) {
        auto event = decodeStationEvent(*raw);
        if (!event) continue;
        if (auto* sample = std::get_if<ScanLinksSample>(&event->sample)) links.push_back(std::move(*sample));
    }
    return links;
}

std::vector<ScanPose> posesOf(const MissionState& mission) {
    std::vector<ScanPose> poses;
    for (const auto& [id, scan] : *mission.keyScans) poses.push_back(scan.pose);
    return poses;
}

std::optional<MapCrop> cropOf(const MissionState& mission) {
    if (!mission.crop) return std::nullopt;
    return MapCrop{mission.crop->sample.polygon, mission.crop->sample.ceiling};
}

}  // namespace leitstand
