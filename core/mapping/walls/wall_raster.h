#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include <Eigen/Core>

#include "core/base/progress.h"
#include "core/mapping/walls/flat_pose.h"

namespace leitstand {

/// A place of a raster where walls lie as they were seen.
struct RasterPlace {
    FlatPose pose;
    double score = 0.0;  ///< 0 to 1: mean likelihood of the walls that were seen
};

/// What a search came to.
struct RasterPlaces {
    std::vector<RasterPlace> places;  ///< best first
    /// No place that is not among them, nor beside one of them, has a better score.
    double others = 0.0;
};

/// How places are looked for.
struct RasterSearch {
    int most = 12;                     ///< places
    double leastScore = 0.35;          ///< of a place ...
    double likeBest = 0.75;            ///< ... and share of the best place's
    double apart = 1.0;                ///< places are so far from each other [m] ...
    double turnedApart = degrees(15);  ///< ... or turned so much [rad]
    double angleStep = degrees(1.5);   ///< between headings that are tried [rad]
};

/// What stands up in a map, seen from above, as likelihoods on a raster of cells, and for blocks of cells the
/// most of any of theirs.
class WallRaster {
public:
    /// @p walls: points of what stands up, map's frame [m]; those beyond @ref Farthest are left out. A map of
    /// more than @ref MostCells is not looked through: nothing is found in it.
    explicit WallRaster(std::span<const Eigen::Vector2f> walls);

    /// The places from which walls would be seen at @p view (their own frame, level): all of the raster and
    /// all headings, by branch and bound (Olson 2009; Hess, Kohler, Rapp & Andor 2016). The same for the same
    /// arguments. Cancelled: what was found so far.
    [[nodiscard]] RasterPlaces find(std::span<const Eigen::Vector2f> view, const RasterSearch& search = {},
                                    const Progress& progress = {}) const;

    /// RasterPlace::score at any @p pose.
    [[nodiscard]] double scoreAt(std::span<const Eigen::Vector2f> view, const FlatPose& pose) const;

    /// Other places at most @p within [m] from @p about whose score, at the heading of @p best, is @p alike
    /// times that of @p best or more, with clearly less between the two: not those that a corridor's axis
    /// leads to. The best first.
    [[nodiscard]] std::vector<RasterPlace> beside(std::span<const Eigen::Vector2f> view, const FlatPose& best,
                                                  const Eigen::Vector2d& about, double within,
                                                  double alike) const;

    static constexpr double PlacesApart = 0.6;            ///< those of beside(), and from the best one [m]
    static constexpr double Cell = 0.1;                   ///< [m]
    static constexpr double Farthest = 500.0;             ///< from the map's origin, each way [m]
    static constexpr std::size_t MostCells = 16'000'000;  ///< 400 m x 400 m

private:
    static constexpr int Levels = 5;  ///< blocks of the coarsest have 2^(Levels - 1) cells along

    [[nodiscard]] float at(int level, int x, int y) const;
    [[nodiscard]] Eigen::Vector2i cellOf(const Eigen::Vector2d& point) const;
    void stamp(const Eigen::Vector2d& wall);
    void pool();

    Eigen::Vector2d m_from = Eigen::Vector2d::Zero();
    int m_width = 0, m_height = 0;                    ///< cells
    std::vector<std::vector<std::uint8_t>> m_levels;  ///< 255: likely
};

}  // namespace leitstand
