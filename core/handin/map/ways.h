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
    std::vector<Eigen::Vector3d> points;  ///< from the start to the place [m]; empty: no robot drove near it
    double length = 0.0;                  ///< along the points, with the last piece [m]
    double lastPiece = 0.0;               ///< straight, from the trail to the place [m]
    bool clear = false;  ///< the map shows nothing in the way of the last piece; false without a map
    std::string robot;   ///< robot at whose start the way begins
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
    /// point, then straight. A point is clear when @p map (at the height that stops robots) shows nothing
    /// between it and @p place. Its floor must also be on the storey of the floor below @p place. If no point
    /// is clear, the way leads over the point of the trails that is nearest to @p place. Empty when no trail
    /// comes within @p reach [m].
    [[nodiscard]] Way to(const Eigen::Vector3d& place, const OccupancyGrid& map = {},
                         const FloorHeights& floor = {}, double reach = 5.0) const;

private:
    struct Graph;
    std::unique_ptr<Graph> m_graph;
};

}  // namespace leitstand
