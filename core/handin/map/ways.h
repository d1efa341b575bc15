#pragma once

#include <memory>
#include <span>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "core/handin/map/occupancy_grid.h"
#include "core/handin/map/robot_path.h"
#include "core/mapping/floor_heights.h"

namespace leitstand {

/// A way to a place along the trails of robots.
struct Way {
    /// From the start to the place, in the map [m]; empty: no robot drove near it.
    std::vector<Eigen::Vector3d> points;
    double length = 0.0;     ///< length along the points, including the last piece [m]
    double lastPiece = 0.0;  ///< straight piece from the trail to the place: its length [m]
    bool clear = false;      ///< whether the map shows no obstacle on the last piece; false without a map
    std::string robot;       ///< robot from whose start the way begins
};

/// Finds the shortest ways along the trails of all robots. Where trails cross, a way may change from one
/// trail to another.
class WayFinder {
public:
    explicit WayFinder(std::span<const RobotPath> paths);
    ~WayFinder();
    WayFinder(WayFinder&&) noexcept;
    WayFinder& operator=(WayFinder&&) noexcept;

    /// Returns the way from the nearest start of a robot to @p place: along the trails to the nearest clear
    /// point, then straight. @p map: at the height that stops robots. A point is clear if the map shows
    /// nothing between it and @p place. Its floor must also be on the same storey as the floor below
    /// @p place. If no point is clear, the point of the trails nearest to @p place is used. Empty when no
    /// trail comes within @p reach [m].
    [[nodiscard]] Way to(const Eigen::Vector3d& place, const OccupancyGrid& map = {},
                         const FloorHeights& floor = {}, double reach = 5.0) const;

private:
    struct Graph;
    std::unique_ptr<Graph> m_graph;
};

}  // namespace leitstand
