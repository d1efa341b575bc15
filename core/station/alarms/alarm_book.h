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
    std::chrono::nanoseconds raiseAfter = std::chrono::milliseconds(300);  ///< a cause must persist this long
    std::chrono::nanoseconds endAfter = std::chrono::seconds(2);  ///< must be gone this long (no flapping)
    std::chrono::nanoseconds shown = std::chrono::seconds(10);  ///< after its end; longer for an "act" alarm
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
/// its end. An acknowledged one is also raised again when its count rises. An ended "act" alarm stays until
/// it is acknowledged; others go some seconds after their end.
class AlarmBook {
public:
    explicit AlarmBook(const AlarmTiming& timing = {}) : m_timing(timing) {}

    /// Takes all @p causes that hold at @p now. Called five times a second.
    std::vector<AlarmChange> update(const std::vector<AlarmCause>& causes, Time now);
    /// Acknowledges an alarm. Does nothing when it is unknown or already acknowledged.
    std::vector<AlarmChange> acknowledge(const AlarmId& id, Time now);
    std::vector<AlarmChange> acknowledgeNewest(Time now);  ///< the newest unacknowledged one
    /// Mutes the tones until @p until; a moment in the past unmutes them.
    void mute(Time until) { m_mutedUntil = until; }

    /// Returns all alarms, newest first, ended ones last.
    [[nodiscard]] std::vector<Alarm> alarms() const;
    [[nodiscard]] bool stands(const AlarmId& id) const;  ///< raised, and not ended
    /// Returns the severity of a standing alarm; empty: it does not stand.
    [[nodiscard]] std::optional<AlarmSeverity> severity(const AlarmId& id) const;
    [[nodiscard]] Time mutedUntil() const { return m_mutedUntil; }
    /// Returns how many alarms of AlarmSeverity::Attention were raised so far.
    [[nodiscard]] std::uint64_t attentions() const { return m_attentions; }

private:
    struct Pending {
        Time first{};
        bool seen = false;
    };
    struct Entry {
        Alarm alarm;
        std::optional<Time> absent;  ///< since when the cause is gone
    };
    void raise(Entry& entry, const AlarmCause& cause, Time now, std::vector<AlarmChange>& changes);
    void see(const AlarmCause& cause, Time now, std::vector<AlarmChange>& changes);
    void endWhatIsGone(const std::vector<AlarmCause>& causes, Time now, std::vector<AlarmChange>& changes);

    AlarmTiming m_timing;
    std::map<AlarmId, Entry> m_entries;
    std::map<AlarmId, Pending> m_pending;  ///< causes that are still too young
    std::uint64_t m_number = 0, m_attentions = 0;
    Time m_mutedUntil{};
};

}  // namespace leitstand
