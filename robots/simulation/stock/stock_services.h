#pragma once

#include <atomic>
#include <memory>
#include <vector>

#include "core/base/result.h"
#include "core/robot/robot_description.h"
#include "transport/dds/node.h"
#include "transport/services/service_server.h"

namespace leitstand::simulation {

/// Offers the services of a stock robot. A Switch that has a part in its stop is its e-stop, which takes the
/// power from its motors. Triggers called start_camera and stop_camera do that. Goals are cancelled, of which
/// there are none.
class StockServices {
public:
    /// Errors name the topic.
    [[nodiscard]] static Result<std::unique_ptr<StockServices>> create(Node& node,
                                                                       const RobotDescription& robot);

    /// Whether the e-stop is on.
    [[nodiscard]] bool motorsAreOff() const { return m_off; }
    /// Whether the camera was stopped.
    [[nodiscard]] bool camerasAreOff() const { return m_blind; }

private:
    std::atomic<bool> m_off = false, m_blind = false;
    std::vector<std::unique_ptr<ServiceServer>> m_servers;  ///< last: destroyed first
};

}  // namespace leitstand::simulation
