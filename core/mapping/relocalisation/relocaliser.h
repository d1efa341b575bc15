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

/// How a robot is looked for in a whole map.
struct RelocalisationSettings {
    RasterSearch search;
    WallBand walls;              ///< that are compared from above
    double farReach = 15.0;      ///< of them where there are few [m]
    double leastOverlap = 0.65;  ///< IcpResult::overlap of a place
    double mostResidual = 0.06;  ///< IcpResult::rms [m]
    double mostFilled = 0.08;    ///< share of points where the place's nearest scans looked through
    double sureFit = 0.0;        ///< AlikePlace::fit() of one that is sure
    double sureFilled = 0.08;    ///< ... of one that is sure
    double leastJudged = 0.25;   ///< share of points of which one of them can say that
    double alike = 0.85;         ///< another place that fits and has this share of the best fit is as likely
    double alikeFilled =
        2.0;  ///< ... less so many times AlikePlace::filled of the best: it is less sure then
    double betterFromAbove = 0.02;  ///< nor may another place that fits have a better score by that
    /// Likewise one that was not tried, or that lies beside the best place, of its score.
    double alikeFromAbove = 0.93;
    std::vector<double> schedule = {0.8, 0.4, 0.2, 0.1, 0.07};  ///< of pair distances [m]
};

/// For a robot that the operator says is somewhere in the map: its next scan tells whether it stands where it
/// was found. What decides by itself whether a place was seen before takes the usual settings.
[[nodiscard]] RelocalisationSettings forLostRobots();

/// A place of the map that looks as a scan does.
struct AlikePlace {
    Pose scanInMap = Pose::Identity();
    double score = 0.0;    ///< WallRaster::scoreAt() there
    double beside = 0.0;   ///< the best score 0.6 m from there: along a bare corridor nothing holds a scan
    double overlap = 0.0;  ///< 0 to 1
    double rms = 0.0;      ///< [m]
    double filled = 0.0;   ///< share of points where one of the nearest scans looked through, 0 to 1
    /// How well it fits, at most 1, seen from above and registered: what stands in free space speaks against
    /// it more than what is missing.
    [[nodiscard]] double fit() const { return score * (overlap - 3.0 * filled); }
};

/// What came of looking for a scan.
struct Relocalisation {
    std::vector<AlikePlace> places;  ///< that fit, best first
    bool sure = false;               ///< the first is the place: no other one is as likely
    std::size_t tried = 0;           ///< places that looked alike from above
};

/// Finds where a scan was taken, anywhere in a map and whatever its heading: for a robot that was carried,
/// restarted or lost. From above by walls (WallRaster), then each place that looks alike by registration and
/// by what the map's scans looked through. Storeys are told apart by the heights of their scans.
class Relocaliser {
public:
    /// Cancelled: it finds nothing.
    Relocaliser(LiveMapPtr map, LiveSettings settings, RelocalisationSettings how = {},
                const Progress& progress = {});

    /// @p scan and what is to be matched of it, @p reduced, both in its own frame; @p up: against gravity
    /// there. Cancelled: nothing is found.
    [[nodiscard]] Relocalisation find(const Scan& scan, const PointCloud& reduced, const Eigen::Vector3d& up,
                                      const Progress& progress = {}) const;

private:
    /// Key scans of about one height, and what stands up about them.
    struct Storey {
        double height = 0.0;  ///< of the scanner, map's frame [m]
        WallRaster walls;
    };
    /// The share of @p scan's points at @p scanInMap that lie where key scans about there looked through, the
    /// largest of those that can judge enough of them; empty: none can.
    [[nodiscard]] std::optional<double> filledAt(const Scan& scan, const Pose& scanInMap) const;
    /// What is looked for.
    struct Sought {
        const Scan& scan;
        const PointCloud& reduced;
        Eigen::Vector3d up;
        Pose level;                         ///< turns the scan so that up is up
        std::vector<Eigen::Vector2f> view;  ///< its walls, turned so
    };
    [[nodiscard]] std::optional<AlikePlace> verified(const Sought& sought, const RasterPlace& place,
                                                     const Storey& storey) const;

    LiveMapPtr m_map;
    LiveSettings m_settings;
    RelocalisationSettings m_how;
    std::vector<Storey> m_storeys;
};

}  // namespace leitstand
