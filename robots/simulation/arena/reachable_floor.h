#pragma once

#include <vector>

#include "robots/simulation/arena/arena.h"

namespace leitstand::simulation {

/// The floor that the middle of a robot can reach, as squares seen from above.
struct ReachableFloor {
    double level = 0.0;                              ///< height of the storey [m]
    Eigen::Vector2d from = Eigen::Vector2d::Zero();  ///< corner of the first square [m]
    double cell = 0.05;                              ///< edge of a square [m]
    int columns = 0, rows = 0;
    std::vector<char> reached;  ///< row by row; rows are along y

    [[nodiscard]] bool at(const Eigen::Vector2d& point) const;
    [[nodiscard]] double area() const;  ///< area that can be reached [m2]
    /// Returns the distance from @p point to the middle of the nearest reachable square [m]; infinite when
    /// there is none.
    [[nodiscard]] double distanceTo(const Eigen::Vector2d& point) const;
};

/// Returns the floor of the lowest storey that a round robot of @p radius can reach from the arena's starts,
/// if it climbs steps up to @p maxStep [m]. Things that robots can push aside (curtains, paper, foil) or that
/// hang higher than 0.6 m are no obstacles.
[[nodiscard]] ReachableFloor reachableFloor(const Arena& arena, double radius, double maxStep = 0.03);

/// Returns the same for each storey of a building, the lowest first. Storeys are floors at least 1.5 m above
/// each other. Where a storey has a hole, its squares are those of the storey below.
[[nodiscard]] std::vector<ReachableFloor> reachableStoreys(const Arena& arena, double radius,
                                                           double maxStep = 0.03);

/// Returns the place from which robots reach a victim: @p distance from its side, in the arena's frame [m].
[[nodiscard]] Eigen::Vector2d placeBefore(const Element& victim, double distance);
/// Returns whether a robot on @p floor can get near enough to see @p victim: its middle is at most 0.7 m from
/// the victim's side.
[[nodiscard]] bool reaches(const ReachableFloor& floor, const Element& victim);

}  // namespace leitstand::simulation
