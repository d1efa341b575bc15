#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <string_view>
#include <vector>

#include "core/event/map_samples.h"
#include "core/event/scan_links.h"
#include "core/mapping/live/scan_cleaning.h"
#include "core/mission/state/mission_state.h"

namespace leitstand {

class BagReader;

/// Who says what a tidying of the map says: no station, so that nobody takes it back who did not ask for it.
inline constexpr std::string_view TidyingStation = "tidying";
/// What names of those who decide on the map of a mission that has ended begin with: no stations either.
inline constexpr std::string_view MapByHandStation = "map-by-hand";
/// Likewise, what a map says that was carried here from another mission.
inline constexpr std::string_view CarriedStation = "carried map";

/// Key scans that @p bag holds, the newest of each number.
[[nodiscard]] std::vector<KeyScanSample> keyScansOf(BagReader& bag);
/// Key scans in the log of the mission @p folder; none where there is no mission yet.
[[nodiscard]] std::vector<KeyScanSample> keyScansOf(const std::filesystem::path& folder);

/// What the key scans of the mission @p folder were registered against, as it was said.
[[nodiscard]] std::vector<ScanLinksSample> scanLinksOf(const std::filesystem::path& folder);

/// The links of the mission @p folder, whose state is @p mission, as they are now, by rising id.
[[nodiscard]] std::vector<Link> linksOf(const std::filesystem::path& folder, const MissionState& mission);

/// With which scan the part of the map begins that each key scan of @p mission is of, by their ids; 0: it is
/// of the map's first part. What has not met that lies aside: nobody knows how it lies to it.
[[nodiscard]] std::map<std::uint64_t, std::uint64_t> partsOf(const MissionState& mission,
                                                             const std::vector<Link>& links);

/// What is known of other robots in key scans, in samples of a size that is sent at once; without a station.
[[nodiscard]] std::vector<ScanBodiesSample> inSamples(std::map<std::uint64_t, std::vector<BodyInScan>> bodies,
                                                      Time now);

/// Where the key scans of @p mission are now.
[[nodiscard]] std::vector<ScanPose> posesOf(const MissionState& mission);

/// What belongs into the map of @p mission now; empty: nobody said.
[[nodiscard]] std::optional<MapCrop> cropOf(const MissionState& mission);

}  // namespace leitstand
