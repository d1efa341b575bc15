// held_station FOLDER DOMAIN ROBOT SPEED [--blind] [--nevertheless]
//     an operator's station that drives a shipped robot ahead at SPEED m/s and never lets the stick go by
//     itself; says "drives" once the robot does. SIGUSR1: the stick is let go for a moment, then pulled the
//     other way, and "drives" is said again. --blind: the station knows of no camera and no scanner, so that
//     nothing caps the speed.
//     --nevertheless: the robot is driven although it failed its brake test. Says "guard failed" when it has
//     none.
// Runs until it is killed.
#include <algorithm>
#include <chrono>
#include <csignal>
#include <cstdio>
#include <filesystem>
#include <string>
#include <thread>
#include <utility>
#include <vector>

#include "app/services/station/safety/station_brakes.h"
#include "app/services/station/safety/station_guards.h"
#include "app/services/station/station.h"
#include "core/event/motion_samples.h"
#include "core/event/stream_role.h"
#include "core/io/robot/robot_file.h"
#include "core/mission/state/mission_state.h"
#include "tests/support/places.h"

namespace {

using namespace leitstand;
using namespace std::chrono_literals;
using Clock = std::chrono::steady_clock;

volatile std::sig_atomic_t turned = 0;

RobotDescription describe(const std::string& name, bool blind) {
    RobotDescription robot =
        readRobot(leitstand::test::sourceFolder() + "/resources/robots/" + name + ".yaml").value();
    if (blind) {
        std::erase_if(robot.streams, [](const StreamDescription& stream) {
            return stream.role == StreamRole::Picture || stream.role == StreamRole::Thermal ||
                   stream.role == StreamRole::CameraInfo || stream.role == StreamRole::Points ||
                   stream.role == StreamRole::Ranges;
        });
    }
    return robot;
}

/// The hand at the stick.
class Hand {
public:
    Hand(Station& station, std::string robot, double speed)
        : m_station(station), m_robot(std::move(robot)), m_speed(speed) {}

    void move() {
        const auto now = Clock::now();
        if (turned != 0) {
            turned = 0;
            m_speed = -m_speed;
            m_drives = false;
            m_neutralSince = now;
        }
        m_station.setStick({isNeutral(now) ? 0.0 : m_speed, 0.0, 0.0});
        if (m_drives || !moves()) return;
        m_drives = true;
        std::puts("drives");
        std::fflush(stdout);
    }

private:
    /// Until the robot drives, an operator whose robot does not answer lets go and tries again. Then never.
    [[nodiscard]] bool isNeutral(Clock::time_point now) {
        if (m_drives) return false;
        const DriveView view = m_station.robot(m_robot).drive;
        const bool ready = view.driving && view.listening && !view.needsNeutral;
        if (!ready || now - m_neutralSince > 3s) m_neutralSince = now;
        return now - m_neutralSince < 300ms;
    }
    [[nodiscard]] bool moves() const {
        const auto state = m_station.mission();
        const auto robot = state->robots.find(m_robot);
        return robot != state->robots.end() && robot->second->odometry &&
               robot->second->odometry->sample.linear.x() / m_speed > 0.9;
    }

    Station& m_station;
    const std::string m_robot;
    double m_speed;
    bool m_drives = false;
    Clock::time_point m_neutralSince = Clock::now();
};

}  // namespace

int main(int argc, char** argv) {
    const std::vector<std::string> words(argv + 1, argv + argc);
    if (words.size() < 4) return 2;
    const auto says = [&](const char* word) { return std::count(words.begin(), words.end(), word) > 0; };
    std::signal(SIGUSR1, [](int) { turned = 1; });
    const std::filesystem::path folder = words[0];
    StationSettings settings;
    settings.domain.domain = std::stoi(words[1]);
    settings.domain.interfaces = {"lo"};
    settings.mission.folder = folder / "mission";
    settings.mission.robots = {describe(words[2], says("--blind"))};
    settings.mission.title = "Held desk";
    settings.memory = folder / "station.yaml";
    StationListener listener;
    listener.onMessage = [](const std::string& text) { std::fprintf(stderr, "%s\n", text.c_str()); };
    auto station = Station::open(settings, listener);
    if (!station) return std::puts(station.error().text.c_str()), 1;
    if (says("--nevertheless")) (*station)->brakes().setOverridden(words[2], true);
    (*station)->requestGrant(words[2]);
    (*station)->setDriveFocus(words[2]);
    Hand hand(**station, words[2], std::stod(words[3]));
    bool failed = false;
    for (auto next = Clock::now();; next += 20ms) {
        hand.move();
        const GuardView guard = (*station)->guards().view(words[2]);
        if (guard.state == GuardView::State::Failed && !std::exchange(failed, true))
            std::fprintf(stderr, "guard failed: %s\n", guard.problem.c_str());
        next = std::max(next, Clock::now() - 20ms);
        std::this_thread::sleep_until(next);
    }
}
