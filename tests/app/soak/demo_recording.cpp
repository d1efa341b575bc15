#include "tests/app/soak/demo_recording.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>
#include <string>
#include <utility>

#include <fmt/format.h>

#include "app/services/station/station.h"
#include "core/event/motion_samples.h"
#include "core/event/status_samples.h"
#include "core/mission/state/mission_state.h"
#include "core/mission/state/robot_state.h"
#include "tests/app/robots/robot_process.h"
#include "tests/support/dds/test_domain.h"
#include "tests/support/temporary_folder.h"
#include "tests/support/wait.h"
#include "tests/transport/dds/test_node.h"

namespace leitstand::test {
namespace {

using namespace std::chrono_literals;
using Clock = std::chrono::steady_clock;

constexpr double Near = 0.5;                  ///< of where it began [m]
constexpr std::chrono::seconds ToAndFro(5);   ///< of the Crawler, one way
constexpr std::chrono::seconds WayBack(300);  ///< at most
constexpr double Away = 1.0;                  ///< from where it began, at least [m]
constexpr std::chrono::seconds WayAway(300);  ///< at most, where a victim holds it up
constexpr std::chrono::seconds Again(15);     ///< until it is asked again
constexpr double Gently = 0.1;                ///< [m/s]
constexpr double Turn = 0.4;                  ///< [rad/s]
constexpr double Aligned = 0.1;               ///< with how it stood at first [rad]
constexpr std::chrono::seconds Stuck(4);      ///< a turn that gets nowhere for so long is blocked
constexpr std::chrono::seconds Pull(3);       ///< away from what blocks it

/// Where @p robot is by its odometry; the origin before it said so.
Pose placeOf(const Station& station, const std::string& robot) {
    const auto mission = station.mission();
    const auto reported = mission->robots.find(robot);
    const bool known = reported != mission->robots.end() && reported->second->odometry;
    return known ? reported->second->odometry->sample.baseInOdom : Pose::Identity();
}

/// What Kurt3D does, and why.
std::string doing(const Station& station) {
    const auto mode = station.mission()->robots.at("kurt3d")->mode;
    return mode ? mode->sample.mode + ": " + mode->sample.reason : "nobody knows what";
}

/// Holds the Crawler's sticks until @p ended, or until @p until.
template <class Ended>
void rock(Station& station, Clock::time_point until, Ended ended) {
    const auto began = Clock::now();
    (void)waitUntil(
        [&] {
            const auto way = (Clock::now() - began) / ToAndFro;
            const DriveView crawler = station.robot("crawler").drive;
            const double speed = crawler.needsNeutral ? 0.0 : way % 2 == 0 ? Gently : -Gently;
            station.setStick({speed, 0.0, 0.0}, true);
            return ended();
        },
        std::chrono::duration_cast<std::chrono::milliseconds>(until - began));
}

/// How far Kurt3D's heading is from what it was at @p home, to the left [rad].
double headingError(const Station& station, const Pose& home) {
    const Pose off = home.inverse() * placeOf(station, "kurt3d");
    return std::atan2(off(1, 0), off(0, 0));
}

/// Where a robot that something blocks tries to go: it turns on the spot one way, then the other, and then
/// pulls forward or back a little, by turns, and turns again.
class WaysOut {
public:
    explicit WaysOut(double turn) : m_turn(turn) {}
    /// What it drives at @p now, given that it is @p error from where it is to head to.
    DriveVelocity next(double error, Clock::time_point now) {
        if (now - m_since > (m_pull == 0.0 ? Stuck : Pull)) {
            const bool blocked = std::abs(std::remainder(error - m_before, 2.0 * std::numbers::pi)) < Aligned;
            if (m_pull != 0.0) {
                m_pull = 0.0;
            } else if (blocked) {
                m_turn = -m_turn;
                if (++m_blocked % 2 == 0) m_pull = m_blocked % 4 == 0 ? -Gently : Gently;
            }
            hold(error, now);
        }
        return m_pull != 0.0 ? DriveVelocity{m_pull, 0.0, 0.0} : DriveVelocity{0.0, 0.0, m_turn};
    }
    /// It was not let drive until @p now.
    void hold(double error, Clock::time_point now) {
        m_before = error;
        m_since = now;
    }

private:
    double m_turn, m_pull = 0.0, m_before = 0.0;
    int m_blocked = 0;  ///< how often
    Clock::time_point m_since;
};

/// Turns Kurt3D until it heads as at @p home.
bool align(Station& station, const Pose& home) {
    station.setDriveFocus("kurt3d");
    if (!station.setMode("kurt3d", "teleoperation")) return false;
    const double first = headingError(station, home);
    WaysOut ways(first > 0.0 ? -Turn : Turn);
    ways.hold(first, Clock::now());
    const bool aligned = waitUntil(
        [&] {
            const double error = headingError(station, home);
            const auto now = Clock::now();
            const bool wait = station.robot("kurt3d").drive.needsNeutral;
            if (wait) ways.hold(error, now);
            station.setStick(wait ? DriveVelocity{} : ways.next(error, now), true);
            return std::abs(error) < Aligned;
        },
        120s);
    station.setStick({});
    return aligned;
}

}  // namespace

void recordDemo(const std::filesystem::path& folder, std::chrono::seconds length) {
    const TestDomain domain;
    const TemporaryFolder memory;
    StationSettings settings;
    settings.domain.domain = domain.number();
    settings.mission.folder = folder;
    settings.mission.robots = {shippedRobot("kurt3d"), shippedRobot("crawler")};
    settings.memory = memory / "station.yaml";
    RobotProcess kurt(domain, "kurt3d", {"--arena", "yellow", "--seed", "7"});
    RobotProcess crawler(domain, "crawler", {"--arena", "yellow", "--seed", "7"});
    const auto station = must(Station::open(settings));
    for (const std::string robot : {"kurt3d", "crawler"}) {
        const bool there = waitUntil(
            [&] {
                station->requestGrant(robot);
                return station->robot(robot).grant.mine &&
                       station->robot(robot).link.state == LinkState::Connected;
            },
            60s);
        if (!there) throw std::runtime_error(robot + " is not there");
    }
    const Pose home = placeOf(*station, "kurt3d");
    const auto away = [&] { return (placeOf(*station, "kurt3d").translation() - home.translation()).norm(); };
    station->setDriveFocus("crawler");
    double farthest = 0.0;
    auto asked = Clock::time_point{};
    const auto isDue = [&] {  // what it sees on its way may be more important to it
        const bool due = Clock::now() - asked > Again;
        if (due) asked = Clock::now();
        return due;
    };
    const auto leave = Clock::now() + length / 2;
    rock(*station, Clock::now() + WayAway, [&] {
        if (isDue()) (void)station->setMode("kurt3d", "explore");
        farthest = std::max(farthest, away());
        return farthest >= Away && Clock::now() >= leave;
    });
    if (farthest < Away) throw std::runtime_error("kurt3d did not explore; it does " + doing(*station));
    PoseSample goal;
    goal.header.frame = shippedRobot("kurt3d").odomFrame;
    goal.poseInFrame = home;
    asked = {};
    rock(*station, Clock::now() + WayBack, [&] {
        if (isDue()) {
            (void)station->goTo("kurt3d", goal);
            (void)station->setMode("kurt3d", "explore");
        }
        return away() < Near;
    });
    if (away() >= Near)
        throw std::runtime_error(fmt::format("kurt3d is {:.1f} m from where it began, was {:.1f}: {}", away(),
                                             farthest, doing(*station)));
    if (!align(*station, home))
        throw std::runtime_error(fmt::format("kurt3d did not turn back, it is {:.0f} degrees off: {}",
                                             inDegrees(headingError(*station, home)), doing(*station)));
}

}  // namespace leitstand::test
