#pragma once

#include <memory>
#include <optional>
#include <vector>

#include <Eigen/Core>

#include "core/base/pose.h"
#include "core/base/progress.h"
#include "core/mapping/live/live_settings.h"
#include "core/mapping/live/map/live_map.h"
#include "core/mapping/live/scan_work.h"
#include "core/mapping/walls/wall_raster.h"
#include "core/mapping/walls/walls_from_above.h"

namespace leitstand {

/// Settings of the search for a robot in a whole map.
struct RelocalisationSettings {
    RasterSearch search;
    WallBand walls;              ///< band of heights of the walls that are compared from above
    double farReach = 15.0;      ///< WallBand::reach where walls are few [m]
    double leastOverlap = 0.65;  ///< least IcpResult::overlap of a place
    double mostResidual = 0.06;  ///< largest IcpResult::rms of a place [m]
    double mostFilled = 0.08;    ///< largest share of points where the place's nearest scans looked through
    double sureFit = 0.0;        ///< least AlikePlace::fit() of a sure place
    double sureFilled = 0.08;    ///< largest AlikePlace::filled of a sure place
    double leastJudged = 0.25;   ///< least share of points that a scan can judge, to count for `filled`
    double alike = 0.85;  ///< another place with this share of the best AlikePlace::fit() is as likely ...
    double alikeFilled = 2.0;  ///< ... less so many times AlikePlace::filled of the best: it is less sure
    double betterFromAbove = 0.02;  ///< largest lead of another place over a sure one in AlikePlace::score
    /// Largest score from above of places that were not tried, or are beside a sure place, as a share of the
    /// score of that place.
    double alikeFromAbove = 0.93;
    std::vector<double> schedule = {0.8, 0.4, 0.2, 0.1, 0.07};  ///< largest pair distances, by stage [m]
};

/// Returns settings for a robot that the operator reports to be somewhere in the map: its next scan will
/// confirm the place or not. Code that decides by itself whether a place was seen before uses the default
/// settings.
[[nodiscard]] RelocalisationSettings forLostRobots();

/// A place of the map that looks like a scan.
struct AlikePlace {
    Pose scanInMap = Pose::Identity();
    double score = 0.0;    ///< WallRaster::scoreAt() there
    double beside = 0.0;   ///< best score 0.6 m from there; high in a bare corridor: nothing holds a scan
    double overlap = 0.0;  ///< 0 to 1
    double rms = 0.0;      ///< [m]
    double filled = 0.0;   ///< share of points where one of the nearest scans looked through, 0 to 1
    /// Returns how well it fits, seen from above and registered; at most 1. Points in free space count more
    /// against it than missing overlap.
    [[nodiscard]] double fit() const { return score * (overlap - 3.0 * filled); }
};

/// The result of looking for a scan.
struct Relocalisation {
    std::vector<AlikePlace> places;  ///< places that fit, best first
    bool sure = false;               ///< the scan was taken at the first place: no other one is as likely
    std::size_t tried = 0;           ///< number of places that looked alike from above
};

/// Finds where a scan was taken, anywhere in a map and at any heading: for a robot that was carried,
/// restarted or lost. It compares walls from above (WallRaster). Then it checks each similar place by
/// registration and by what the map's scans looked through. The heights of scans separate storeys.
class Relocaliser {
public:
    /// Prepares @p map. Cancelled: find() searches only a part of it.
    Relocaliser(LiveMapPtr map, LiveSettings settings, RelocalisationSettings how = {},
                const Progress& progress = {});

    /// Looks for @p scan in the map. @p reduced: its points for matching; both are in the scan's own frame.
    /// @p up: against gravity, in that frame. Cancelled: finds nothing.
    [[nodiscard]] Relocalisation find(const Scan& scan, const PointCloud& reduced, const Eigen::Vector3d& up,
                                      const Progress& progress = {}) const;

private:
    /// Key scans of about one height, and the walls around them.
    struct Storey {
        double height = 0.0;  ///< of the scanner, map's frame [m]
        WallRaster walls;
    };
    /// Returns the share of @p scan's points at @p scanInMap that lie where a key scan nearby looked through.
    /// Of the key scans that can judge enough points, the one with the largest share counts; empty: none can.
    [[nodiscard]] std::optional<double> filledAt(const Scan& scan, const Pose& scanInMap) const;
    /// The scan that is looked for.
    struct Sought {
        const Scan& scan;
        const PointCloud& reduced;
        Eigen::Vector3d up;
        Pose level;                         ///< levels the scan
        std::vector<Eigen::Vector2f> view;  ///< its walls, levelled
    };
    [[nodiscard]] std::optional<AlikePlace> verified(const Sought& sought, const RasterPlace& place,
                                                     const Storey& storey) const;

    LiveMapPtr m_map;
    LiveSettings m_settings;
    RelocalisationSettings m_how;
    std::vector<Storey> m_storeys;
};

}  // namespace leitstand
