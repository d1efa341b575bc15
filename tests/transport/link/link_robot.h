#pragma once

#include <atomic>
#include <chrono>
#include <cstdint>
#include <memory>
#include <string>
#include <thread>

#include "core/robot/robot_description.h"
#include "transport/dds/node.h"

namespace leitstand::test {

/// "kurt3d" with odometry, points, ping and pong as design section 4 has them.
[[nodiscard]] RobotDescription pingableRobot();

/// The other end of a link: says odometry at 20 Hz and answers pings, with a clock of its own.
class LinkRobot {
public:
    /// In the namespace of the calling thread. Throws when it cannot join.
    LinkRobot(int domain, const RobotDescription& robot);
    ~LinkRobot();
    LinkRobot(const LinkRobot&) = delete;
    LinkRobot& operator=(const LinkRobot&) = delete;

    void setAhead(std::chrono::nanoseconds ahead) {
        m_ahead = ahead.count();
    }                                                               ///< its clock minus the station's
    void setSpeaking(bool speaking) { m_speaking = speaking; }      ///< odometry
    void setAnswering(bool answering) { m_answering = answering; }  ///< pings
    void setGarbage(bool garbage) { m_garbage = garbage; }          ///< answers pings with nonsense
    [[nodiscard]] std::uint64_t pings() const { return m_pings; }
    [[nodiscard]] std::uint64_t lastPing() const { return m_lastPing; }  ///< its number

private:
    [[nodiscard]] Time clock() const;
    void answer(const ReceivedSample& sample);
    void speak(const std::stop_token& stop);

    RobotDescription m_robot;
    std::atomic<std::int64_t> m_ahead = 0;
    std::atomic<bool> m_speaking = true, m_answering = true, m_garbage = false;
    std::atomic<std::uint64_t> m_pings = 0, m_lastPing = 0;
    std::unique_ptr<Node> m_node;
    std::unique_ptr<Publisher> m_odometry, m_pong;
    std::unique_ptr<Subscription> m_ping;
    std::jthread m_thread;
};

}  // namespace leitstand::test
