#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <span>
#include <vector>

#include "core/mapping/live/map/live_map.h"
#include "core/mapping/live/scan_cleaning.h"

namespace leitstand {

/// @p scan without what is outside @p crop or on @p others, seen from @p scanInMap: finite points only,
/// unorganised. @p scan itself where all of it is kept.
[[nodiscard]] ScanPtr insideCrop(const ScanPtr& scan, const MapCrop& crop, const Pose& scanInMap,
                                 std::span<const PlacedBody> others = {});

/// What of a map's key scans is inside the area that belongs into it, as the area is now, and not on other
/// robots, as it is known now where they were: spectators may have been scanned before the area was drawn, a
/// robot before it was placed. What is left out is kept, so that a wider area brings it back. Scans of a part
/// of which nobody knows how it lies to the area are all inside.
class CroppedScans {
public:
    void setCrop(MapCrop crop);
    [[nodiscard]] const MapCrop& crop() const { return m_crop; }
    /// Other robots were where @p bodies say while the key scan @p id was taken.
    void setBodies(std::uint64_t id, std::vector<BodyInScan> bodies);
    /// What was said of the key scan @p id.
    [[nodiscard]] std::vector<BodyInScan> bodies(std::uint64_t id) const;
    /// Puts into @p scan what of it is inside, from where it stands now: its points, and what is matched of
    /// them, where it has that, which is one of @p clouds then. The same key scan at the same place gets the
    /// same pointers again, and one of which all is inside is whole, point for point.
    void fit(LiveKeyScan& scan, const MatchedClouds& clouds = MatchedClouds());

    /// The key scan @p id is no more: the next of its number is another.
    void forget(std::uint64_t id) { m_fitted.erase(id), m_bodies.erase(id); }

private:
    /// A key scan that was looked at.
    struct Fitted {
        std::shared_ptr<KeptScan> scan;
        MatchedCloudPtr wholeReduced, reduced;
        Pose scanInMap = Pose::Identity();  ///< from where what is inside was told
        std::uint64_t part = 0;             ///< LiveKeyScan::part then
        bool stale = true;                  ///< what is inside has changed
    };

    MapCrop m_crop;
    std::map<std::uint64_t, Fitted> m_fitted;  ///< by key scan; those of which something may be missing
    std::map<std::uint64_t, std::vector<BodyInScan>> m_bodies;  ///< by key scan
};

}  // namespace leitstand
