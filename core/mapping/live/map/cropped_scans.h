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

/// Returns @p scan, which is at @p scanInMap, without points outside @p crop or on @p others: finite points
/// only, unorganised. Returns @p scan itself if all of it is kept.
[[nodiscard]] ScanPtr insideCrop(const ScanPtr& scan, const MapCrop& crop, const Pose& scanInMap,
                                 std::span<const PlacedBody> others = {});

/// Chooses which points of its key scans a map has: those inside the present area, and not on other robots as
/// far as their poses are known now. Spectators may have been scanned before the area was drawn, and a robot
/// before it was placed. Points that are left out are kept, so that a wider area brings them back. The area
/// leaves nothing out of a part of the map whose pose relative to it is unknown.
class CroppedScans {
public:
    void setCrop(MapCrop crop);
    [[nodiscard]] const MapCrop& crop() const { return m_crop; }
    /// Sets where other robots were while the key scan @p id was taken.
    void setBodies(std::uint64_t id, std::vector<BodyInScan> bodies);
    /// Returns the bodies that were set for the key scan @p id.
    [[nodiscard]] std::vector<BodyInScan> bodies(std::uint64_t id) const;
    /// Sets the points of @p scan to those that belong in the map, by its present pose. Sets its cloud for
    /// matching, if it has one, to the same part; @p clouds keeps that cloud. The same key scan at the same
    /// place gets the same pointers again. If all of a scan belongs in the map, it stays whole, point for
    /// point.
    void fit(LiveKeyScan& scan, const MatchedClouds& clouds = MatchedClouds());

    /// Forgets the key scan @p id: the next scan with its number is another one.
    void forget(std::uint64_t id) { m_fitted.erase(id), m_bodies.erase(id); }

private:
    /// A key scan that was checked.
    struct Fitted {
        std::shared_ptr<KeptScan> scan;
        MatchedCloudPtr wholeReduced, reduced;
        Pose scanInMap = Pose::Identity();  ///< pose for which the points inside were found
        std::uint64_t part = 0;             ///< LiveKeyScan::part at that time
        bool stale = true;                  ///< the area or the bodies changed since then
    };

    MapCrop m_crop;
    std::map<std::uint64_t, Fitted> m_fitted;                   ///< by key scan; those that may lack points
    std::map<std::uint64_t, std::vector<BodyInScan>> m_bodies;  ///< by key scan
};

}  // namespace leitstand
