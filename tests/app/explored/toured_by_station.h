#pragma once

#include <chrono>
#include <string>

#include "app/services/station/station.h"
#include "tests/app/explored/arena_truth.h"
#include "tests/simulation/mapping/toured_robot.h"

namespace leitstand::test {

/// A robot on its tour that a station sends and drives. The sticks are one robot's at a time.
class TouredByStation : public simulation::test::TouredRobot {
public:
    TouredByStation(Station& station, const ArenaTruth& truth, std::string robot);

    [[nodiscard]] double seconds() const override;
    [[nodiscard]] Pose baseInArena() const override;
    [[nodiscard]] ModeSample mode() const override;
    void ask(const std::string& mode) override;
    void send(const Eigen::Vector3d& inBase) override;
    bool take() override;
    void drive(double forward, double turn) override;
    void release() override;

private:
    Station& m_station;
    const ArenaTruth& m_truth;
    std::string m_robot;
    std::chrono::steady_clock::time_point m_began = std::chrono::steady_clock::now();
};

}  // namespace leitstand::test
