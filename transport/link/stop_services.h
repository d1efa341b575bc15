#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "core/base/time.h"
#include "core/robot/control/stop/stop_status.h"
#include "core/robot/robot_description.h"
#include "transport/dds/node.h"

namespace leitstand {

/// Those services of one robot that have a part in its stop (ServiceStop), over DDS. Any thread; nothing
/// waits for the network.
class StopServices {
public:
    /// Calls @p changed from the node's thread when an answer came. A service that the node may not call, as
    /// without permission, is one that nobody offers; its status says why.
    [[nodiscard]] static std::unique_ptr<StopServices> create(Node& node, const RobotDescription& robot,
                                                              std::function<void()> changed);
    ~StopServices();
    StopServices(const StopServices&) = delete;
    StopServices& operator=(const StopServices&) = delete;

    void stop(SteadyTime now);
    void release(SteadyTime now);
    /// Stops those services again that were released while the robot was not.
    void hold(SteadyTime now);
    /// Makes the calls that are due. Call about every 20 ms. Returns whether a release was revoked, so that
    /// the rest of the robot must be stopped again, too.
    [[nodiscard]] bool step(SteadyTime now);
    /// Why the last release was revoked, kept until the next stop or release; empty: it was not.
    [[nodiscard]] std::string refusal() const;
    /// Whether a release is not confirmed yet.
    [[nodiscard]] bool isReleasing() const;
    [[nodiscard]] std::vector<StopServiceStatus> status() const;

private:
    struct State;
    explicit StopServices(std::unique_ptr<State> state);
    std::unique_ptr<State> m_state;
};

}  // namespace leitstand
