#pragma once

#include <string>
#include <vector>

#include "robots/simulation/arena/reachable_floor.h"
#include "robots/simulation/world/world.h"

namespace leitstand::simulation::test {

/// How much of the floor that a round robot of 0.5 m gets to has been seen. A square of 5 cm counts when the
/// robot's middle came over it, or when its middle was in sight: a straight line of at most 3 m from the
/// scanner's head, 0.48 m above the robot's ground (or another eye), to the floor there meets nothing
/// (curtains, paper and foil neither). That is looked up once for every turn of the scanner (2.3 s), from
/// where the robot is then.
class SeenFloor {
public:
    explicit SeenFloor(const World& world, double eye = 0.48);
    /// ... of @p floor, one of reachableStoreys(): looked at while the robot is on that storey.
    SeenFloor(const World& world, ReachableFloor floor, double eye = 0.48);

    /// To be called often: looks when a turn of the scanner is over.
    void look(int robot);
    [[nodiscard]] double share() const;  ///< of the reachable floor, 0 to 1
    [[nodiscard]] double area() const { return share() * m_reachable.area(); }  ///< [m2]
    [[nodiscard]] const ReachableFloor& reachable() const { return m_reachable; }
    [[nodiscard]] bool isSeen(int column, int row) const;
    /// The arena from above for people, 10 cm a letter: '.' seen, 'o' reachable and not seen, '#' what cannot
    /// be reached, 'V' victims.
    [[nodiscard]] std::vector<std::string> picture() const;

private:
    const World& m_world;
    double m_eye;  ///< over the robot's ground [m]
    ReachableFloor m_reachable;
    std::vector<char> m_seen;
    double m_lookedAt = -10.0;  ///< [s]
};

}  // namespace leitstand::simulation::test
