#pragma once

#include <memory>
#include <string>
#include <vector>

#include "core/base/result.h"
#include "core/base/time.h"
#include "core/event/raw_event.h"
#include "robots/simulation/stock/stock_profile.h"
#include "transport/dds/node.h"

namespace leitstand::simulation {

/// Publishes those topics of a stock robot that the simulation has no content for: empty messages at their
/// rates. Its model has content (resources/stock/NAME.urdf).
class StockOthers {
public:
    /// Errors name the topic.
    [[nodiscard]] static Result<StockOthers> create(Node& node, const StockProfile& profile,
                                                    const std::string& nameSpace);
    void publish(Time now);  ///< publishes what is due

private:
    struct Lane {
        std::unique_ptr<Publisher> publisher;
        Payload message;
        std::chrono::nanoseconds every{};  ///< period; 0: only once
        Time next{};
    };
    std::vector<Lane> m_lanes;
};

}  // namespace leitstand::simulation
