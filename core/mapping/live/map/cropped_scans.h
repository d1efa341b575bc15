#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <span>
#include <vector>

#include "core/event/scan_bodies.h"
#include "core/mapping/live/map/live_map.h"
#include "core/mapping/live/scan_cleaning.h"

namespace leitstand {

/// Returns the points of @p scan, which is at @p scanInMap, that are inside @p crop and not on @p others. The
/// result has only finite points and is unorganised. Returns @p scan itself if no point is removed.
[[nodiscard]] ScanPtr insideCrop(const ScanPtr& scan, const MapCrop& crop, const Pose& scanInMap,
                                 std::span<const PlacedBody> others = {});

/// Chooses which points of its key scans a map shows: those inside its area and not on other robots. The area
/// may be drawn after spectators were scanned, and a robot may be placed after it was scanned. Removed points
/// are kept, so that they come back when the area becomes wider. The area is not applied to a part of the map
/// whose pose relative to it is unknown.
class CroppedScans {
public:
    void setCrop(MapCrop crop);
    [[nodiscard]] const MapCrop& crop() const { return m_crop; }
    /// Sets where other robots were while the key scan @p id was taken.
    void setBodies(std::uint64_t id, std::vector<BodyInScan> bodies);
    /// Returns the bodies that were set for the key scan @p id.
    [[nodiscard]] std::vector<BodyInScan> bodies(std::uint64_t id) const;
    /// Sets the points of @p scan to those that belong in the map, by its present pose. Does the same with
    /// its cloud for matching, if it has one; @p clouds keeps that cloud. If neither the scan's pose nor the
    /// area has changed, the scan gets the same pointers as before. If all points belong in the map, the scan
    /// is not changed.
    void fit(LiveKeyScan& scan, const MatchedClouds& clouds = MatchedClouds());

    /// Forgets the key scan @p id. A later scan may have the same id.
    void forget(std::uint64_t id) { m_fitted.erase(id), m_bodies.erase(id); }

private:
    /// A key scan that was checked.
    struct Fitted {
        std::shared_ptr<KeptScan> scan;
        MatchedCloudPtr wholeReduced, reduced;
        Pose scanInMap = Pose::Identity();  ///< pose at which the points inside were found
        std::uint64_t part = 0;             ///< LiveKeyScan::part at that time
        bool stale = true;                  ///< whether the area or the bodies changed since then
    };

    MapCrop m_crop;
    std::map<std::uint64_t, Fitted> m_fitted;                   ///< key scans that may lack points, by id
    std::map<std::uint64_t, std::vector<BodyInScan>> m_bodies;  ///< other robots in a key scan, by its id
};

}  // namespace leitstand
