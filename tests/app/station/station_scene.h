#pragma once

#include <memory>
#include <mutex>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "app/session/station/station.h"
#include "core/io/robot/robot_file.h"
#include "tests/support/child_process.h"
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
    [[nodiscard]] std::unique_ptr<Station> stationFor(std::vector<RobotDescription> robots) {
        StationListener listener;
        listener.onMessage = [this](const std::string& text) {
            const std::scoped_lock lock(m_mutex);
            m_words += text + "\n";
        };
        return must(Station::open(settingsFor(std::move(robots)), std::move(listener)));
    }
    [[nodiscard]] std::string words() const {
        const std::scoped_lock lock(m_mutex);
        return m_words;
    }
    /// The robot's file that comes with the program.
    [[nodiscard]] static RobotDescription kurt3d() {
        return must(readRobot(std::string(LEITSTAND_SOURCE_DIR) + "/resources/robots/kurt3d.yaml"));
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
