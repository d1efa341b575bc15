#pragma once

#include <functional>
#include <map>
#include <mutex>
#include <optional>
#include <string>
#include <thread>
#include <vector>

#include "core/robot/link/reception.h"
#include "core/robot/robot_description.h"
#include "transport/dds/node.h"

namespace leitstand {

/// What a watch queries and whom it notifies; all are called on its own thread.
struct ReceptionWatchSetup {
    std::vector<RobotDescription> robots;
    std::function<LinkState(const std::string& robot)> link;
    std::function<bool()> mayRejoin;  ///< nothing moves by this process, and nothing is being stopped
    std::function<void(const Guid&)> onRejoining = {};  ///< the node's new guid(), as of Node::rejoin()
    std::function<void(const std::string&)> notify;     ///< for the operator, in words
};

/// Watches whether the topics that robots announce are received, and makes the node join its domain again
/// where they are not. Any thread.
class ReceptionWatch {
public:
    /// @p node outlives it.
    ReceptionWatch(Node& node, ReceptionWatchSetup setup);
    ~ReceptionWatch();
    ReceptionWatch(const ReceptionWatch&) = delete;
    ReceptionWatch& operator=(const ReceptionWatch&) = delete;

    /// What @p robot announces but the node does not receive; empty: no fault.
    [[nodiscard]] std::optional<ReceptionFault> fault(const std::string& robot) const;

private:
    void run(const std::stop_token& stop);
    void look();
    void notify(const std::string& words, const RobotDescription& robot, const ReceptionFault& fault);

    Node& m_node;
    const ReceptionWatchSetup m_setup;
    std::map<std::string, RejoinPlan> m_plans;  ///< by robot; of its own thread
    mutable std::mutex m_mutex;                 ///< guards the faults
    struct Standing {
        ReceptionFault fault;
        SteadyTime newest;
    };
    std::map<std::string, Standing> m_faults;  ///< by robot
    std::jthread m_thread;                     ///< last: joined first
};

}  // namespace leitstand
