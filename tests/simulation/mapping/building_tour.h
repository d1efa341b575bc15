#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "robots/simulation/arena/building_generator.h"
#include "tests/simulation/world/operated_robot.h"

namespace leitstand::simulation::test {

/// The rooms of all storeys, lowest first, each storey's in the order in which one passes them on the way
/// around the ring: before each, and after it, the place before it in the corridor, since nobody is sent
/// through walls that scanners do not see. The ramps between; arena's frame [m]. @p storeys: so many of them.
[[nodiscard]] std::vector<Eigen::Vector3d> roomsInOrder(const BuildingWays& ways, int storeys);

/// An operator who sends a robot through a building, from place to place as on a map. The robot finds its way
/// and drives by itself; where it stands before what it does not see (a black wall, one of glass), or its
/// wheels spin, it is pulled back by hand and sent on.
class BuildingTour {
public:
    BuildingTour(OperatedRobot& robot, std::vector<Eigen::Vector3d> places);

    /// Ten times a second. @p said: what the robot said since.
    void look(const std::vector<HardwareSample>& said);
    [[nodiscard]] bool isOver() const { return m_next >= m_places.size() && !m_goal; }
    [[nodiscard]] std::size_t reached() const { return m_reached; }
    [[nodiscard]] std::size_t pulledBack() const { return m_pulls; }
    [[nodiscard]] std::size_t places() const { return m_places.size(); }
    [[nodiscard]] std::string doing() const;  ///< for people

private:
    void send(double now);
    void ask(const std::string& mode);
    void pullBack(double now);

    OperatedRobot& m_robot;
    Sender m_station;
    std::vector<Eigen::Vector3d> m_places;
    std::size_t m_next = 0, m_reached = 0, m_pulls = 0;
    std::optional<Eigen::Vector3d> m_goal;
    int m_tries = 0;                    ///< of it
    double m_sent = 0.0;                ///< [s]
    double m_longest = 0.0;             ///< that the way to it may take [s]
    std::optional<double> m_pullUntil;  ///< [s]
    double m_movedAt = 0.0;             ///< [s]
    Eigen::Vector3d m_movedTo = Eigen::Vector3d::Zero();
    Pose m_baseInOdom = Pose::Identity();
    ModeSample m_mode;
};

}  // namespace leitstand::simulation::test
