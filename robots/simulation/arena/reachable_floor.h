#pragma once

#include <vector>

#include "robots/simulation/arena/arena.h"

namespace leitstand::simulation {

/// The floor that the middle of a robot gets to, as squares, seen from above.
struct ReachableFloor {
    double level = 0.0;                              ///< height of the storey [m]
    Eigen::Vector2d from = Eigen::Vector2d::Zero();  ///< corner of the first square [m]
    double cell = 0.05;                              ///< edge of a square [m]
    int columns = 0, rows = 0;
    std::vector<char> reached;  ///< row-major, rows along y

    [[nodiscard]] bool at(const Eigen::Vector2d& point) const;
    [[nodiscard]] double area() const;  ///< [m2]
    /// Distance from @p point to the nearest reached square's middle; infinite when none is [m].
    [[nodiscard]] double distanceTo(const Eigen::Vector2d& point) const;
};

/// Floods the floor from the arena's starts for a round robot of @p radius that climbs steps up to
/// @p maxStep [m]. What gives way (curtains, paper, foil) is no obstacle, nor is what hangs higher than 0.6
/// m.
[[nodiscard]] ReachableFloor reachableFloor(const Arena& arena, double radius, double maxStep = 0.03);

/// The same of a building: one floor a storey, from the lowest up. Storeys are floors that lie 1.5 m and more
/// above each other; where one has a hole, its squares are those of what is seen through it.
[[nodiscard]] std::vector<ReachableFloor> reachableStoreys(const Arena& arena, double radius,
                                                           double maxStep = 0.03);

/// The place before a victim where robots get to it, in the arena's frame: @p distance from its side [m].
[[nodiscard]] Eigen::Vector2d placeBefore(const Element& victim, double distance);
/// Whether @p floor comes near to @p victim: so near that a robot can stop 0.8 m before it and see it.
[[nodiscard]] bool reaches(const ReachableFloor& floor, const Element& victim);

}  // namespace leitstand::simulation
