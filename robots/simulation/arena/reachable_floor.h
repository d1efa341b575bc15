#pragma once

#include <vector>

#include "robots/simulation/arena/arena.h"

namespace leitstand::simulation {

/// The floor that the middle of a robot reaches, as squares, seen from above.
struct ReachableFloor {
    double level = 0.0;                              ///< height of the storey [m]
    Eigen::Vector2d from = Eigen::Vector2d::Zero();  ///< corner of the first square [m]
    double cell = 0.05;                              ///< edge of a square [m]
    int columns = 0, rows = 0;
    std::vector<char> reached;  ///< row-major, rows along y

    [[nodiscard]] bool at(const Eigen::Vector2d& point) const;
    [[nodiscard]] double area() const;  ///< [m2]
    /// Returns the distance from @p point to the middle of the nearest reached square [m]; infinite when no
    /// square is reached.
    [[nodiscard]] double distanceTo(const Eigen::Vector2d& point) const;
};

/// Floods the floor from the arena's starts for a round robot of @p radius that climbs steps up to @p maxStep
/// [m]. What gives way (curtains, paper, foil) or hangs higher than 0.6 m is no obstacle.
[[nodiscard]] ReachableFloor reachableFloor(const Arena& arena, double radius, double maxStep = 0.03);

/// Does the same for a building: one floor per storey, lowest first. Storeys are floors that lie 1.5 m or
/// more above each other. Where a storey has a hole, its squares are those of what shows through it.
[[nodiscard]] std::vector<ReachableFloor> reachableStoreys(const Arena& arena, double radius,
                                                           double maxStep = 0.03);

/// Returns the place in front of a victim where robots reach it, @p distance from its side, in the arena's
/// frame [m].
[[nodiscard]] Eigen::Vector2d placeBefore(const Element& victim, double distance);
/// Returns whether @p floor comes so near to @p victim that a robot can stop 0.8 m in front of it and see it.
[[nodiscard]] bool reaches(const ReachableFloor& floor, const Element& victim);

}  // namespace leitstand::simulation
