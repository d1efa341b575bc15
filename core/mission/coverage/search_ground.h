#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include <Eigen/Core>

#include "core/mapping/report_scan.h"
#include "core/mapping/storeys.h"
#include "core/mission/coverage/coverage_settings.h"

namespace leitstand {

class FloorHeights;

/// The floor to search, as a grid in the map frame. Holds the height of the floor by the scans, what stands
/// on it, and which of it robots can reach.
class SearchGround {
public:
    /// Computes the ground of the storey with @p heights. @p trail: base_link where robots were, in the map
    /// [m].
    [[nodiscard]] static SearchGround of(std::span<const ReportScan> scans,
                                         std::span<const Eigen::Vector3d> trail,
                                         const CoverageSettings& settings = {},
                                         const StoreyHeights& heights = {});

    [[nodiscard]] double cell() const { return m_cell; }                      ///< edge [m]
    [[nodiscard]] int columns() const { return m_columns; }                   ///< along x
    [[nodiscard]] int rows() const { return m_rows; }                         ///< along y
    [[nodiscard]] const Eigen::Vector2d& origin() const { return m_origin; }  ///< corner of cell 0 [m]
    [[nodiscard]] std::size_t size() const { return m_floor.size(); }

    [[nodiscard]] std::ptrdiff_t cellAt(const Eigen::Vector2d& place) const;       ///< -1: outside
    [[nodiscard]] Eigen::Vector2d middleOf(std::size_t cell) const;                ///< [m]
    [[nodiscard]] float height(std::size_t cell) const { return m_height[cell]; }  ///< of the floor [m]
    /// Whether the floor of @p cell was seen and carries no obstacle for robots.
    [[nodiscard]] bool isFloor(std::size_t cell) const { return m_floor[cell] != 0; }
    /// Whether a robot can reach the floor of @p cell from where robots drove.
    [[nodiscard]] bool isReachable(std::size_t cell) const { return m_reachable[cell] != 0; }
    [[nodiscard]] double reachableArea() const;  ///< [m2]
    /// Whether something stands between @p from and @p to (map frame [m]). What stands in the cell of @p from
    /// or of @p to does not count.
    [[nodiscard]] bool hides(const Eigen::Vector3d& from, const Eigen::Vector3d& to) const;

private:
    bool frame(std::span<const ReportScan> scans);
    void stand(std::span<const ReportScan> scans, std::span<const Eigen::Vector3d> trail,
               const FloorHeights& floor);
    [[nodiscard]] std::vector<std::uint16_t> trodden(std::span<const Eigen::Vector3d> trail) const;
    void closeWalls();
    void closeFloor();
    void reach(std::span<const Eigen::Vector3d> trail);
    [[nodiscard]] std::vector<std::uint8_t> grown(const std::vector<std::uint8_t>& cells,
                                                  double radius) const;
    [[nodiscard]] bool obstructs(std::size_t cell) const;
    [[nodiscard]] std::uint32_t layers(double low, double high) const;

    CoverageSettings m_settings;
    double m_cell = 0.1;
    Eigen::Vector2d m_origin = Eigen::Vector2d::Zero();
    int m_columns = 0, m_rows = 0;
    std::vector<float> m_height;            ///< of the floor; where none was seen, of the nearest [m]
    std::vector<std::uint32_t> m_standing;  ///< bit i: something stands i to i + 1 layers above the floor
    std::vector<std::uint8_t> m_floor, m_reachable;
};

}  // namespace leitstand
