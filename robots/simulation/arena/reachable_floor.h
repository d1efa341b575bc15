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

/// Returns the lowest storey's floor that a round robot of @p radius reaches from the arena's starts, when it
/// climbs steps up to @p maxStep [m]. What gives way (curtains, paper, foil) or hangs higher than 0.6 m is no
/// obstacle.
[[nodiscard]] ReachableFloor reachableFloor(const Arena& arena, double radius, double maxStep = 0.03);

/// Does the same for each storey of a building, lowest first. Storeys are floors that lie 1.5 m or more above
/// each other. Where a storey has a hole, its squares are those of the storey below.
[[nodiscard]] std::vector<ReachableFloor> reachableStoreys(const Arena& arena, double radius,
                                                           double maxStep = 0.03);

/// Returns the place in front of a victim where robots reach it, @p distance from its side, in the arena's
/// frame [m].
[[nodiscard]] Eigen::Vector2d placeBefore(const Element& victim, double distance);
/// Returns whether a robot on @p floor comes near enough to see @p victim: to 0.7 m from the victim's side or
/// nearer, measured from the robot's middle.
[[nodiscard]] bool reaches(const ReachableFloor& floor, const Element& victim);

}  // namespace leitstand::simulation
