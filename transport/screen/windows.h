#pragma once

#include <vector>

#include "transport/screen/datagram.h"
#include "transport/screen/limits.h"

namespace leitstand::screen {

/// Bounds how far the counts of one sender advance. Lower ones pass: the library ignores what it has seen.
class CountWindow {
public:
    /// @p leads: it comes from where the sender speaks (Remote::leads()). What comes from elsewhere may be
    /// only a little ahead of that, and uses up nothing of the sender's budget.
    [[nodiscard]] bool admits(std::uint32_t count, bool leads, Moment now);

private:
    bool m_known = false;
    std::uint32_t m_highest = 0;
    Budget m_budget{limits::Counts};
};

/// Bounds how far the numbers of a writer advance. The first may be any.
class WriterWindow {
public:
    /// @p leads: as in CountWindow::admits().
    [[nodiscard]] Fault admit(const Submessage& next, bool leads, Budget& unfinished, Moment now);

private:
    struct Sample {
        std::int64_t number = 0;
        std::uint32_t size = 0;
        std::uint16_t fragmentSize = 0;
    };
    [[nodiscard]] bool admitNumber(std::int64_t number, bool leads, Moment now);
    [[nodiscard]] Fault admitFragment(const Submessage& next, bool leads, Budget& unfinished, Moment now);

    bool m_known = false;
    std::int64_t m_highest = 0;
    Budget m_numbers{limits::Numbers}, m_gaps{limits::Gaps};
    CountWindow m_heartbeats, m_fragmentHeartbeats;
    std::vector<Sample> m_samples;  // samples in fragments: the last that began, as a ring
    std::size_t m_nextSample = 0;
};

}  // namespace leitstand::screen
