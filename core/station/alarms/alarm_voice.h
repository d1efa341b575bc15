#pragma once

#include <cstdint>
#include <optional>

#include "core/base/time.h"
#include "core/station/alarms/alarm_tone.h"

namespace leitstand {

/// Decides which tone sounds when: "act" repeatedly until it is acknowledged, "attention" once for each
/// alarm. Pure.
class AlarmVoice {
public:
    /// Returns the tone to play now; empty: none. Call a few times a second. @p loud: an "act" alarm is not
    /// acknowledged. @p attentions: AlarmBook::attentions(). If an attention is raised while muted, no tone
    /// follows later.
    [[nodiscard]] std::optional<AlarmTone> due(bool loud, std::uint64_t attentions, Time mutedUntil,
                                               Time now);

private:
    std::uint64_t m_reported = 0;
    Time m_last{};
    bool m_any = false;
};

}  // namespace leitstand
