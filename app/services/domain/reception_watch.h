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

/// What a ReceptionWatch needs. Its functions are called on the watch's own thread.
struct ReceptionWatchSetup {
    std::vector<RobotDescription> robots;
    std::function<LinkState(const std::string& robot)> link;
    std::function<bool()> mayRejoin;  ///< returns whether this process neither moves nor stops any robot
    std::function<void(const Guid&)> onRejoining =
        {};  ///< called with the new guid() of the node, see Node::rejoin()
    std::function<void(const std::string&)> notify;  ///< called with a text for the operator
};

/// Observes whether the topics that robots announce are received. If not, makes the node join its domain
/// again. Any thread.
class ReceptionWatch {
public:
    /// @p node must outlive this object.
    ReceptionWatch(Node& node, ReceptionWatchSetup setup);
    ~ReceptionWatch();
    ReceptionWatch(const ReceptionWatch&) = delete;
    ReceptionWatch& operator=(const ReceptionWatch&) = delete;

    /// Returns what @p robot announces but the node does not receive; empty: everything is received.
    [[nodiscard]] std::optional<ReceptionFault> fault(const std::string& robot) const;

private:
    void run(const std::stop_token& stop);
    void look();
    void notify(const std::string& words, const RobotDescription& robot, const ReceptionFault& fault);

    Node& m_node;
    const ReceptionWatchSetup m_setup;
    std::map<std::string, RejoinPlan> m_plans;  ///< by robot; used only by the thread
    mutable std::mutex m_mutex;                 ///< guards the faults
    struct Standing {
        ReceptionFault fault;
        SteadyTime newest;
    };
    std::map<std::string, Standing> m_faults;  ///< by robot
    std::jthread m_thread;                     ///< the last member, so that it is joined first
};

}  // namespace leitstand
