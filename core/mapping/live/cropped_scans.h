#pragma once

#include <cstdint>
#include <map>
#include <memory>

#include "core/mapping/live/live_map.h"
#include "core/mapping/live/scan_cleaning.h"

namespace leitstand {

/// @p scan without what is outside @p crop, seen from @p scanInMap: finite points only, unorganised. @p scan
/// itself where all of it is inside.
[[nodiscard]] ScanPtr insideCrop(const ScanPtr& scan, const MapCrop& crop, const Pose& scanInMap);

/// What of a map's key scans is inside the area that belongs into it, as the area is now: spectators may have
/// been scanned before it was drawn. Keeps whole scans, so that a wider area brings their points back.
class CroppedScans {
public:
    void setCrop(MapCrop crop);
    [[nodiscard]] const MapCrop& crop() const { return m_crop; }
    /// Puts into @p scan what of it is inside, from where it stands now: its points, and what is matched of
    /// them, where it has that, which is one of @p clouds then. The same key scan at the same place gets the
    /// same pointers again.
    void fit(LiveKeyScan& scan, const MatchedClouds& clouds = MatchedClouds());

    /// The key scan @p id is no more: the next of its number is another.
    void forget(std::uint64_t id) { m_fitted.erase(id); }

private:
    /// A key scan that was looked at.
    struct Fitted {
        ScanPtr whole;
        MatchedCloudPtr wholeReduced;
        ScanPtr scan;  ///< inside ...
        MatchedCloudPtr reduced;
        Pose scanInMap = Pose::Identity();  ///< ... from here
    };

    MapCrop m_crop;
    std::map<std::uint64_t, Fitted> m_fitted;  ///< by key scan; empty while nothing is cropped
};

}  // namespace leitstand
