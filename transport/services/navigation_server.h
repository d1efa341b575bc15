#pragma once

#include <functional>
#include <memory>
#include <span>
#include <string>

#include "core/base/result.h"
#include "transport/dds/node.h"
#include "transport/services/navigation_messages.h"

namespace leitstand {

/// Offers nav2_msgs/action/NavigateToPose as rmw_fastrtps does, without its results. For robots; a station
/// only asks. Any thread.
class NavigationServer {
public:
    /// Called on the node's thread for small samples.
    struct Calls {
        std::function<bool(const NavigationGoal&)> go;  ///< returns whether the goal is accepted
        /// Returns whether the goal is known and will be given up; a goal of zeros: all goals.
        std::function<bool(const GoalId&)> cancel;
    };
    [[nodiscard]] static Result<std::unique_ptr<NavigationServer>> create(Node& node, const std::string& name,
                                                                          Calls calls);
    ~NavigationServer();
    NavigationServer(const NavigationServer&) = delete;
    NavigationServer& operator=(const NavigationServer&) = delete;

    void report(std::span<const GoalTracker::Report> goals);
    void progress(const NavigationProgress& progress);

private:
    struct State;
    explicit NavigationServer(std::unique_ptr<State> state);
    std::unique_ptr<State> m_state;
};

}  // namespace leitstand
