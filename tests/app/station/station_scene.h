#pragma once

#include <chrono>
#include <functional>
#include <memory>
#include <mutex>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "app/services/station/station.h"
#include "core/event/event.h"
#include "core/io/robot/robot_file.h"
#include "tests/support/child_process.h"
#include "tests/support/places.h"
#include "tests/support/temporary_folder.h"
#include "tests/support/wait.h"
#include "tests/transport/dds/test_node.h"

namespace leitstand::test {

/// Stations in a domain of the test's own, and what they said.
class StationScene : public testing::Test {
protected:
    [[nodiscard]] StationSettings settingsFor(std::vector<RobotDescription> robots,
                                              const std::string& name = "station") const {
        StationSettings settings;
        settings.domain.domain = m_domain.number();
        settings.mission.folder = m_folder / (name + "-mission");
        settings.mission.robots = std::move(robots);
        settings.mission.title = "Test desk";
        settings.mission.version = "test";
        settings.memory = m_folder / (name + ".yaml");
        return settings;
    }
    [[nodiscard]] std::unique_ptr<Station> stationFor(std::vector<RobotDescription> robots,
                                                      const std::string& name = "station",
                                                      std::function<void(const Event&)> onEvent = {}) {
        StationListener listener;
        listener.onEvent = std::move(onEvent);
        listener.onMessage = [this](const std::string& text) {
            const std::scoped_lock lock(m_mutex);
            m_words += text + "\n";
        };
        return must(Station::open(settingsFor(std::move(robots), name), std::move(listener)));
    }
    [[nodiscard]] std::string words() const {
        const std::scoped_lock lock(m_mutex);
        return m_words;
    }
    /// Asks for the grant, takes the sticks and pushes them until @p moved holds: neutral for a moment first,
    /// and again when that did not help, as an operator would.
    template <class Moved>
    [[nodiscard]] static bool drive(Station& station, const std::string& robot, const DriveVelocity& sticks,
                                    Moved moved) {
        using namespace std::chrono_literals;
        using Clock = std::chrono::steady_clock;
        station.requestGrant(robot);
        station.setDriveFocus(robot);
        auto neutral = Clock::now();
        return waitUntil([&] {
            const DriveView now = station.robot(robot).drive;
            const auto held = Clock::now() - neutral;
            if (!now.listening || now.needsNeutral || held > 2s) neutral = Clock::now();
            station.setStick(held > 200ms && held < 2s ? sticks : DriveVelocity{});
            return moved();
        });
    }
    /// The robot's file that comes with the program.
    [[nodiscard]] static RobotDescription kurt3d() {
        return must(readRobot(sourceFolder() + "/resources/robots/kurt3d.yaml"));
    }
    /// Of leitstand-robot, for this domain.
    [[nodiscard]] std::vector<std::string> kurtArguments() const {
        return {"kurt3d", "--arena", "yellow", "--seed", "7", "--domain", std::to_string(m_domain.number())};
    }

    const TestDomain m_domain;
    const TemporaryFolder m_folder;

private:
    mutable std::mutex m_mutex;
    std::string m_words;
};

}  // namespace leitstand::test
