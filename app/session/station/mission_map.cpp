#include "app/session/station/mission_map.h"

#include <string>
#include <system_error>
#include <variant>

#include "core/io/bag/bag_reader.h"
#include "core/mission/station_topics.h"
#include "transport/convert/decode.h"

namespace leitstand {

std::vector<KeyScanSample> keyScansOf(BagReader& bag) {
    std::vector<KeyScanSample> scans;
    BagQuery query;
    query.topics = {std::string(station_topic::KeyScans)};
    BagCursor cursor = bag.read(query);
    while (const auto raw = cursor.next()) {
        const auto event = decodeStationEvent(*raw);
        if (!event) continue;
        if (const auto* scan = std::get_if<KeyScanSample>(&event->sample)) scans.push_back(*scan);
    }
    return scans;
}

std::vector<KeyScanSample> keyScansOf(const std::filesystem::path& folder) {
    std::error_code ignored;
    if (!std::filesystem::exists(folder, ignored)) return {};
    const auto bag = BagReader::open(folder);
    return bag ? keyScansOf(**bag) : std::vector<KeyScanSample>();  // LiveMission says why
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
