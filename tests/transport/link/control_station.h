#pragma once

#include <atomic>
#include <chrono>
#include <memory>
#include <string>
#include <thread>
#include <utility>
#include <vector>

#include "tests/transport/dds/test_node.h"
#include "transport/link/drive_streamer.h"
#include "transport/link/grant_keeper.h"
#include "transport/link/stop_sender.h"

namespace leitstand::test {

/// A station that drives one robot: grants, streamer and stop as the session has them, and an operator whose
/// stick is told at 50 Hz.
class ControlStation {
public:
    ControlStation(Node& node, const RobotDescription& robot, StationIdentity me = {"a", "Left desk", {}})
        : m_robot(robot.name), m_keeper(must(GrantKeeper::create(node, me))) {
        StopSenderSettings stops;
        stops.station = me.id;
        stops.mayRelease = [this](const std::string& name) { return m_keeper->mayAct(driveGrant(name)); };
        m_stops = must(StopSender::create(node, std::vector{robot}, stops));
        DriveStreamerSettings driving;
        driving.conditions = [this] {
            return DriveConditions{m_keeper->mayAct(driveGrant(m_robot)) && m_stops->allowsDriving(m_robot),
                                   m_stops->holdsByZeros(m_robot)};
        };
        m_streamer = must(DriveStreamer::create(node, robot, driving));
        m_hand = std::jthread([this](const std::stop_token& stop) {
            auto next = std::chrono::steady_clock::now();
            while (!stop.stop_requested()) {
                if (m_holding) m_streamer->set({m_stick, 0.0, 0.0});
                next += std::chrono::milliseconds(20);
                std::this_thread::sleep_until(next);
            }
        });
    }
    void ask() { m_keeper->requestGrant(driveGrant(m_robot)); }
    void push(double speed) { m_stick = speed; }  ///< the stick
    void letGo() { m_holding = false; }           ///< the window hangs: nothing is told any more
    void focus(bool on = true) { m_streamer->setFocus(on); }
    [[nodiscard]] bool mayDrive() const { return m_keeper->mayAct(driveGrant(m_robot)); }
    [[nodiscard]] GrantView view() const { return m_keeper->view(driveGrant(m_robot)); }
    [[nodiscard]] StopStatus stopStatus() const { return m_stops->status(m_robot); }
    [[nodiscard]] GrantKeeper& keeper() { return *m_keeper; }
    [[nodiscard]] DriveStreamer& streamer() { return *m_streamer; }
    [[nodiscard]] StopSender& stops() { return *m_stops; }
    /// Focus, stick neutral, and then pushed until @p moves holds; tried again as an operator would whose
    /// robot was not there yet, and has to see neutral sticks first.
    template <class Moves>
    [[nodiscard]] bool driveUntil(double speed, Moves moves) {
        focus();
        for (int attempt = 0; attempt < 10; ++attempt) {
            push(0.0);
            const auto before = m_streamer->status().sent;
            const bool neutral = waitUntil([&] {
                const DriveStatus status = m_streamer->status();
                return status.driving && !status.needsNeutral && status.listeners > 0 &&
                       status.sent > before + 1;
            });
            if (!neutral) return false;
            push(speed);
            if (waitUntil(moves, std::chrono::seconds(1))) return true;
        }
        return false;
    }

private:
    std::string m_robot;
    std::atomic<double> m_stick = 0.0;
    std::atomic<bool> m_holding = true;
    std::unique_ptr<GrantKeeper> m_keeper;
    std::unique_ptr<StopSender> m_stops;
    std::unique_ptr<DriveStreamer> m_streamer;
    std::jthread m_hand;  ///< last: joined first
};

}  // namespace leitstand::test
