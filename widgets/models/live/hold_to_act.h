#pragma once

#include <chrono>

#include "core/robot/link/link_status.h"

namespace leitstand {

/// An action that happens only after its control was held for some time without interruption. It has no
/// clock: callers pass the time.
class HoldToAct {
public:
    explicit HoldToAct(std::chrono::nanoseconds length = std::chrono::seconds(1)) : m_length(length) {}

    void begin(SteadyTime now) {
        if (!m_held) m_since = now;
        m_held = true;
    }
    void end() { m_held = m_done = false; }
    [[nodiscard]] bool isHeld() const { return m_held; }
    /// Returns the share of the time that has passed, 0 to 1.
    [[nodiscard]] double progress(SteadyTime now) const {
        if (!m_held) return 0.0;
        const double share = std::chrono::duration<double>(now - m_since) / m_length;
        return share < 0.0 ? 0.0 : share > 1.0 ? 1.0 : share;
    }
    /// Returns true once, when the control has been held long enough. Returns true again only after end() and
    /// begin().
    [[nodiscard]] bool due(SteadyTime now) {
        if (!m_held || m_done || now - m_since < m_length) return false;
        return m_done = true;
    }

private:
    std::chrono::nanoseconds m_length;
    SteadyTime m_since = {};
    bool m_held = false, m_done = false;
};

}  // namespace leitstand
