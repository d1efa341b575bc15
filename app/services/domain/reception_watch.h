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

/// What a ReceptionWatch works with; its functions are called on the watch's own thread.
struct ReceptionWatchSetup {
    std::vector<RobotDescription> robots;
    std::function<LinkState(const std::string& robot)> link;
    std::function<bool()> mayRejoin;  ///< whether this process neither moves nor stops any robot
    std::function<void(const Guid&)> onRejoining =
        {};  ///< with the new guid() of the node, as of Node::rejoin()
    std::function<void(const std::string&)> notify;  ///< for the operator, in words
};

/// Watches whether the topics that robots announce are received, and makes the node join its domain again
/// where they are not. Any thread.
class ReceptionWatch {
public:
    /// @p node must outlive the watch.
    ReceptionWatch(Node& node, ReceptionWatchSetup setup);
    ~ReceptionWatch();
    ReceptionWatch(const ReceptionWatch&) = delete;
    ReceptionWatch& operator=(const ReceptionWatch&) = delete;

    /// Returns what @p robot announces and the node does not receive; empty: nothing is missing.
    [[nodiscard]] std::optional<ReceptionFault> fault(const std::string& robot) const;

private:
    void run(const std::stop_token& stop);
    void look();
    void notify(const std::string& words, const RobotDescription& robot, const ReceptionFault& fault);

    Node& m_node;
    const ReceptionWatchSetup m_setup;
    std::map<std::string, RejoinPlan> m_plans;  ///< by robot; used by the thread only
    mutable std::mutex m_mutex;                 ///< guards the faults
    struct Standing {
        ReceptionFault fault;
        SteadyTime newest;
    };
    std::map<std::string, Standing> m_faults;  ///< by robot
    std::jthread m_thread;                     ///< last: joined first
};

}  // namespace leitstand
