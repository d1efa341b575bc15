#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "robots/simulation/arena/building_generator.h"
#include "tests/simulation/mapping/toured_robot.h"

namespace leitstand::simulation::test {

/// The rooms of all storeys, lowest first, each storey's in the order in which one passes them on the way
/// around the ring: before each, and after it, the place in the corridor before its door, since nobody is
/// sent through walls that scanners do not see. The ramps between; arena's frame [m]. @p storeys: so many.
[[nodiscard]] std::vector<Eigen::Vector3d> roomsInOrder(const Building& building, int storeys);

/// An operator who sends a robot through a building, from place to place as on a map. The robot finds its way
/// and drives by itself; where it stands before what it does not see (a black wall, one of glass), or its
/// wheels spin, it is pulled back by hand and sent on. What it looks at by itself, a body, it may.
class BuildingTour {
public:
    BuildingTour(TouredRobot& robot, std::vector<Eigen::Vector3d> places);

    void look();  ///< ten times a second
    [[nodiscard]] bool isOver() const { return m_next >= m_places.size() && !m_goal; }
    [[nodiscard]] std::size_t reached() const { return m_reached; }
    [[nodiscard]] std::size_t pulledBack() const { return m_pulled; }
    [[nodiscard]] std::size_t places() const { return m_places.size(); }
    [[nodiscard]] std::string doing() const;  ///< for people

private:
    void send(double now);
    void pullBack(double now);
    bool isPulled(const Pose& here, double now);  ///< far enough, or for long enough
    bool approaches(double now);                  ///< a body, and is let

    TouredRobot& m_robot;
    std::vector<Eigen::Vector3d> m_places;
    std::size_t m_next = 0, m_reached = 0, m_pulled = 0;
    std::optional<Eigen::Vector3d> m_goal;
    int m_tries = 0;                      ///< of it
    double m_sent = 0.0;                  ///< [s]
    double m_longest = 0.0;               ///< that the way to it may take [s]
    bool m_pulls = false;                 ///< it is pulled back, or waits for the sticks
    std::optional<double> m_pulledSince;  ///< [s]
    Eigen::Vector3d m_pulledFrom = Eigen::Vector3d::Zero();
    bool m_wriggles = false;               ///< it did not come back when it was pulled last
    std::vector<Eigen::Vector3d> m_trail;  ///< where it came from, newest last
    double m_movedAt = 0.0;                ///< [s]
    std::optional<double> m_approaches;    ///< since then [s]
    Eigen::Vector3d m_movedTo = Eigen::Vector3d::Zero();
};

}  // namespace leitstand::simulation::test
