#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "core/base/time.h"
#include "core/event/station_samples.h"
#include "core/robot/control/grant_view.h"
#include "core/robot/control/grants.h"
#include "core/robot/link/link_status.h"

namespace leitstand {

/// The grants that a station holds, requests or hears of (docs/design.md, "The wire"). Pure: no clock, no
/// thread.
///
/// - If a grant has no holder, a station that requests it takes it after 3 s of listening (at once if its
///   last holder released it). If it has a holder, the request is repeated once a second, and the holder
///   agrees or refuses. When the holder was silent for 3 s, the requesting station takes the grant.
/// - Taking a grant raises its term. Two stations may hold the same grant: they took it at the same moment,
///   or could not hear each other for a while. Then the higher term is right, and of equal terms the
///   smaller identity. Both stations come to the same result, and the wrong one gives way to the other.
/// - A restarted station holds its grants under their former terms. If another station has taken over, that
///   station has a higher term.
/// - Terms begin with the seconds of the wall clock, so that a station that lost its memory still takes a
///   higher term than before. A wrong clock only affects who is right after a conflict; silence is never
///   measured with it.
class GrantBook {
public:
    GrantBook(const StationIdentity& me, const Sender& sender, SteadyTime now,
              const GrantTiming& timing = {});

    /// Call when the station's process has a new identity in the domain, @p sender. The station keeps the
    /// grants that it holds.
    void rejoined(const Sender& sender);
    void requestGrant(const GrantId& id);  ///< begins to request the grant
    /// Gives the grant up, to the first requester if there is one, and stops requesting it.
    void release(const GrantId& id, SteadyTime now);
    /// The operator's answer to the first requester; does nothing without one.
    void answerRequest(const GrantId& id, bool consent, SteadyTime now);
    void leave(SteadyTime now);  ///< gives up all grants; call at the end of the program

    void receive(const GrantSample& sample, const Sender& from, SteadyTime now);
    /// Returns what must be sent now, in this order. Call ten times a second, and after every change.
    [[nodiscard]] std::vector<GrantSample> due(SteadyTime now, Time wall);

    [[nodiscard]] GrantView view(const GrantId& id, SteadyTime now) const;
    /// Whether this station may use the grant: it holds it, and sent a heartbeat within the last 3 s.
    [[nodiscard]] bool mayAct(const GrantId& id, SteadyTime now) const;
    [[nodiscard]] std::vector<HeldGrant> held() const;  ///< grants to remember for the next run
    /// All grants that were requested or that messages were about.
    [[nodiscard]] std::vector<GrantId> known() const;

private:
    struct Request {
        std::string station, title;
        SteadyTime last;
    };
    struct Entry {
        bool mine = false, asked = false;
        bool offered = false;   ///< whether it was requested, and the holder agreed
        bool released = false;  ///< whether its last holder released it
        std::string holder, holderTitle;
        Sender holderSender = {};
        std::uint64_t term = 0;     ///< term of the holder
        std::uint64_t highest = 0;  ///< highest term heard so far
        SteadyTime received = {};   ///< when the last heartbeat of another holder was received
        SteadyTime sent = {};       ///< when this station sent its last heartbeat
        SteadyTime nextSend = {};   ///< when the next heartbeat or request is due
        std::vector<Request> requests;
        std::string refusedBy, lostTo;
    };
    struct Pending {
        GrantId id;
        GrantSample::Action action;
        std::string other;
        std::uint64_t term;
    };

    Entry* entryOf(const GrantId& id);
    void receiveHold(const GrantId& id, Entry& entry, const GrantSample& sample, const Sender& from,
                     SteadyTime now);
    void receiveWord(Entry& entry, const GrantSample& sample, const Sender& from, SteadyTime now);
    void giveTo(const GrantId& id, Entry& entry, const std::string& other, SteadyTime now);
    void take(Entry& entry, SteadyTime now, Time wall);
    [[nodiscard]] bool isSilent(const Entry& entry, SteadyTime now) const;
    [[nodiscard]] bool mayTake(const Entry& entry, SteadyTime now) const;
    [[nodiscard]] bool beats(const GrantSample& sample, const Sender& from, const Entry& entry) const;

    std::string m_station, m_title;
    Sender m_sender;
    SteadyTime m_began;
    GrantTiming m_timing;
    std::map<GrantId, Entry> m_entries;
    std::vector<Pending> m_pending;  ///< answers and releases, to be sent before heartbeats
};

}  // namespace leitstand
