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

/// The floor to search, as a grid in the map's frame. Has the height of the floor as seen by scans, what
/// stands on it, and where robots can go.
class SearchGround {
public:
    /// Computes the ground of the storey with @p heights. @p trail: where base_link of robots was in the map
    /// [m].
    [[nodiscard]] static SearchGround of(std::span<const ReportScan> scans,
                                         std::span<const Eigen::Vector3d> trail,
                                         const CoverageSettings& settings = {},
                                         const StoreyHeights& heights = {});

    [[nodiscard]] double cell() const { return m_cell; }                      ///< edge of a cell [m]
    [[nodiscard]] int columns() const { return m_columns; }                   ///< number of cells along x
    [[nodiscard]] int rows() const { return m_rows; }                         ///< number of cells along y
    [[nodiscard]] const Eigen::Vector2d& origin() const { return m_origin; }  ///< corner of cell 0 [m]
    [[nodiscard]] std::size_t size() const { return m_floor.size(); }

    /// Index of the cell; -1: outside.
    [[nodiscard]] std::ptrdiff_t cellAt(const Eigen::Vector2d& place) const;
    [[nodiscard]] Eigen::Vector2d middleOf(std::size_t cell) const;  ///< middle of the cell in the map [m]
    /// Height of the floor in the map [m].
    [[nodiscard]] float height(std::size_t cell) const { return m_height[cell]; }
    /// Whether the floor of @p cell was seen and carries no obstacle for robots.
    [[nodiscard]] bool isFloor(std::size_t cell) const { return m_floor[cell] != 0; }
    /// Whether a robot can reach the floor of @p cell from where robots drove.
    [[nodiscard]] bool isReachable(std::size_t cell) const { return m_reachable[cell] != 0; }
    [[nodiscard]] double reachableArea() const;  ///< area that robots can reach [m2]
    /// Whether something stands between @p from and @p to (in the map [m]). Things in the cells of @p from
    /// and @p to are ignored.
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
    /// Height of the floor in each cell; of the nearest known cell where none was seen [m].
    std::vector<float> m_height;
    std::vector<std::uint32_t> m_standing;  ///< bit i: something stands i to i + 1 layers above the floor
    std::vector<std::uint8_t> m_floor, m_reachable;
};

}  // namespace leitstand
