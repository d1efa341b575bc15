#pragma once

#include <chrono>
#include <cstdint>
#include <map>
#include <optional>
#include <vector>

#include "core/station/alarms/alarm.h"

namespace leitstand {

/// When alarms come and go.
struct AlarmTiming {
    std::chrono::nanoseconds raiseAfter = std::chrono::milliseconds(300);  ///< of the cause, without a break
    std::chrono::nanoseconds endAfter = std::chrono::seconds(2);  ///< without the cause: nothing flaps
    std::chrono::nanoseconds shown = std::chrono::seconds(10);  ///< after its end; longer when it said "act"
};

/// What happened to an alarm, for the log.
struct AlarmChange {
    enum class Kind : std::uint8_t { Raised, Acknowledged, Ended };
    Kind kind = Kind::Raised;
    AlarmCause cause;
};

/// The alarms of a mission: raised, acknowledged, ended. Pure: no clock, no thread.
///
/// One whose severity rises, or that comes again after it ended, is raised anew and has to be acknowledged
/// anew; so is one that was acknowledged when its count rises. One that said "act" stays, ended, until it is
/// acknowledged; others go some seconds after their end.
class AlarmBook {
public:
    explicit AlarmBook(const AlarmTiming& timing = {}) : m_timing(timing) {}

    /// @p causes: all that are so at @p now; to be told five times a second.
    std::vector<AlarmChange> update(const std::vector<AlarmCause>& causes, Time now);
    /// The operator has seen it. Nothing happens to one that is unknown or acknowledged.
    std::vector<AlarmChange> acknowledge(const AlarmId& id, Time now);
    std::vector<AlarmChange> acknowledgeNewest(Time now);  ///< of those that are not
    /// No tones until @p until; an earlier moment ends it.
    void mute(Time until) { m_mutedUntil = until; }

    /// Newest first; those that ended last.
    [[nodiscard]] std::vector<Alarm> alarms() const;
    [[nodiscard]] bool stands(const AlarmId& id) const;  ///< raised, and not ended
    /// The severity it stands with; empty: it does not.
    [[nodiscard]] std::optional<AlarmSeverity> severity(const AlarmId& id) const;
    [[nodiscard]] Time mutedUntil() const { return m_mutedUntil; }
    /// How often something was raised that is to be looked at, not acted on.
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
    std::map<AlarmId, Pending> m_pending;  ///< causes too young
    std::uint64_t m_number = 0, m_attentions = 0;
    Time m_mutedUntil{};
};

}  // namespace leitstand
