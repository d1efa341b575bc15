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

/// Name under which a tidying of the map is published. It is no station's name, so that no station undoes the
/// tidying by an undo of its own.
inline constexpr std::string_view TidyingStation = "tidying";
/// Beginning of the names under which decisions about the map of an ended mission are published. These are no
/// station's names either.
inline constexpr std::string_view MapByHandStation = "map-by-hand";
/// Name under which a map from another mission is published. It is no station's name either.
inline constexpr std::string_view CarriedStation = "carried map";

/// Returns the key scans in @p bag, the newest one with each id.
[[nodiscard]] std::vector<KeyScanSample> keyScansOf(BagReader& bag);
/// Returns the key scans in the log of the mission @p folder; empty when there is no mission yet.
[[nodiscard]] std::vector<KeyScanSample> keyScansOf(const std::filesystem::path& folder);

/// Returns all links between the key scans of the mission @p folder, as they were published.
[[nodiscard]] std::vector<ScanLinksSample> scanLinksOf(const std::filesystem::path& folder);

/// Returns the present links of the mission @p folder, by rising id. @p mission: its state.
[[nodiscard]] std::vector<Link> linksOf(const std::filesystem::path& folder, const MissionState& mission);

/// Returns for each key scan of @p mission, by id, the first scan of its part of the map; 0: it is in the
/// map's first part. A part that is not joined with the first part lies aside: its pose relative to that is
/// unknown.
[[nodiscard]] std::map<std::uint64_t, std::uint64_t> partsOf(const MissionState& mission,
                                                             const std::vector<Link>& links);

/// Returns @p bodies, which are the other robots known in key scans, as samples small enough to be sent.
/// Their stamp is @p now, their station is empty.
[[nodiscard]] std::vector<ScanBodiesSample> inSamples(std::map<std::uint64_t, std::vector<BodyInScan>> bodies,
                                                      Time now);

/// Returns the present poses of the key scans of @p mission.
[[nodiscard]] std::vector<ScanPose> posesOf(const MissionState& mission);

/// Returns the present area of the map of @p mission; empty: it was never set.
[[nodiscard]] std::optional<MapCrop> cropOf(const MissionState& mission);

}  // namespace leitstand
