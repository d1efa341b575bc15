#pragma once

#include <cstdint>
#include <optional>

#include "core/base/time.h"
#include "core/station/alarms/alarm_tone.h"

namespace leitstand {

/// Which tone is to be heard when: "act" again and again until it is acknowledged, "attention" once for each.
/// Pure.
class AlarmVoice {
public:
    /// @p loud: an alarm says "act" and is not acknowledged; @p attentions: AlarmBook::attentions(). To be
    /// asked a few times a second. What came while it was muted is not made up for.
    [[nodiscard]] std::optional<AlarmTone> due(bool loud, std::uint64_t attentions, Time mutedUntil,
                                               Time now);

private:
    std::uint64_t m_told = 0;
    Time m_last{};
    bool m_any = false;
};

}  // namespace leitstand
