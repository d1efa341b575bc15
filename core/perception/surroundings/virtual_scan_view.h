#pragma once

#include <limits>
#include <optional>
#include <vector>

#include <Eigen/Core>

#include "core/base/time.h"

namespace leitstand {

/// One direction of a virtual scan.
struct VirtualSector {
    std::optional<Eigen::Vector2d> outer;  ///< farthest point, usually a wall; in base_link [m]
    std::optional<Eigen::Vector2d> inner;  ///< nearest obstacle; in base_link [m]
    /// Since this direction was last measured [s]; infinite: never.
    double age = std::numeric_limits<double>::infinity();
};

/// A point with which the robot would collide.
struct VirtualObstacle {
    Eigen::Vector2d where = Eigen::Vector2d::Zero();       ///< position in base_link [m]
    double age = 0.0;                                      ///< since it was measured [s]
    double top = std::numeric_limits<double>::infinity();  ///< height of its upper end, as far as known [m]
    double bottom = 0.0;  ///< height of its lower end [m]; above 0 for things that hang
};

/// Extent of a robot's body from its base_link [m].
struct BodyBox {
    double front = 0.0, back = 0.0;  ///< distances along +x and -x
    double left = 0.0, right = 0.0;  ///< distances along +y and -y

    [[nodiscard]] double reach() const;                ///< distance of the box's farthest corner [m]
    [[nodiscard]] BodyBox grown(double margin) const;  ///< the box plus @p margin [m] on all sides
    [[nodiscard]] bool contains(const Eigen::Vector2d& point) const { return depth(point) > 0.0; }
    /// Distance to the nearest side for a point inside [m]; otherwise <= 0.
    [[nodiscard]] double depth(const Eigen::Vector2d& point) const;
};
/// Returns the smallest box around @p footprint and base_link.
[[nodiscard]] BodyBox boxAround(const std::vector<Eigen::Vector2d>& footprint);

/// A snapshot of a virtual 2D scan, seen from the robot's current pose.
struct VirtualScanView {
    Time at{};
    std::vector<VirtualSector> sectors;  ///< from -pi to pi in base_link, counter-clockwise, of equal width
    std::vector<VirtualObstacle> obstacles;  ///< all inner points, not only one per sector
    /// End points of the rays of plane lasers in their newest turns, as measured, at any height; in base_link
    /// [m]. Empty for robots without plane lasers.
    std::vector<Eigen::Vector2f> laser = {};
    double laserAge = std::numeric_limits<double>::infinity();  ///< age of the oldest of those turns [s]

    /// Fills sectors that are empty because the robot moved, with the values of their neighbours, if both
    /// neighbours show the same surface. At most @p widest consecutive sectors are filled.
    void closeGaps(int widest = 4);

    /// Fills sectors beside an edge that were never measured, since a scanner ahead of base_link sees the
    /// edge from another side. Such a sector is assumed to be visible as far as the nearer of its neighbours.
    /// At most @p widest consecutive sectors are filled.
    void bridgeEdges(int widest);

    [[nodiscard]] int sectorOf(double direction) const;  ///< sector that contains @p direction [rad]
    [[nodiscard]] double directionOf(int sector) const;  ///< direction of the middle of @p sector [rad]

    /// Returns the distance from base_link to the nearest obstacle that is at most @p maxAge old [s];
    /// infinite when there is none. Only directions counter-clockwise from @p from to @p to [rad] are
    /// searched.
    [[nodiscard]] double nearest(double from, double to,
                                 double maxAge = std::numeric_limits<double>::infinity()) const;
    /// Returns the age of the oldest sector counter-clockwise from @p from to @p to [rad], in s. Infinite
    /// when one of them was never measured.
    [[nodiscard]] double oldest(double from, double to) const;
    /// Returns the age of the sector that was measured last [s]; infinite when none was ever measured.
    [[nodiscard]] double youngest() const;
    /// Returns for what distance a corridor from base_link towards @p direction [rad] is free of obstacles,
    /// at most @p limit [m]. @p width: width of the corridor [m].
    [[nodiscard]] double freeLength(double direction, double width, double limit) const;
    /// Returns how far @p body can move along the arc of @p forward [m/s] and @p turn [rad/s] until it
    /// touches an obstacle, at most @p limit. The length is that of the path of its fastest corner:
    /// (|forward| + |turn| * reach) * time [m]. An obstacle that already touches is ignored unless the motion
    /// brings it farther inside the body.
    [[nodiscard]] double freeTravel(double forward, double turn, const BodyBox& body, double limit) const;
};

}  // namespace leitstand
