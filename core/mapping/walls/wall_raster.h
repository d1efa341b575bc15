#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include <Eigen/Core>

#include "core/base/progress.h"
#include "core/mapping/walls/flat_pose.h"

namespace leitstand {

/// A place of a raster where the walls of a view match the map.
struct RasterPlace {
    FlatPose pose;
    double score = 0.0;  ///< 0 to 1: mean likelihood of the walls of the view
};

/// The result of a search.
struct RasterPlaces {
    std::vector<RasterPlace> places;  ///< best first
    /// Upper bound of the score of all places that are not in `places`, nor beside one of these. Places below
    /// the least scores of RasterSearch are not considered.
    double others = 0.0;
};

/// Settings of a search for places.
struct RasterSearch {
    int most = 12;                     ///< largest number of places
    double leastScore = 0.35;          ///< least score of a place ...
    double likeBest = 0.75;            ///< ... and least share of the best score
    double apart = 1.0;                ///< least distance between places [m] ...
    double turnedApart = degrees(15);  ///< ... or least turn [rad]
    double angleStep = degrees(1.5);   ///< step between the headings that are tried [rad]
};

/// The upright surfaces of a map, seen from above, as likelihoods on a raster of cells. Each block of cells
/// holds the largest likelihood of its cells.
class WallRaster {
public:
    /// @p walls: points on upright surfaces, map's frame [m]; those beyond @ref Farthest are left out. A map
    /// of more than @ref MostCells is not searched: nothing is found in it.
    explicit WallRaster(std::span<const Eigen::Vector2f> walls);

    /// Returns the poses from which the walls of the map look like @p view: points on walls, in a level frame
    /// of their own [m]. Searches the whole raster and all headings by branch and bound (Olson 2009; Hess,
    /// Kohler, Rapp & Andor 2016). The same arguments give the same result. Cancelled: what was found so far.
    [[nodiscard]] RasterPlaces find(std::span<const Eigen::Vector2f> view, const RasterSearch& search = {},
                                    const Progress& progress = {}) const;

    /// Returns RasterPlace::score of @p view at any @p pose.
    [[nodiscard]] double scoreAt(std::span<const Eigen::Vector2f> view, const FlatPose& pose) const;

    /// Returns other places than @p best, at most @p within [m] from @p about and at the same heading, best
    /// first. Their score is at least @p alike times that of @p best. Somewhere between the two it is clearly
    /// lower; so places along a corridor's axis are left out.
    [[nodiscard]] std::vector<RasterPlace> beside(std::span<const Eigen::Vector2f> view, const FlatPose& best,
                                                  const Eigen::Vector2d& about, double within,
                                                  double alike) const;

    static constexpr double PlacesApart = 0.6;  ///< between places of beside(), and to the best one [m]
    static constexpr double Cell = 0.1;         ///< [m]
    static constexpr double Farthest = 500.0;   ///< from the map's origin, each way [m]
    static constexpr std::size_t MostCells = 16'000'000;  ///< 400 m x 400 m

private:
    static constexpr int Levels = 5;  ///< blocks of the coarsest are 2^(Levels - 1) cells wide

    [[nodiscard]] float at(int level, int x, int y) const;
    [[nodiscard]] Eigen::Vector2i cellOf(const Eigen::Vector2d& point) const;
    void stamp(const Eigen::Vector2d& wall);
    void pool();

    Eigen::Vector2d m_from = Eigen::Vector2d::Zero();
    int m_width = 0, m_height = 0;                    ///< cells
    std::vector<std::vector<std::uint8_t>> m_levels;  ///< 255: likely
};

}  // namespace leitstand
