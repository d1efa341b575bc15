#pragma once

#include <memory>
#include <span>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "core/mission/report/robot_path.h"

namespace leitstand {

/// How to go to a place, along where robots have driven.
struct Way {
    std::vector<Eigen::Vector3d> points;  ///< from the start to the place [m]; empty: no robot drove near it
    double length = 0.0;                  ///< along the points, with the last piece [m]
    double lastPiece = 0.0;               ///< from where a robot drove to the place, straight [m]
    std::string robot;                    ///< whose start it begins at
};

/// Shortest ways along the trails of all robots: where trails cross, one may change from one to the other.
class WayFinder {
public:
    explicit WayFinder(std::span<const RobotPath> paths);
    ~WayFinder();
    WayFinder(WayFinder&&) noexcept;
    WayFinder& operator=(WayFinder&&) noexcept;

    /// The way from the nearest start of a robot to @p place: to the trail's nearest point, then straight.
    /// Empty when the nearest trail is farther than @p reach [m].
    [[nodiscard]] Way to(const Eigen::Vector3d& place, double reach = 5.0) const;

private:
    struct Graph;
    std::unique_ptr<Graph> m_graph;
};

}  // namespace leitstand
