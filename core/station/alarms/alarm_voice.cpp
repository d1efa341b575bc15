#include "core/station/alarms/alarm_voice.h"

#include <chrono>

namespace leitstand {
namespace {

constexpr std::chrono::milliseconds Again(1'500), Apart(700);

}  // namespace

std::optional<AlarmTone> AlarmVoice::due(bool loud, std::uint64_t attentions, Time mutedUntil, Time now) {
    const bool news = attentions != m_reported;
    if (now < mutedUntil) {
        m_reported = attentions;
        return std::nullopt;
    }
    const auto since = now - m_last;
    const bool free = !m_any || since >= Apart || since < std::chrono::nanoseconds(0);
    const bool again = !m_any || since >= Again || since < std::chrono::nanoseconds(0);
    if (loud ? !again : !(news && free)) return std::nullopt;
    m_reported = attentions;
    m_last = now;
    m_any = true;
    return loud ? AlarmTone::Act : AlarmTone::Attention;
}

}  // namespace leitstand
