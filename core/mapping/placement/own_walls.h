#pragma once

#include <algorithm>
#include <cstddef>
#include <deque>
#include <vector>

#include <Eigen/Core>

#include "core/mapping/live/map/moved_places.h"
#include "core/mapping/placement/flat_pose.h"
#include "core/mapping/placement/laser_view.h"
#include "core/mapping/placement/wall_map.h"

namespace leitstand {

/// What a robot's own laser saw of late, where the robot was taken to be then: walls that the map does not
/// have yet. As scans of a plane laser they hold each other (Lu & Milios 1997). They are not held by the map:
/// the robot's place drifts slowly until the map has it again.
class OwnWalls {
public:
    /// The robot was at @p place (base_link in the map, at @p height [m]) when it saw @p view. Not kept where
    /// one of the last views was seen from about there. On another storey it begins anew.
    void add(const LaserView& view, const FlatPose& place, double height);
    /// The map has the robot: what it saw lies where it was put.
    void settle() { m_settled = m_views.size(); }
    /// What was seen since settle() and breakOff() lies elsewhere: the robot was at @p found, not @p taken.
    void correct(const FlatPose& taken, const FlatPose& found);
    /// Nothing tells how what comes and what was seen since settle() lie to each other.
    void breakOff() { m_chain = m_views.size(); }
    /// Scans of the map moved, and the robot with them.
    void move(const MovedPlaces& places);
    void forget();

    [[nodiscard]] bool empty() const { return m_views.empty(); }
    /// The walls of @p map, and those that were seen.
    [[nodiscard]] WallMap with(const WallMap& map) const;
    /// What was seen on the last metres, as from @p place, where the robot sees @p newest: since settle() and
    /// breakOff(). A place that only looks alike does not have all of it.
    [[nodiscard]] LaserView seenFrom(const FlatPose& place, const LaserView& newest) const;

private:
    [[nodiscard]] std::size_t chain() const { return std::max(m_settled, m_chain); }  ///< where it begins
    /// Of the views of the chain, where the last few begin.
    [[nodiscard]] std::size_t last() const;

    struct View {
        FlatPose place;
        std::vector<Eigen::Vector2f> points, normals;  ///< base_link's [m]
    };
    std::deque<View> m_views;                ///< newest last
    std::size_t m_settled = 0, m_chain = 0;  ///< views before
    double m_height = 0.0;                   ///< where it began [m]
};

}  // namespace leitstand
