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
    double cell = 0.10;          ///< [m]
    double layer = 0.10;         ///< points so far above a surface's lowest one belong to it [m] ...
    double apart = 0.25;         ///< ... those that are farther above it to another one: a deck, a table [m]
    double step = 0.12;          ///< from cell to cell; a higher one is furniture, not floor [m]
    double underRobot = 0.2;     ///< under a robot, floor is so near to the height of base_link [m] ...
    double blind = 1.0;          ///< ... and so far around it, if it is no step away from that height [m]
    StoreyHeights heights = {};  ///< floor outside them is of another storey
};

/// The height of the floor at each place of a map. Floors have ramps and storeys, so that heights count from
/// the local floor. Floor is what is labelled so and can be reached from under the robots without a step;
/// tables are not. Of floors above each other, it is the one nearest to the height at which robots drove
/// closest by. If they drove on both, it is the lower one. Where no floor was seen, the nearest one counts.
class FloorHeights {
public:
    /// @p ground: positions of the robots' base_link in the map [m].
    [[nodiscard]] static FloorHeights of(std::span<const ReportScan> scans,
                                         std::span<const Eigen::Vector3d> ground,
                                         const FloorSettings& settings = {});

    /// Returns the height of the floor in the map [m]; 0 when no floor is known at all.
    [[nodiscard]] double at(double x, double y) const;
    /// Returns the height of the floor that bears what is at @p place [m]: the highest one that is not above
    /// it.
    [[nodiscard]] double below(const Eigen::Vector3d& place) const;
    /// Returns whether floor was seen there.
    [[nodiscard]] bool seen(double x, double y) const;

private:
    [[nodiscard]] std::ptrdiff_t cellOf(double x, double y) const;  ///< -1: outside
    void gather(std::span<const ReportScan> scans, const FloorSettings& settings);
    /// Marks what can be reached. Returns how far above the floor the robots' base_link is [m].
    [[nodiscard]] double grow(std::span<const Eigen::Vector3d> ground, const FloorSettings& settings);
    void choose(std::span<const Eigen::Vector3d> ground, double lift);
    void fill(std::vector<float>& heights) const;

    double m_cell = 0.1;
    Eigen::Vector2d m_origin = Eigen::Vector2d::Zero();
    int m_columns = 0, m_rows = 0;        ///< along x and y
    std::vector<std::uint32_t> m_first;   ///< by cell, and one more: where its surfaces begin
    std::vector<float> m_surfaces;        ///< labelled as floor; of a cell from the lowest on [m]
    std::vector<std::uint8_t> m_reached;  ///< by surface
    std::vector<float> m_height;          ///< of the floor [m]
    std::vector<std::uint8_t> m_seen;
};

}  // namespace leitstand
