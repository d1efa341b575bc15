#pragma once

#include <cstddef>
#include <deque>
#include <vector>

#include <Eigen/Core>

#include "core/mapping/placement/laser_view.h"
#include "core/mapping/placement/wall_map.h"
#include "core/mapping/walls/flat_pose.h"

namespace leitstand {

/// What a robot's own laser saw on its way of late, where the robot was taken to be then: walls that the map
/// does not have yet. They hold the robot against each other, as scans of a plane laser do (Lu & Milios
/// 1997), not against the map: its place drifts slowly until the map has it again.
class OwnWalls {
public:
    /// The robot was at @p place (base_link in the map) when it saw @p view. Views that show nothing new,
    /// since the robot stood about there before, are not kept.
    void add(const LaserView& view, const FlatPose& place);
    /// The map has the robot: what it saw lies where it was put.
    void settle() { m_settled = m_views.size(); }
    /// What was seen since settle() lies elsewhere: the robot was at @p found, not at @p taken.
    void correct(const FlatPose& taken, const FlatPose& found);
    /// What comes does not lie where what was seen before would have it: nothing tells how they belong
    /// together.
    void breakOff() { m_chain = m_views.size(); }
    void forget();

    [[nodiscard]] bool empty() const { return m_views.empty(); }
    /// The walls of @p map, and those that were seen.
    [[nodiscard]] WallMap with(const WallMap& map) const;
    /// What was seen on the last metres, as from @p place, where the robot sees @p newest: since the map had
    /// the robot last, and since breakOff(). A place that only looks alike does not have all of it.
    [[nodiscard]] LaserView seenFrom(const FlatPose& place, const LaserView& newest) const;

private:
    struct View {
        FlatPose place;
        std::vector<Eigen::Vector2f> points, normals;  ///< base_link's [m]
    };
    std::deque<View> m_views;                ///< newest last
    std::size_t m_settled = 0, m_chain = 0;  ///< views before
};

}  // namespace leitstand
