#pragma once

#include <condition_variable>
#include <cstddef>
#include <functional>
#include <map>
#include <mutex>
#include <optional>
#include <string>
#include <thread>
#include <utility>
#include <vector>

#include "app/services/log/event_sink.h"
#include "core/base/result.h"
#include "core/event/sample.h"
#include "core/robot/joints/joint_control.h"
#include "core/robot/robot_description.h"

namespace leitstand {

struct Event;

/// Moves joints of robots by their groups: flippers, arms. That belongs to driving: it needs the same grant,
/// and STOP ends it. Sends from its own thread, so that nothing in a window
/// delays the end of a motion. Any thread; no call waits for the network.
class JointMoving : public EventSink {
public:
    /// Functions of the station that it uses. They are called without a lock that its other calls need.
    struct Wire {
        std::function<JointConditions(const std::string& robot)> conditions;
        std::function<Result<void>(const std::string& robot, const JointGroup& group,
                                   const JointSetpoints& setpoints)>
            send;
        std::function<void(const std::string& text)> notify;
    };
    JointMoving(const std::vector<RobotDescription>& robots, Wire wire);
    ~JointMoving() override;
    JointMoving(const JointMoving&) = delete;
    JointMoving& operator=(const JointMoving&) = delete;

    void onEvent(const Event& event) override;  ///< takes joint states; ignores other events

    /// Empty: @p robot has no such group.
    [[nodiscard]] std::optional<JointGroupView> view(const std::string& robot,
                                                     const std::string& group) const;

    // Requests of the operator; without effect on what is not there.
    /// As JointControl::move(): renew it at least ten times a second, also when the control is at rest.
    void move(const std::string& robot, const std::string& group, std::size_t axis, double share);
    void goTo(const std::string& robot, const std::string& group, std::size_t preset);
    void halt(const std::string& robot);  ///< ends all motions of the robot's joints
    /// Whether a joint of the robot moves, or the end of its motion is not all said yet.
    [[nodiscard]] bool isMoving(const std::string& robot) const;
    /// Ends all motions for good: nothing is sent any more when it returns.
    void end();

private:
    using Key = std::pair<std::string, std::string>;  ///< robot, group
    struct Part {
        JointControl control;
        bool failed = false;  ///< whether the present error was reported
    };
    void run(const std::stop_token& stop);
    void pulse();
    void report(const Key& key, const Result<void>& sent);

    const Wire m_wire;
    mutable std::mutex m_mutex;  ///< guards the parts
    std::map<Key, Part> m_parts;
    std::mutex m_waiting;
    std::condition_variable_any m_wake;
    std::jthread m_thread;  ///< the last member, so that it is joined first
};

}  // namespace leitstand
