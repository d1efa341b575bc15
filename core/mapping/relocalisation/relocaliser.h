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

/// Settings for searching a whole map for a robot.
struct RelocalisationSettings {
    RasterSearch search;
    WallBand walls;              ///< heights of the walls that are compared from above
    double farReach = 15.0;      ///< WallBand::reach where there are few walls [m]
    double leastOverlap = 0.65;  ///< least IcpResult::overlap of a place
    double mostResidual = 0.06;  ///< largest IcpResult::rms of a place [m]
    double mostFilled = 0.08;    ///< largest share of points in the free space of the place's nearest scans
    double sureFit = 0.0;        ///< least AlikePlace::fit() of a sure place
    double sureFilled = 0.08;    ///< largest AlikePlace::filled of a sure place
    /// A scan is used for `filled` if it can judge at least this share of the points.
    double leastJudged = 0.25;
    /// Another place with at least this share of the best AlikePlace::fit() is as likely ...
    double alike = 0.85;
    /// ... this share is lowered by this multiple of the best place's AlikePlace::filled.
    double alikeFilled = 2.0;
    /// Another place may lead a sure place by at most this in AlikePlace::score.
    double betterFromAbove = 0.02;
    /// Largest score from above of other places than a sure place, as a share of its score. These are places
    /// that were not tried, and places beside the sure place.
    double alikeFromAbove = 0.93;
    /// Largest distance of a pair, stage by stage [m].
    std::vector<double> schedule = {0.8, 0.4, 0.2, 0.1, 0.07};
};

/// Returns settings for a robot that is somewhere in the map, as the operator says: its next scan will show
/// whether the place is right. Code that decides without the operator uses the default settings.
[[nodiscard]] RelocalisationSettings forLostRobots();

/// A place of the map that looks like a scan.
struct AlikePlace {
    Pose scanInMap = Pose::Identity();
    double score = 0.0;  ///< WallRaster::scoreAt() there
    /// Best score 0.6 m from there; high in a bare corridor, which does not hold a scan.
    double beside = 0.0;
    double overlap = 0.0;  ///< IcpResult::overlap, 0 to 1
    double rms = 0.0;      ///< IcpResult::rms [m]
    double filled = 0.0;   ///< share of points in the free space of one of the nearest scans, 0 to 1
    /// Returns how well the scan fits, both seen from above and registered; at most 1. Points in free space
    /// reduce it more than missing overlap.
    [[nodiscard]] double fit() const { return score * (overlap - 3.0 * filled); }
};

/// The result of looking for a scan.
struct Relocalisation {
    std::vector<AlikePlace> places;  ///< places that fit, best first
    bool sure = false;      ///< the scan was certainly taken at the first place: no other place is as likely
    std::size_t tried = 0;  ///< number of places that looked similar from above
};

/// Finds where a scan was taken, anywhere in a map and at any heading: for a robot that was carried,
/// restarted or lost. First it compares walls from above (WallRaster). Then it checks each similar place by
/// registration and by the free space of the map's scans. Scans at different heights belong to different
/// storeys.
class Relocaliser {
public:
    /// Prepares @p map. Cancelled: find() searches only a part of it.
    Relocaliser(LiveMapPtr map, LiveSettings settings, RelocalisationSettings how = {},
                const Progress& progress = {});

    /// Looks for @p scan in the map. @p reduced: its points for matching. @p up: upward direction. All are in
    /// the scan's own frame. Cancelled: finds nothing.
    [[nodiscard]] Relocalisation find(const Scan& scan, const PointCloud& reduced, const Eigen::Vector3d& up,
                                      const Progress& progress = {}) const;

private:
    /// Key scans at about the same height, and the walls around them.
    struct Storey {
        double height = 0.0;  ///< height of the scanner in the map [m]
        WallRaster walls;
    };
    /// Returns the share of points of @p scan (at @p scanInMap) that lie in the free space of a nearby key
    /// scan. Of the key scans that can judge enough points, the one with the largest share is used. Empty:
    /// none can.
    [[nodiscard]] std::optional<double> filledAt(const Scan& scan, const Pose& scanInMap) const;
    /// The scan that is looked for.
    struct Sought {
        const Scan& scan;
        const PointCloud& reduced;
        Eigen::Vector3d up;
        Pose level;                         ///< upward direction; rotation that levels the scan
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
