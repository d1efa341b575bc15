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

/// Returns @p scan without points outside @p crop or on @p others, seen from @p scanInMap: finite points
/// only, unorganised. Returns @p scan itself if all of it is kept.
[[nodiscard]] ScanPtr insideCrop(const ScanPtr& scan, const MapCrop& crop, const Pose& scanInMap,
                                 std::span<const PlacedBody> others = {});

/// The points of a map's key scans that are inside the map's area, as the area is now. They are not on other
/// robots, as far as the robots' poses are known now. Spectators may have been scanned before the area was
/// drawn, and a robot before it was placed. Points that are left out are kept, so that a wider area brings
/// them back. Scans of a part whose pose relative to the area is unknown are wholly inside.
class CroppedScans {
public:
    void setCrop(MapCrop crop);
    [[nodiscard]] const MapCrop& crop() const { return m_crop; }
    /// Sets where other robots were while the key scan @p id was taken.
    void setBodies(std::uint64_t id, std::vector<BodyInScan> bodies);
    /// Returns the bodies that were set for the key scan @p id.
    [[nodiscard]] std::vector<BodyInScan> bodies(std::uint64_t id) const;
    /// Sets the points of @p scan to those that are inside, from where it stands now. Also sets its cloud for
    /// matching, if it has one, which is then one of @p clouds. The same key scan at the same place gets the
    /// same pointers again. A scan that is wholly inside is complete, point for point.
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
        bool stale = true;                  ///< what is inside has changed
    };

    MapCrop m_crop;
    std::map<std::uint64_t, Fitted> m_fitted;                   ///< by key scan; those that may lack points
    std::map<std::uint64_t, std::vector<BodyInScan>> m_bodies;  ///< by key scan
};

}  // namespace leitstand
