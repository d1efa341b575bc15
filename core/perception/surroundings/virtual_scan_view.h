#pragma once

#include <limits>
#include <optional>
#include <vector>

#include <Eigen/Core>

#include "core/base/time.h"

namespace leitstand {

/// What a virtual scan knows of one direction.
struct VirtualSector {
    std::optional<Eigen::Vector2d> outer;                  ///< farthest point, walls; base_link [m]
    std::optional<Eigen::Vector2d> inner;                  ///< nearest obstacle; base_link [m]
    double age = std::numeric_limits<double>::infinity();  ///< since it was looked at [s]; infinite: never
};

/// A point that the robot would run into.
struct VirtualObstacle {
    Eigen::Vector2d where = Eigen::Vector2d::Zero();  ///< base_link [m]
    double age = 0.0;                                 ///< since it was measured [s]
    double top =
        std::numeric_limits<double>::infinity();  ///< height of what stands there, as far as known [m]
    double bottom = 0.0;                          ///< ... and where it begins: more for what hangs [m]
};

/// How far a robot's body reaches from its base_link [m].
struct BodyBox {
    double front = 0.0, back = 0.0;  ///< along +x and -x
    double left = 0.0, right = 0.0;  ///< along +y and -y

    [[nodiscard]] double reach() const;                ///< of its farthest corner [m]
    [[nodiscard]] BodyBox grown(double margin) const;  ///< by @p margin all around
    [[nodiscard]] bool contains(const Eigen::Vector2d& point) const { return depth(point) > 0.0; }
    [[nodiscard]] double depth(
        const Eigen::Vector2d& point) const;  ///< inside: to the nearest side; else <= 0
};
/// The box around a footprint polygon.
[[nodiscard]] BodyBox boxAround(const std::vector<Eigen::Vector2d>& footprint);

/// A virtual 2D scan as the robot sees it from where it is now: a value.
struct VirtualScanView {
    Time at{};
    std::vector<VirtualSector> sectors;      ///< from -pi to pi in base_link, counter-clockwise, all alike
    std::vector<VirtualObstacle> obstacles;  ///< every inner point, not thinned to sectors
    /// Where the rays of plane lasers ended in their newest turns, as measured, at whatever height; base_link
    /// [m]. Empty for robots without one.
    std::vector<Eigen::Vector2f> laser = {};
    double laserAge = std::numeric_limits<double>::infinity();  ///< of the oldest of those turns [s]

    /// Sectors that nothing fell into, because the robot moved, get what those beside them have, where that
    /// is one surface; up to @p widest of them in a row.
    void closeGaps(int widest = 4);

    /// Sectors that were never looked at beside an edge, which a scanner ahead of base_link sees from another
    /// side, are as far in sight as the nearer of those beside them; up to @p widest of them in a row.
    void bridgeEdges(int widest);

    [[nodiscard]] int sectorOf(double direction) const;  ///< [rad]
    [[nodiscard]] double directionOf(int sector) const;  ///< of its middle [rad]

    /// Distance from base_link of the nearest obstacle in the directions from @p from counter-clockwise to
    /// @p to [rad], not older than @p maxAge [s]; infinite when there is none.
    [[nodiscard]] double nearest(double from, double to,
                                 double maxAge = std::numeric_limits<double>::infinity()) const;
    /// Age of the oldest of the sectors from @p from counter-clockwise to @p to [s]; infinite: one was never
    /// looked at.
    [[nodiscard]] double oldest(double from, double to) const;
    /// Age of the sector that was looked at last [s]; infinite: none ever was.
    [[nodiscard]] double youngest() const;
    /// Length of a corridor of @p width from base_link towards @p direction until an obstacle, at most
    /// @p limit [m].
    [[nodiscard]] double freeLength(double direction, double width, double limit) const;
    /// How far a body can move along the arc of @p forward [m/s] and @p turn [rad/s] until it touches, at
    /// most @p limit. Measured by its fastest corner: (|forward| + |turn| * reach) * time [m]. What already
    /// touches counts only when the motion makes it worse.
    [[nodiscard]] double freeTravel(double forward, double turn, const BodyBox& body, double limit) const;
};

}  // namespace leitstand
