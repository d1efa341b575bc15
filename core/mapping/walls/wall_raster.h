#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include <Eigen/Core>

#include "core/base/progress.h"
#include "core/mapping/walls/flat_pose.h"

namespace leitstand {

/// A place in a raster where the walls of a view fit the map.
struct RasterPlace {
    FlatPose pose;
    double score = 0.0;  ///< mean likelihood of the view's walls, 0 to 1
};

/// The result of a search.
struct RasterPlaces {
    std::vector<RasterPlace> places;  ///< best first
    /// Upper bound of the score of all places that are neither in `places` nor beside one of them. Places
    /// below the least scores of RasterSearch are ignored.
    double others = 0.0;
};

/// Settings of a search for places.
struct RasterSearch {
    int most = 12;                     ///< largest number of places
    double leastScore = 0.35;          ///< least score of a place ...
    double likeBest = 0.75;            ///< ... and least share of the best score
    double apart = 1.0;                ///< least distance between places [m] ...
    double turnedApart = degrees(15);  ///< ... or least turn [rad]
    double angleStep = degrees(1.5);   ///< step between headings [rad]
};

/// The vertical surfaces of a map, seen from above, as likelihoods in a raster of cells. Coarser levels have
/// blocks of cells, each with the largest likelihood of its cells.
class WallRaster {
public:
    /// @p walls: points on vertical surfaces, in the map [m]; those beyond @ref Farthest are left out. A map
    /// with more than @ref MostCells cells is not searched: nothing is found in it.
    explicit WallRaster(std::span<const Eigen::Vector2f> walls);

    /// Returns the poses from which the walls of the map look like @p view. @p view: points on walls, in
    /// their own level frame [m]. Searches the whole raster and all headings by branch and bound (Olson 2009;
    /// Hess, Kohler, Rapp & Andor 2016). The same arguments give the same result. Cancelled: what was found
    /// so far.
    [[nodiscard]] RasterPlaces find(std::span<const Eigen::Vector2f> view, const RasterSearch& search = {},
                                    const Progress& progress = {}) const;

    /// Returns RasterPlace::score of @p view at @p pose, which may be anywhere.
    [[nodiscard]] double scoreAt(std::span<const Eigen::Vector2f> view, const FlatPose& pose) const;

    /// Returns other places than @p best with the same heading, at most @p within [m] from @p about, best
    /// first. Their score is at least @p alike times that of @p best. Between each place and @p best the
    /// score must be clearly lower at some point. So places along the axis of a corridor are left out.
    [[nodiscard]] std::vector<RasterPlace> beside(std::span<const Eigen::Vector2f> view, const FlatPose& best,
                                                  const Eigen::Vector2d& about, double within,
                                                  double alike) const;

    /// Distance of the places of beside() from each other and from the best place [m].
    static constexpr double PlacesApart = 0.6;
    static constexpr double Cell = 0.1;  ///< edge of a cell [m]
    /// Largest distance from the map's origin, in each direction [m].
    static constexpr double Farthest = 500.0;
    static constexpr std::size_t MostCells = 16'000'000;  ///< 400 m x 400 m

private:
    /// Number of levels; blocks of the coarsest level are 2^(Levels - 1) cells wide.
    static constexpr int Levels = 5;

    [[nodiscard]] float at(int level, int x, int y) const;
    [[nodiscard]] Eigen::Vector2i cellOf(const Eigen::Vector2d& point) const;
    void stamp(const Eigen::Vector2d& wall);
    void pool();

    Eigen::Vector2d m_from = Eigen::Vector2d::Zero();
    int m_width = 0, m_height = 0;                    ///< size in cells
    std::vector<std::vector<std::uint8_t>> m_levels;  ///< likelihoods of each level; 255: most likely
};

}  // namespace leitstand
