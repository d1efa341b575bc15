#pragma once

#include <cstdint>
#include <deque>
#include <optional>
#include <string>

#include "core/robot/control/grants.h"
#include "core/robot/link/link_status.h"

namespace leitstand {

struct GrantSample;

/// Decides which station a robot obeys, from the heartbeats that it receives (docs/design.md, "The wire").
/// Pure: no clock, no thread.
///
/// Commands carry no identity of a station. A command is obeyed if it comes from the process that sends the
/// holder's heartbeats. There is at most one holder at any time:
/// - the first station that sends a heartbeat for the grant, when there is no holder;
/// - another station, when the holder agrees or releases the grant, or was silent for 3 s by the
///   robot's steady clock;
/// - the holder's station after a restart (same identity, other process), at once. Its earlier process is
///   no longer obeyed, even if it still runs.
///
/// Terms and stamps are ignored here: stations settle conflicts among themselves (GrantBook), and the robot
/// follows when the wrong holder agrees.
class GrantArbiter {
public:
    explicit GrantArbiter(GrantId id, const GrantTiming& timing = {});

    /// Takes any message about grants; ignores those about other grants.
    void receive(const GrantSample& sample, const Sender& from, SteadyTime now);

    /// Whether commands of @p from are obeyed: @p from is the holder, and its heartbeat was heard within the
    /// last 3 s.
    [[nodiscard]] bool obeys(const Sender& from, SteadyTime now) const;
    /// Identity of the station that is obeyed; empty when there is no holder or the holder is silent.
    [[nodiscard]] std::string holder(SteadyTime now) const;
    /// Increases whenever the holder changes or gives the grant up.
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
    std::optional<Holder> m_other;  ///< newest other station that claimed the grant and was not accepted
    std::string m_reservedFor;      ///< station to which the last holder agreed to give the grant
    SteadyTime m_reserved = {};
    std::deque<Sender> m_superseded;  ///< earlier processes of the holder's station
    std::uint64_t m_changes = 0;
};

}  // namespace leitstand
