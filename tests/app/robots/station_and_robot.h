#pragma once

#include <chrono>
#include <memory>
#include <string>
#include <thread>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "tests/app/robots/held_station.h"
#include "tests/support/temporary_folder.h"

namespace leitstand::test {

/// Kurt3D in a hall of its own, and a station that drives it and never lets its stick go.
class StationAndRobot : public testing::Test {
protected:
    static constexpr double Speed = 0.2;  ///< [m/s]

    StationAndRobot() { writeText(m_folder / "hall.yaml", hallFile("hall")); }
    /// @p more: as of leitstand-robot.
    void startRobot(std::vector<std::string> more = {}) {
        more.insert(more.end(), {"--arena", (m_folder / "hall.yaml").string(), "--interface", "lo"});
        m_robot = std::make_unique<RobotProcess>(m_domain, "kurt3d", std::move(more));
    }
    /// @p more: as of held_station.
    void startStation(std::vector<std::string> more) {
        m_station = std::make_unique<HeldStation>(m_folder.path(), m_domain, Speed, std::move(more));
    }
    /// The robot drives at speed, by station and truth.
    [[nodiscard]] bool drives() const {
        return m_station->drives() &&
               waitUntil([this] { return m_truth.now() > 0.9 * Speed; }, std::chrono::seconds(10));
    }
    /// How long the robot drove on after the station got the signal @p number [s].
    [[nodiscard]] double standsAfter(int number) const {
        const Time gone = TrueSpeed::Clock::now();
        m_station->signal(number);
        EXPECT_TRUE(waitUntil([&] { return m_truth.stoodAfter(gone).has_value(); }, std::chrono::seconds(10)))
            << "it goes on";
        // For good: nothing that was on its way moves it again.
        std::this_thread::sleep_for(std::chrono::milliseconds(300));
        return m_truth.stoodAfter(gone).value_or(99.0);
    }
    /// For failures.
    [[nodiscard]] std::string words() const { return m_station->out() + m_robot->out(); }

    const TestDomain m_domain;
    const TemporaryFolder m_folder;
    const TrueSpeed m_truth{m_domain, "hall"};
    std::unique_ptr<RobotProcess> m_robot;
    std::unique_ptr<HeldStation> m_station;
};

}  // namespace leitstand::test
