#pragma once

#include <chrono>

#include "core/robot/link/link_status.h"

namespace leitstand {

/// Something that happens only when it is held for a while without a break. Pure: no clock.
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
    /// Returns true once, when the time is over. It must be released before it can happen again.
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
