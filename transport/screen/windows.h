#pragma once

#include <vector>

#include "transport/screen/datagram.h"
#include "transport/screen/limits.h"

namespace leitstand::screen {

/// Limits how fast the counts of one writer or reader increase. Counts that are not higher than an earlier
/// one are passed, since the library ignores them.
class CountWindow {
public:
    /// @p leads: whether the count comes from the place where the sender speaks (Remote::leads()). A count
    /// from elsewhere may be ahead by at most limits::Beside, and does not use the sender's budget.
    [[nodiscard]] bool admits(std::uint32_t count, bool leads, Moment now);

private:
    bool m_known = false;
    std::uint32_t m_highest = 0;
    Budget m_budget{limits::Counts};
};

/// Limits how fast the sample numbers of a writer increase. The first number may be any up to
/// limits::MostNumber.
class WriterWindow {
public:
    /// @p leads: as in CountWindow::admits(). @p unfinished: budget of the writer's participant.
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
    std::vector<Sample> m_samples;  // ring of the samples in fragments that began last
    std::size_t m_nextSample = 0;
};

}  // namespace leitstand::screen
