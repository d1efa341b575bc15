#pragma once

#include <cstdint>
#include <deque>
#include <optional>
#include <string>

#include "core/robot/control/grants.h"
#include "core/robot/link/link_status.h"

namespace leitstand {

/// Whom a robot obeys, from the heartbeats that it hears (design, section 4). Pure: no clock, no thread.
///
/// Commands carry no identity: they are tied to the holder by the process that they come from, which has to
/// be the one that writes its heartbeats. There is one holder at most, at any time:
/// - the first station that says so, when there is none;
/// - another when the holder consents to it or releases, or was silent for 3 s by the robot's steady clock;
/// - the holder's station started anew (same identity, other process) at once; its earlier process is then
///   out, even if it should still run.
/// Terms and stamps play no role here: who is right between stations they settle themselves (GrantBook), and
/// the robot follows when the wrong one consents.
class GrantArbiter {
public:
    explicit GrantArbiter(GrantId id, const GrantTiming& timing = {});

    /// Whatever is said about grants; other grants are ignored.
    void hear(const GrantSample& sample, const Sender& from, SteadyTime now);

    /// Whether commands of @p from count: it is the holder, and was heard within 3 s.
    [[nodiscard]] bool obeys(const Sender& from, SteadyTime now) const;
    /// Identity of the station that is obeyed; empty when there is none, or it is silent.
    [[nodiscard]] std::string holder(SteadyTime now) const;
    /// Rises whenever another process is obeyed.
    [[nodiscard]] std::uint64_t changes() const { return m_changes; }

private:
    struct Holder {
        std::string station;
        Sender sender;
        SteadyTime heard;
    };
    [[nodiscard]] bool isSilent(const Holder& holder, SteadyTime now) const;
    [[nodiscard]] bool mayTake(const std::string& station, const Sender& from, SteadyTime now) const;
    void take(Holder next);

    GrantId m_id;
    GrantTiming m_timing;
    std::optional<Holder> m_holder;
    std::optional<Holder> m_other;  ///< newest that said to hold it and was not believed
    std::string m_reservedFor;      ///< to whom the last holder consented
    SteadyTime m_reserved = {};
    std::deque<Sender> m_superseded;  ///< earlier processes of the holder's station
    std::uint64_t m_changes = 0;
};

}  // namespace leitstand
