#include "core/station/alarms/alarm_book.h"

#include <algorithm>
#include <utility>

namespace leitstand {

std::string logKey(const AlarmId& id) {
    return id.detail.empty() ? id.key : id.key + "/" + id.detail;
}

void AlarmBook::raise(Entry& entry, const AlarmCause& cause, Time now, std::vector<AlarmChange>& changes) {
    entry.alarm = {.cause = cause, .number = ++m_number, .since = now, .ended = {}, .acknowledged = false};
    entry.absent.reset();
    if (cause.severity == AlarmSeverity::Attention) ++m_attentions;
    changes.push_back({AlarmChange::Kind::Raised, cause});
}

void AlarmBook::see(const AlarmCause& cause, Time now, std::vector<AlarmChange>& changes) {
    const auto known = m_entries.find(cause.id);
    if (known != m_entries.end() && !known->second.alarm.ended) {
        Entry& entry = known->second;
        entry.absent.reset();
        const AlarmCause& raised = entry.alarm.cause;
        const bool another = entry.alarm.acknowledged && cause.count > raised.count;
        const bool worse = cause.severity > raised.severity || another;
        if (worse && cause.persists.count() == 0) return raise(entry, cause, now, changes);
        if (!worse) {
            entry.alarm.cause = cause;
            return;
        }
    }
    Pending& pending = m_pending.try_emplace(cause.id, Pending{now, true}).first->second;
    pending.seen = true;
    if (now - pending.first < std::max(m_timing.raiseAfter, cause.persists)) return;
    m_pending.erase(cause.id);
    raise(m_entries[cause.id], cause, now, changes);
}

void AlarmBook::endWhatIsGone(const std::vector<AlarmCause>& causes, Time now,
                              std::vector<AlarmChange>& changes) {
    for (auto one = m_entries.begin(); one != m_entries.end();) {
        auto& [id, entry] = *one;
        Alarm& alarm = entry.alarm;
        const bool so = std::any_of(causes.begin(), causes.end(),
                                    [&id = id](const AlarmCause& cause) { return cause.id == id; });
        if (!so && !alarm.ended) {
            if (!entry.absent) entry.absent = now;
            if (now - *entry.absent >= m_timing.endAfter) {
                alarm.ended = now;
                changes.push_back({AlarmChange::Kind::Ended, alarm.cause});
            }
        }
        const bool waits = alarm.cause.severity == AlarmSeverity::Act && !alarm.acknowledged;
        const bool gone = alarm.ended && !waits && now - *alarm.ended >= m_timing.shown;
        one = gone ? m_entries.erase(one) : std::next(one);
    }
}

std::vector<AlarmChange> AlarmBook::update(const std::vector<AlarmCause>& causes, Time now) {
    std::vector<AlarmChange> changes;
    for (auto& [id, pending] : m_pending) pending.seen = false;
    for (const AlarmCause& cause : causes) see(cause, now, changes);
    std::erase_if(m_pending, [](const auto& one) { return !one.second.seen; });
    endWhatIsGone(causes, now, changes);
    return changes;
}

std::vector<AlarmChange> AlarmBook::acknowledge(const AlarmId& id, Time now) {
    const auto known = m_entries.find(id);
    if (known == m_entries.end() || known->second.alarm.acknowledged) return {};
    Alarm& alarm = known->second.alarm;
    alarm.acknowledged = true;
    const AlarmChange change{AlarmChange::Kind::Acknowledged, alarm.cause};
    if (alarm.ended && now - *alarm.ended >= m_timing.shown) m_entries.erase(known);
    return {change};
}

std::vector<AlarmChange> AlarmBook::acknowledgeNewest(Time now) {
    for (const Alarm& alarm : alarms()) {
        if (!alarm.acknowledged) return acknowledge(AlarmId(alarm.cause.id), now);
    }
    return {};
}

std::vector<Alarm> AlarmBook::alarms() const {
    std::vector<Alarm> all;
    for (const auto& [id, entry] : m_entries) all.push_back(entry.alarm);
    std::sort(all.begin(), all.end(), [](const Alarm& a, const Alarm& b) {
        return std::pair(!a.ended, a.number) > std::pair(!b.ended, b.number);
    });
    return all;
}

bool AlarmBook::stands(const AlarmId& id) const {
    return severity(id).has_value();
}

std::optional<AlarmSeverity> AlarmBook::severity(const AlarmId& id) const {
    const auto known = m_entries.find(id);
    if (known == m_entries.end() || known->second.alarm.ended) return std::nullopt;
    return known->second.alarm.cause.severity;
}

}  // namespace leitstand
