#pragma once

#include <functional>
#include <memory>
#include <string>

#include "core/base/result.h"
#include "core/base/time.h"
#include "core/event/motion_samples.h"
#include "core/robot/services/goal_tracker.h"
#include "transport/dds/node.h"

namespace leitstand {

/// Sends a robot to places by the action of its own navigation (nav2_msgs/action/NavigateToPose), and follows
/// it there. Any thread; nothing waits for the network.
class NavigationClient {
public:
    /// @p name: ROS name of the action, "/navigate_to_pose". Errors name the topic that the node may not use.
    [[nodiscard]] static Result<std::unique_ptr<NavigationClient>> create(Node& node,
                                                                          const std::string& name);
    ~NavigationClient();
    NavigationClient(const NavigationClient&) = delete;
    NavigationClient& operator=(const NavigationClient&) = delete;

    /// Sends the robot to @p goal, in place of any goal before. Errors: nobody offers the action, or the goal
    /// is none.
    Result<void> go(const PoseSample& goal);
    /// Asks the robot to give up the newest goal; does nothing if that has ended.
    void cancel();
    [[nodiscard]] NavigationView view() const;

private:
    struct State;
    explicit NavigationClient(std::unique_ptr<State> state);
    std::unique_ptr<State> m_state;
};

}  // namespace leitstand
