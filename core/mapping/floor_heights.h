#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include <Eigen/Core>

#include "core/mapping/report_scan.h"
#include "core/mapping/storeys.h"

namespace leitstand {

/// Settings of FloorHeights.
struct FloorSettings {
    double cell = 0.10;   ///< edge of a cell, seen from above [m]
    double layer = 0.10;  ///< points at most this far above a surface's lowest point belong to it [m] ...
    /// ... points farther above it than this begin another surface: a deck, a table [m].
    double apart = 0.25;
    /// Largest step of the floor between neighbouring cells; a higher step is furniture [m].
    double step = 0.12;
    /// Under a robot, the floor is within this distance of the height of base_link [m] ...
    double underRobot = 0.2;
    double blind = 1.0;  ///< ... and within this radius around it, less than `step` from that height [m]
    StoreyHeights heights = {};  ///< heights of the storey; floor and robots outside are left out
};

/// The height of the floor at each place of a map. Maps have ramps and storeys, so heights of things are
/// measured from the floor below them. Floor is what has the label floor and can be reached without a step
/// from below the robots; so tables are no floor.
///
/// Where floors lie above each other, the one is taken that is nearest to the height of the closest robot
/// path. If robots drove on both, the lower one is taken. Where no floor was seen, the nearest known floor is
/// taken. If scans show no floor at all, as those of a plane laser, the floor is where robots drove.
class FloorHeights {
public:
    /// @p ground: positions of the robots' base_link in the map [m].
    [[nodiscard]] static FloorHeights of(std::span<const ReportScan> scans,
                                         std::span<const Eigen::Vector3d> ground,
                                         const FloorSettings& settings = {});

    /// Returns the height of the floor in the map [m]; 0 when no floor is known anywhere.
    [[nodiscard]] double at(double x, double y) const;
    /// Returns the height of the floor on which something at @p place stands [m]. It is the highest floor
    /// there that is at most 0.15 m above @p place. If there is none, it is the floor of the nearest cell
    /// around. If there is none within five cells, it is at().
    [[nodiscard]] double below(const Eigen::Vector3d& place) const;
    /// Returns whether floor was seen in the cell of (@p x, @p y) [m].
    [[nodiscard]] bool seen(double x, double y) const;

private:
    [[nodiscard]] std::ptrdiff_t cellOf(double x, double y) const;  ///< index of the cell; -1: outside
    void gather(std::span<const ReportScan> scans, const FloorSettings& settings);
    /// Marks the surfaces that can be reached. Returns how far above the floor the robots' base_link is [m].
    [[nodiscard]] double grow(std::span<const Eigen::Vector3d> ground, const FloorSettings& settings);
    void choose(std::span<const Eigen::Vector3d> ground, double lift);
    void follow(std::span<const Eigen::Vector3d> ground);
    void fill(std::vector<float>& heights) const;

    double m_cell = 0.1;
    Eigen::Vector2d m_origin = Eigen::Vector2d::Zero();
    int m_columns = 0, m_rows = 0;  ///< number of cells along x and y
    /// Where the surfaces of each cell begin in m_surfaces; one more entry for the end.
    std::vector<std::uint32_t> m_first;
    std::vector<float> m_surfaces;        ///< heights labelled as floor, cell by cell, from the lowest on [m]
    std::vector<std::uint8_t> m_reached;  ///< whether grow() reached the surface; one entry per surface
    std::vector<float> m_height;          ///< height of the floor in each cell [m]
    std::vector<std::uint8_t> m_seen;
};

}  // namespace leitstand
