#pragma once

#include <chrono>
#include <memory>
#include <mutex>
#include <optional>

#include "tests/support/dds/test_domain.h"
#include "transport/dds/node.h"

namespace leitstand::test {

/// Hears Kurt3D's drive commands as the robot does, by a DDS node of its own.
class CommandWire {
public:
    using Clock = std::chrono::steady_clock;

    explicit CommandWire(const TestDomain& domain);

    /// Waits until a command turns (or not, with @p turning false); when it came. Nothing after 10 s.
    [[nodiscard]] std::optional<Clock::time_point> waitFor(bool turning) const;
    [[nodiscard]] bool receives() const;

private:
    mutable std::mutex m_mutex;
    bool m_any = false, m_turning = false;
    Clock::time_point m_since;  ///< of the present state
    std::unique_ptr<Node> m_node;
    std::unique_ptr<Subscription> m_commands;
};

}  // namespace leitstand::test
