#pragma once

#include <cstddef>
#include <deque>
#include <vector>

#include <Eigen/Core>

#include "core/mapping/placement/laser_view.h"
#include "core/mapping/placement/wall_map.h"
#include "core/mapping/walls/flat_pose.h"

namespace leitstand {

/// The walls that a robot's laser saw recently, at the poses that the robot was thought to have. The map does
/// not have these walls yet. Views are fitted to each other, as scans of a plane laser are (Lu & Milios
/// 1997), and not to the map. So the robot's pose drifts slowly until its laser fits the map again.
class OwnWalls {
public:
    /// Adds @p view, seen from @p place (base_link in the map). Drops a view that shows nothing new, because
    /// the robot was near there before.
    void add(const LaserView& view, const FlatPose& place);
    /// Notes that the laser fits the map: the views so far will not move any more.
    void settle() { m_settled = m_views.size(); }
    /// Moves the views since settle(), because the robot was at @p found, not at @p taken.
    void correct(const FlatPose& taken, const FlatPose& found);
    /// Separates later views from earlier ones, because they do not fit and their relative pose is unknown.
    void breakOff() { m_chain = m_views.size(); }
    void forget();

    [[nodiscard]] bool empty() const { return m_views.empty(); }
    /// Returns the walls of @p map together with those of the views.
    [[nodiscard]] WallMap with(const WallMap& map) const;
    /// Returns @p newest together with the views of the last metres, as seen from @p place. Views before
    /// settle() or breakOff() are left out. Another place that only looks similar will not match all of this.
    [[nodiscard]] LaserView seenFrom(const FlatPose& place, const LaserView& newest) const;

private:
    struct View {
        FlatPose place;
        std::vector<Eigen::Vector2f> points, normals;  ///< points and normals in base_link [m]
    };
    std::deque<View> m_views;                ///< newest last
    std::size_t m_settled = 0, m_chain = 0;  ///< number of views before settle(), and before breakOff()
};

}  // namespace leitstand
