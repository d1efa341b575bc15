#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include <Eigen/Core>

#include "core/mapping/report_scan.h"
#include "core/mapping/storeys.h"

namespace leitstand {

/// How the local floor is told.
struct FloorSettings {
    double cell = 0.10;          ///< [m]
    double layer = 0.10;         ///< points so far above a surface's lowest belong to it [m] ...
    double apart = 0.25;         ///< ... those that are farther above it to another one: a deck, a table [m]
    double step = 0.12;          ///< from cell to cell; what is higher is furniture, not floor [m]
    double underRobot = 0.2;     ///< under a robot a cell so near to the height of base_link is floor [m] ...
    double blind = 1.0;          ///< ... and so far around it, one that is no step away from that height [m]
    StoreyHeights heights = {};  ///< what floor is outside them, is another storey's
};

/// How high the floor is at each place of a map: floors have ramps and storeys, so that heights count from
/// the floor where one is. Floor is what is labelled so and can be reached from under the robots without a
/// step; tables are not. Where one is above another, it is the one nearest to the height at which robots
/// drove closest by; where they drove on both, the lower one. Where no floor was seen the nearest one counts.
class FloorHeights {
public:
    /// @p ground: base_link of the robots in the map, where they stood [m].
    [[nodiscard]] static FloorHeights of(std::span<const ReportScan> scans,
                                         std::span<const Eigen::Vector3d> ground,
                                         const FloorSettings& settings = {});

    /// Height of the floor in the map [m]; 0 when no floor is known at all.
    [[nodiscard]] double at(double x, double y) const;
    /// Height of the floor that bears what is at @p place, of several the highest that is not above it [m].
    [[nodiscard]] double below(const Eigen::Vector3d& place) const;
    /// Whether floor was seen there.
    [[nodiscard]] bool seen(double x, double y) const;

private:
    [[nodiscard]] std::ptrdiff_t cellOf(double x, double y) const;  ///< -1: outside
    void gather(std::span<const ReportScan> scans, const FloorSettings& settings);
    /// Marks what can be reached; how far above the floor the robots' base_link is [m].
    [[nodiscard]] double grow(std::span<const Eigen::Vector3d> ground, const FloorSettings& settings);
    void choose(std::span<const Eigen::Vector3d> ground, double lift);
    void fill(std::vector<float>& heights) const;

    double m_cell = 0.1;
    Eigen::Vector2d m_origin = Eigen::Vector2d::Zero();
    int m_columns = 0, m_rows = 0;        ///< along x and y
    std::vector<std::uint32_t> m_first;   ///< by cell, and one more: where its surfaces begin
    std::vector<float> m_surfaces;        ///< labelled so; of a cell from the lowest on [m]
    std::vector<std::uint8_t> m_reached;  ///< by surface
    std::vector<float> m_height;          ///< of the floor [m]
    std::vector<std::uint8_t> m_seen;
};

}  // namespace leitstand
