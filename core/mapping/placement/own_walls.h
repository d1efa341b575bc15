#pragma once

#include <cstddef>
#include <deque>
#include <vector>

#include <Eigen/Core>

#include "core/mapping/placement/laser_view.h"
#include "core/mapping/placement/wall_map.h"
#include "core/mapping/walls/flat_pose.h"

namespace leitstand {

/// The walls that a robot's laser saw lately, at the poses that the robot was taken to have then. The map
/// does not have these walls yet. Views hold the robot against each other, as scans of a plane laser do (Lu &
/// Milios 1997), and not against the map. So the robot's pose drifts slowly until its laser meets the map
/// again.
class OwnWalls {
public:
    /// Adds @p view, which the robot saw at @p place (base_link in the map). Views that show nothing new,
    /// since the robot stood near there before, are not kept.
    void add(const LaserView& view, const FlatPose& place);
    /// Notes that the robot's laser meets the map: views so far stay where they are.
    void settle() { m_settled = m_views.size(); }
    /// Moves the views since settle(): the robot was at @p found, not at @p taken.
    void correct(const FlatPose& taken, const FlatPose& found);
    /// Separates later views from earlier ones: they do not fit, so their relative pose is unknown.
    void breakOff() { m_chain = m_views.size(); }
    void forget();

    [[nodiscard]] bool empty() const { return m_views.empty(); }
    /// Returns the walls of @p map, and those of the views.
    [[nodiscard]] WallMap with(const WallMap& map) const;
    /// Returns @p newest together with the views of the last metres, as seen from @p place. Views before
    /// settle() or breakOff() are left out. A place that only looks alike does not have all of it.
    [[nodiscard]] LaserView seenFrom(const FlatPose& place, const LaserView& newest) const;

private:
    struct View {
        FlatPose place;
        std::vector<Eigen::Vector2f> points, normals;  ///< in base_link [m]
    };
    std::deque<View> m_views;                ///< newest last
    std::size_t m_settled = 0, m_chain = 0;  ///< number of views before settle(), and before breakOff()
};

}  // namespace leitstand
