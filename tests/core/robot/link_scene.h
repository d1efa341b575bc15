#pragma once

#include <cstdint>
#include <map>
#include <random>
#include <string>
#include <vector>

#include "core/event/status_samples.h"
#include "core/event/stream_role.h"
#include "core/robot/link/link_monitor.h"

namespace leitstand::test {

/// A robot "kurt3d" with steady streams (odometry 20 Hz, points 10 Hz, left pictures 5 Hz, gas 1 Hz), a mode
/// said once, and a shared /diagnostics; with @p pong one that answers pings.
[[nodiscard]] RobotDescription linkedRobot(bool pong = true);

/// What the air and the robot do to one stream.
struct SceneStream {
    StreamRole role = StreamRole::Odometry;
    std::string topic;
    double rate = 0.0;           ///< [Hz]
    bool silent = false;         ///< its writer says nothing
    double loss = 0.0;           ///< share that gets lost
    double delay = 0.02;         ///< [s]
    std::uint64_t reported = 0;  ///< since the robot started
    double clockError = 0.0;     ///< of the computer that writes it, against the robot's [s]
    double lastArrival = 0.0;    ///< nothing overtakes [s]
    double next = 0.0;           ///< when it is said [s]
};

/// A LinkMonitor and a robot in simulated time.
class LinkScene {
public:
    explicit LinkScene(bool pong = true, unsigned seed = 1);

    std::map<std::string, SceneStream>
        streams;              ///< by the end of their topic: "odom", "points", "left", "co2"
    bool radio = true;        ///< false: nothing gets through, either way
    bool on = true;           ///< false: the robot is off
    bool answers = true;      ///< pings
    double roundTrip = 0.04;  ///< [s]
    double ahead = 5.0;       ///< robot's clock minus station's [s]
    LinkMonitor monitor;

    /// Lets @p seconds pass, in steps of 10 ms; the status is asked ten times a second.
    void run(double seconds);
    void restartRobot();                      ///< other writers, numbers from 1
    void publish(const std::string& stream);  ///< one sample, now
    [[nodiscard]] LinkStatus status() { return monitor.status(steadyNow()); }
    [[nodiscard]] SteadyTime steadyNow() const;
    /// States since the beginning, one after the other: "never seen", "connected".
    [[nodiscard]] const std::vector<std::string>& states() const { return m_states; }
    void forgetStates() { m_states.clear(); }
    /// Seconds from @p begin until a state was entered for the last time.
    [[nodiscard]] double now() const { return m_now; }
    [[nodiscard]] double changedAt() const { return m_changedAt; }

private:
    struct Answer {
        double arrival = 0.0;
        PongSample pong;
    };
    [[nodiscard]] Time day(double t) const;
    void step();

    std::mt19937 m_random;
    double m_now = 0.0, m_changedAt = 0.0, m_nextPing = 0.0;
    int m_steps = 0;
    std::uint64_t m_ping = 0, m_pongSequence = 0;
    std::uint8_t m_generation = 1;
    std::vector<Answer> m_answers;
    struct OnTheWay {
        double arrival = 0.0;
        std::string topic;
        StreamArrival sample;
    };
    std::vector<OnTheWay> m_air;
    std::vector<std::string> m_states;
};

}  // namespace leitstand::test
