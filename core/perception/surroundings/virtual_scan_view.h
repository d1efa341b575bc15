#pragma once

#include <limits>
#include <optional>
#include <vector>

#include <Eigen/Core>

#include "core/base/time.h"

namespace leitstand {

/// One direction of a virtual scan.
struct VirtualSector {
    std::optional<Eigen::Vector2d> outer;                  ///< farthest point, walls; base_link [m]
    std::optional<Eigen::Vector2d> inner;                  ///< nearest obstacle; base_link [m]
    double age = std::numeric_limits<double>::infinity();  ///< since the last look [s]; infinite: never
};

/// A point that the robot would run into.
struct VirtualObstacle {
    Eigen::Vector2d where = Eigen::Vector2d::Zero();       ///< base_link [m]
    double age = 0.0;                                      ///< since it was measured [s]
    double top = std::numeric_limits<double>::infinity();  ///< height of its upper end, as far as known [m]
    double bottom = 0.0;  ///< ... and of its lower end: more for what hangs [m]
};

/// Extent of a robot's body from its base_link [m].
struct BodyBox {
    double front = 0.0, back = 0.0;  ///< along +x and -x
    double left = 0.0, right = 0.0;  ///< along +y and -y

    [[nodiscard]] double reach() const;                ///< of its farthest corner [m]
    [[nodiscard]] BodyBox grown(double margin) const;  ///< by @p margin all around
    [[nodiscard]] bool contains(const Eigen::Vector2d& point) const { return depth(point) > 0.0; }
    [[nodiscard]] double depth(
        const Eigen::Vector2d& point) const;  ///< inside: to the nearest side [m]; else <= 0
};
/// The box around a footprint polygon.
[[nodiscard]] BodyBox boxAround(const std::vector<Eigen::Vector2d>& footprint);

/// A virtual 2D scan as the robot sees it from its current place: a value.
struct VirtualScanView {
    Time at{};
    std::vector<VirtualSector> sectors;      ///< from -pi to pi in base_link, counter-clockwise, equally wide
    std::vector<VirtualObstacle> obstacles;  ///< every inner point, not only one per sector
    /// End points of the rays of plane lasers in their newest turns, as measured, at any height; base_link
    /// [m]. Empty for robots without one.
    std::vector<Eigen::Vector2f> laser = {};
    double laserAge = std::numeric_limits<double>::infinity();  ///< of the oldest of those turns [s]

    /// Fills sectors that the robot's motion left empty with the values of those beside them, where that is
    /// one surface; up to @p widest of them in a row.
    void closeGaps(int widest = 4);

    /// Fills sectors beside an edge that were never looked at: a scanner ahead of base_link sees the edge
    /// from another side. They are as far in sight as the nearer of the sectors beside them; up to @p widest
    /// of them in a row.
    void bridgeEdges(int widest);

    [[nodiscard]] int sectorOf(double direction) const;  ///< [rad]
    [[nodiscard]] double directionOf(int sector) const;  ///< of its middle [rad]

    /// Returns the distance from base_link of the nearest obstacle, not older than @p maxAge [s]; infinite
    /// when there is none. Only directions from @p from counter-clockwise to @p to [rad] count.
    [[nodiscard]] double nearest(double from, double to,
                                 double maxAge = std::numeric_limits<double>::infinity()) const;
    /// Age of the oldest sector from @p from counter-clockwise to @p to [s]; infinite: one was never looked
    /// at.
    [[nodiscard]] double oldest(double from, double to) const;
    /// Age of the sector that was looked at last [s]; infinite: none ever was.
    [[nodiscard]] double youngest() const;
    /// Length of a corridor of @p width from base_link towards @p direction until an obstacle, at most
    /// @p limit [m].
    [[nodiscard]] double freeLength(double direction, double width, double limit) const;
    /// Returns how far a body can move along the arc of @p forward [m/s] and @p turn [rad/s] until it
    /// touches, at most @p limit. This is measured by its fastest corner: (|forward| + |turn| * reach) * time
    /// [m]. What already touches counts only when the motion makes it worse.
    [[nodiscard]] double freeTravel(double forward, double turn, const BodyBox& body, double limit) const;
};

}  // namespace leitstand
