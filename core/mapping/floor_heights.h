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
    double layer = 0.10;  ///< points up to so far above a surface's lowest point belong to it [m] ...
    double apart = 0.25;  ///< ... points farther above that one begin another surface: a deck, a table [m]
    double step = 0.12;   ///< largest step of the floor from cell to cell; a higher one is furniture [m]
    double underRobot = 0.2;  ///< under a robot, floor is nearer than this to the height of base_link [m] ...
    double blind = 1.0;  ///< ... and up to so far around it, floor is less than `step` from that height [m]
    StoreyHeights heights = {};  ///< of the storey; floor and robots outside are left out
};

/// The height of the floor at each place of a map. Maps have ramps and storeys, so heights of things are
/// measured from the floor below them. Floor is what is labelled so and can be reached from under the robots
/// without a step; tables are not. Where floors lie above each other, the one nearest to the height at which
/// robots drove closest by counts. If robots drove on both, it is the lower one. Where no floor was seen, the
/// nearest one counts. If scans show no floor at all, as those of a plane laser, it is where robots drove.
class FloorHeights {
public:
    /// @p ground: positions of the robots' base_link in the map [m].
    [[nodiscard]] static FloorHeights of(std::span<const ReportScan> scans,
                                         std::span<const Eigen::Vector3d> ground,
                                         const FloorSettings& settings = {});

    /// Returns the height of the floor in the map [m]; 0 when no floor is known at all.
    [[nodiscard]] double at(double x, double y) const;
    /// Returns the height of the floor on which something at @p place stands [m]. It is the highest floor
    /// there that is at most 0.15 m above @p place, or else that of the nearest cell around. If there is none
    /// within five cells: at().
    [[nodiscard]] double below(const Eigen::Vector3d& place) const;
    /// Returns whether floor was seen in the cell at @p x, @p y [m].
    [[nodiscard]] bool seen(double x, double y) const;

private:
    [[nodiscard]] std::ptrdiff_t cellOf(double x, double y) const;  ///< -1: outside
    void gather(std::span<const ReportScan> scans, const FloorSettings& settings);
    /// Marks what can be reached. Returns how far above the floor the robots' base_link is [m].
    [[nodiscard]] double grow(std::span<const Eigen::Vector3d> ground, const FloorSettings& settings);
    void choose(std::span<const Eigen::Vector3d> ground, double lift);
    void follow(std::span<const Eigen::Vector3d> ground);
    void fill(std::vector<float>& heights) const;

    double m_cell = 0.1;
    Eigen::Vector2d m_origin = Eigen::Vector2d::Zero();
    int m_columns = 0, m_rows = 0;        ///< along x and y
    std::vector<std::uint32_t> m_first;   ///< by cell: where its surfaces begin; one more for the end
    std::vector<float> m_surfaces;        ///< heights labelled as floor, by cell, from the lowest on [m]
    std::vector<std::uint8_t> m_reached;  ///< by surface: whether grow() reached it
    std::vector<float> m_height;          ///< by cell, of the floor [m]
    std::vector<std::uint8_t> m_seen;
};

}  // namespace leitstand
