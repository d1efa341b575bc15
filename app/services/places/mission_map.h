#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <string_view>
#include <vector>

#include "core/event/scan_bodies.h"
#include "core/event/scan_links.h"
#include "core/event/scan_pose.h"
#include "core/mapping/live/scan_cleaning.h"

namespace leitstand {

struct MissionState;
struct KeyScanSample;
class BagReader;

/// Name of the publisher of a tidying of the map. It is no station's, so that only those who asked for the
/// tidying take it back.
inline constexpr std::string_view TidyingStation = "tidying";
/// Beginning of the names of those who decide on the map of a mission that has ended; no stations either.
inline constexpr std::string_view MapByHandStation = "map-by-hand";
/// Name of the publisher of a map that was carried here from another mission; no station either.
inline constexpr std::string_view CarriedStation = "carried map";

/// Returns the key scans in @p bag, the newest of each number.
[[nodiscard]] std::vector<KeyScanSample> keyScansOf(BagReader& bag);
/// Returns the key scans in the log of the mission @p folder; empty when there is no mission yet.
[[nodiscard]] std::vector<KeyScanSample> keyScansOf(const std::filesystem::path& folder);

/// Returns what the key scans of the mission @p folder were registered against, as published.
[[nodiscard]] std::vector<ScanLinksSample> scanLinksOf(const std::filesystem::path& folder);

/// Returns the links of the mission @p folder, whose state is @p mission, as they are now, by ascending id.
[[nodiscard]] std::vector<Link> linksOf(const std::filesystem::path& folder, const MissionState& mission);

/// Returns for each key scan of @p mission, by id, the first scan of its part of the map; 0: it is in the
/// map's first part. Parts that have not met that one lie aside: nobody knows how they lie relative to it.
[[nodiscard]] std::map<std::uint64_t, std::uint64_t> partsOf(const MissionState& mission,
                                                             const std::vector<Link>& links);

/// Returns what is known of other robots in key scans, in samples small enough to be sent at once; without a
/// station.
[[nodiscard]] std::vector<ScanBodiesSample> inSamples(std::map<std::uint64_t, std::vector<BodyInScan>> bodies,
                                                      Time now);

/// Returns where the key scans of @p mission are now.
[[nodiscard]] std::vector<ScanPose> posesOf(const MissionState& mission);

/// Returns what belongs into the map of @p mission now; empty: it was never set.
[[nodiscard]] std::optional<MapCrop> cropOf(const MissionState& mission);

}  // namespace leitstand
