#pragma once

#include <optional>
#include <random>
#include <vector>

#include <Eigen/Core>

#include "core/cloud/scan.h"

namespace leitstand::test {

/// A body or a room: an axis-aligned box, room frame [m].
struct Box {
    Eigen::Vector3d low, high;
};

/// A point of a surface.
struct Hit {
    double range = 0.0;      ///< from the ray's origin [m]
    Eigen::Vector3d point;   ///< room frame [m]
    Eigen::Vector3d normal;  ///< into free space, along an axis of the room
    int body = -1;           ///< index of the box hit, -1: the room itself
};

/// An empty or furnished room made of axis-aligned boxes, with exact ray casting.
class RoomScene {
public:
    /// A room of these sizes [m], origin in the middle of the floor; furniture keeps to places that scale
    /// with the room and leaves the middle free; open ends (at +-length/2) give no echo.
    RoomScene(double length, double width, double height, bool furnished, bool openEnds);

    /// The first surface along a ray of unit @p direction, starting in free space.
    [[nodiscard]] std::optional<Hit> cast(const Eigen::Vector3d& origin,
                                          const Eigen::Vector3d& direction) const;
    /// Distance of @p hit from the border of its face or from the nearest other body [m].
    [[nodiscard]] double edgeDistance(const Hit& hit) const;
    /// A point of the visible surfaces, all places equally likely.
    [[nodiscard]] Hit sample(std::mt19937& random) const;

private:
    [[nodiscard]] const Box& box(int body) const;
    [[nodiscard]] bool buried(const Hit& hit) const;

    Box m_room;
    bool m_openEnds;
    std::vector<Box> m_bodies;
};

/// The label of a surface with @p normal in the room's frame.
[[nodiscard]] Label trueLabel(const Eigen::Vector3d& normal);

}  // namespace leitstand::test
