#pragma once

#include <functional>
#include <map>
#include <mutex>
#include <optional>
#include <string>
#include <thread>
#include <vector>

#include "core/robot/link/hearing.h"
#include "core/robot/robot_description.h"
#include "transport/dds/node.h"

namespace leitstand {

/// What a watch queries and whom it notifies; all are called on its own thread.
struct HearingWatchSetup {
    std::vector<RobotDescription> robots;
    std::function<LinkState(const std::string& robot)> link;
    std::function<bool()> mayRejoin;  ///< nothing moves by this process, and nothing is being stopped
    std::function<void(const Guid&)> onRejoining = {};  ///< the node's new guid(), as of Node::rejoin()
    std::function<void(const std::string&)> tell;       ///< for the operator, in words
};

/// Watches whether the topics that robots announce are received, and makes the node join its domain again
/// where they are not. Any thread.
class HearingWatch {
public:
    /// @p node outlives it.
    HearingWatch(Node& node, HearingWatchSetup setup);
    ~HearingWatch();
    HearingWatch(const HearingWatch&) = delete;
    HearingWatch& operator=(const HearingWatch&) = delete;

    /// What @p robot announces but the node does not receive; empty: no fault.
    [[nodiscard]] std::optional<HearingFault> fault(const std::string& robot) const;

private:
    void run(const std::stop_token& stop);
    void look();
    void tell(const std::string& words, const RobotDescription& robot, const HearingFault& fault);

    Node& m_node;
    const HearingWatchSetup m_setup;
    std::map<std::string, RejoinPlan> m_plans;  ///< by robot; of its own thread
    mutable std::mutex m_mutex;                 ///< guards the faults
    struct Standing {
        HearingFault fault;
        SteadyTime newest;
    };
    std::map<std::string, Standing> m_faults;  ///< by robot
    std::jthread m_thread;                     ///< last: joined first
};

}  // namespace leitstand
