#pragma once

#include <cstdint>
#include <deque>
#include <optional>
#include <string>

#include "core/robot/control/grants.h"
#include "core/robot/link/link_status.h"

namespace leitstand {

struct GrantSample;

/// Decides whom a robot obeys, from the heartbeats that it receives (docs/design.md, "The wire"). Pure: no
/// clock, no thread.
///
/// Commands carry no identity of a station: a command counts if it comes from the process that sends the
/// holder's heartbeats. There is at most one holder at any time:
/// - the first station that sends a heartbeat for the grant, when there is no holder;
/// - another station, when the holder consents to it, releases the grant, or was silent for 3 s by the
///   robot's steady clock;
/// - the holder's station after a restart (same identity, other process), at once; its earlier process no
///   longer counts, even if it still runs.
/// Terms and stamps play no role here: stations settle conflicts between themselves (GrantBook), and the
/// robot follows when the wrong one consents.
class GrantArbiter {
public:
    explicit GrantArbiter(GrantId id, const GrantTiming& timing = {});

    /// Takes any message about grants; those about other grants are ignored.
    void receive(const GrantSample& sample, const Sender& from, SteadyTime now);

    /// Whether commands of @p from count: @p from is the holder, and its heartbeat was heard within 3 s.
    [[nodiscard]] bool obeys(const Sender& from, SteadyTime now) const;
    /// Identity of the station that is obeyed; empty when there is no holder or the holder is silent.
    [[nodiscard]] std::string holder(SteadyTime now) const;
    /// Rises whenever the holder changes or gives the grant up.
    [[nodiscard]] std::uint64_t changes() const { return m_changes; }

private:
    struct Holder {
        std::string station;
        Sender sender;
        SteadyTime received;
    };
    [[nodiscard]] bool isSilent(const Holder& holder, SteadyTime now) const;
    [[nodiscard]] bool mayTake(const std::string& station, const Sender& from, SteadyTime now) const;
    void take(Holder next);

    GrantId m_id;
    GrantTiming m_timing;
    std::optional<Holder> m_holder;
    std::optional<Holder> m_other;  ///< newest station that claimed the grant and was not accepted
    std::string m_reservedFor;      ///< station that the last holder consented to
    SteadyTime m_reserved = {};
    std::deque<Sender> m_superseded;  ///< earlier processes of the holder's station
    std::uint64_t m_changes = 0;
};

}  // namespace leitstand
