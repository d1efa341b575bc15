#pragma once

#include <cstdint>
#include <optional>

#include "core/base/time.h"
#include "core/station/alarms/alarm_tone.h"

namespace leitstand {

/// Decides which tone sounds when: "act" again and again until it is acknowledged, "attention" once for each.
/// Pure.
class AlarmVoice {
public:
    /// Returns the tone to play now; empty: none. @p loud: an "act" alarm is not acknowledged. @p attentions:
    /// AlarmBook::attentions(). Called a few times a second. An attention raised while muted gets no tone
    /// afterwards.
    [[nodiscard]] std::optional<AlarmTone> due(bool loud, std::uint64_t attentions, Time mutedUntil,
                                               Time now);

private:
    std::uint64_t m_reported = 0;
    Time m_last{};
    bool m_any = false;
};

}  // namespace leitstand
