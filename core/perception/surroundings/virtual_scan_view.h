#pragma once

#include <limits>
#include <optional>
#include <vector>

#include <Eigen/Core>

#include "core/base/time.h"

namespace leitstand {

/// One direction of a virtual scan.
struct VirtualSector {
    std::optional<Eigen::Vector2d> outer;                  ///< farthest point, usually a wall; base_link [m]
    std::optional<Eigen::Vector2d> inner;                  ///< nearest obstacle; base_link [m]
    double age = std::numeric_limits<double>::infinity();  ///< since the last look in this direction [s];
                                                           ///< infinite: never
};

/// A point that the robot would run into.
struct VirtualObstacle {
    Eigen::Vector2d where = Eigen::Vector2d::Zero();       ///< base_link [m]
    double age = 0.0;                                      ///< since it was measured [s]
    double top = std::numeric_limits<double>::infinity();  ///< height of its upper end, as far as known [m]
    double bottom = 0.0;  ///< ... and of its lower end: above 0 for what hangs [m]
};

/// Extent of a robot's body from its base_link [m].
struct BodyBox {
    double front = 0.0, back = 0.0;  ///< along +x and -x
    double left = 0.0, right = 0.0;  ///< along +y and -y

    [[nodiscard]] double reach() const;                ///< distance of the box's farthest corner [m]
    [[nodiscard]] BodyBox grown(double margin) const;  ///< the box with @p margin [m] more all around
    [[nodiscard]] bool contains(const Eigen::Vector2d& point) const { return depth(point) > 0.0; }
    [[nodiscard]] double depth(
        const Eigen::Vector2d& point) const;  ///< inside: distance to the nearest side [m]; else <= 0
};
/// Returns the smallest box around @p footprint and base_link.
[[nodiscard]] BodyBox boxAround(const std::vector<Eigen::Vector2d>& footprint);

/// A snapshot of a virtual 2D scan, seen from the robot's current pose.
struct VirtualScanView {
    Time at{};
    std::vector<VirtualSector> sectors;      ///< from -pi to pi in base_link, counter-clockwise, equally wide
    std::vector<VirtualObstacle> obstacles;  ///< every inner point, not only one per sector
    /// End points of the rays of plane lasers in their newest turns, as measured, at any height; base_link
    /// [m]. Empty for robots without plane lasers.
    std::vector<Eigen::Vector2f> laser = {};
    double laserAge = std::numeric_limits<double>::infinity();  ///< of the oldest of those turns [s]

    /// Fills sectors that the robot's motion left empty with the values of the sectors beside them, where
    /// both show one surface. Up to @p widest empty ones in a row are filled.
    void closeGaps(int widest = 4);

    /// Fills sectors beside an edge that were never looked at: a scanner ahead of base_link sees the edge
    /// from another side. Such a sector counts as seen as far as the nearer of the sectors beside it. Up to
    /// @p widest sectors in a row are filled.
    void bridgeEdges(int widest);

    [[nodiscard]] int sectorOf(double direction) const;  ///< sector that holds @p direction [rad]
    [[nodiscard]] double directionOf(int sector) const;  ///< direction of the middle of @p sector [rad]

    /// Returns the distance from base_link to the nearest obstacle that is not older than @p maxAge [s];
    /// infinite when there is none. Only directions from @p from counter-clockwise to @p to [rad] count.
    [[nodiscard]] double nearest(double from, double to,
                                 double maxAge = std::numeric_limits<double>::infinity()) const;
    /// Returns the age of the oldest sector from @p from counter-clockwise to @p to [rad], in s; infinite
    /// when one was never looked at.
    [[nodiscard]] double oldest(double from, double to) const;
    /// Returns the age of the sector that was looked at last [s]; infinite when none ever was.
    [[nodiscard]] double youngest() const;
    /// Returns how long a corridor of @p width from base_link towards @p direction [rad] is free of
    /// obstacles, at most @p limit [m].
    [[nodiscard]] double freeLength(double direction, double width, double limit) const;
    /// Returns how far @p body can move along the arc of @p forward [m/s] and @p turn [rad/s] until it
    /// touches an obstacle, at most @p limit. The length is that of the path of its fastest corner:
    /// (|forward| + |turn| * reach) * time [m]. An obstacle that already touches counts only when the motion
    /// makes it worse.
    [[nodiscard]] double freeTravel(double forward, double turn, const BodyBox& body, double limit) const;
};

}  // namespace leitstand
