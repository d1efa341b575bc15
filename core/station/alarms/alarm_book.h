#pragma once

#include <chrono>
#include <cstdint>
#include <map>
#include <optional>
#include <vector>

#include "core/station/alarms/alarm.h"

namespace leitstand {

/// When alarms begin and end.
struct AlarmTiming {
    /// A cause must last this long to raise an alarm.
    std::chrono::nanoseconds raiseAfter = std::chrono::milliseconds(300);
    /// A cause must be gone this long before its alarm ends, to avoid flapping.
    std::chrono::nanoseconds endAfter = std::chrono::seconds(2);
    /// How long an alarm is shown after its end; "act" alarms are shown longer.
    std::chrono::nanoseconds shown = std::chrono::seconds(10);
};

/// What happened to an alarm, for the log.
struct AlarmChange {
    enum class Kind : std::uint8_t { Raised, Acknowledged, Ended };
    Kind kind = Kind::Raised;
    AlarmCause cause;
};

/// The alarms of a mission: raised, acknowledged, ended. Pure: no clock, no thread.
///
/// An alarm is raised again, and must be acknowledged again, when its severity rises or when it returns after
/// its end. An acknowledged alarm is also raised again when its count rises. An "act" alarm that has ended is
/// shown until it is acknowledged; others disappear some seconds after their end.
class AlarmBook {
public:
    explicit AlarmBook(const AlarmTiming& timing = {}) : m_timing(timing) {}

    /// Takes all @p causes that exist at @p now. Call five times a second.
    std::vector<AlarmChange> update(const std::vector<AlarmCause>& causes, Time now);
    /// Acknowledges an alarm. Does nothing when it is unknown or already acknowledged.
    std::vector<AlarmChange> acknowledge(const AlarmId& id, Time now);
    /// Acknowledges the newest alarm that is not acknowledged.
    std::vector<AlarmChange> acknowledgeNewest(Time now);
    /// Mutes the tones until @p until. A moment in the past unmutes them.
    void mute(Time until) { m_mutedUntil = until; }

    /// Returns all alarms: active ones first, then ended ones, each newest first.
    [[nodiscard]] std::vector<Alarm> alarms() const;
    [[nodiscard]] bool stands(const AlarmId& id) const;  ///< whether it was raised and has not ended
    /// Returns the severity of an active alarm; empty: it is not active.
    [[nodiscard]] std::optional<AlarmSeverity> severity(const AlarmId& id) const;
    [[nodiscard]] Time mutedUntil() const { return m_mutedUntil; }
    /// Returns how many alarms with AlarmSeverity::Attention were raised so far.
    [[nodiscard]] std::uint64_t attentions() const { return m_attentions; }

private:
    struct Pending {
        Time first{};
        bool seen = false;
    };
    struct Entry {
        Alarm alarm;
        std::optional<Time> absent;  ///< when the cause disappeared
    };
    void raise(Entry& entry, const AlarmCause& cause, Time now, std::vector<AlarmChange>& changes);
    void see(const AlarmCause& cause, Time now, std::vector<AlarmChange>& changes);
    void endWhatIsGone(const std::vector<AlarmCause>& causes, Time now, std::vector<AlarmChange>& changes);

    AlarmTiming m_timing;
    std::map<AlarmId, Entry> m_entries;
    std::map<AlarmId, Pending> m_pending;  ///< causes that have not lasted long enough yet
    std::uint64_t m_number = 0, m_attentions = 0;
    Time m_mutedUntil{};
};

}  // namespace leitstand
