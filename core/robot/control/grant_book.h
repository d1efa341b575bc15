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
/// - A grant without a holder goes to the station that requests it, after 3 s of listening (at once when its
///   last holder released it). A held grant is requested once a second, and the holder consents or refuses.
///   When the holder was silent for 3 s, the requesting station takes over.
/// - Taking a grant raises its term. Two stations may hold the same grant: both took it at the same moment,
///   or could not hear each other for a while. Then the higher term is right and, of equal terms, the smaller
///   identity. Both come to the same result, and the wrong one consents to the other.
/// - A restarted station holds its grants under their former terms: a station that took over meanwhile has a
///   higher term.
/// - Terms begin with the seconds of the wall clock: a station that lost its memory still takes a higher term
///   than before. A wrong clock only decides who is right after a conflict; silence is never measured with
///   it.
class GrantBook {
public:
    GrantBook(const StationIdentity& me, const Sender& sender, SteadyTime now,
              const GrantTiming& timing = {});

    /// Call when the station's process has another identity in the domain, @p sender; the station keeps the
    /// grants that it holds.
    void rejoined(const Sender& sender);
    void requestGrant(const GrantId& id);  ///< requests the grant from now on
    /// Gives the grant up, to the first requester if there is one, and requests it no more.
    void release(const GrantId& id, SteadyTime now);
    /// The operator's answer to the first requester; does nothing without one.
    void answerRequest(const GrantId& id, bool consent, SteadyTime now);
    void leave(SteadyTime now);  ///< gives up everything, at the end of the program

    void receive(const GrantSample& sample, const Sender& from, SteadyTime now);
    /// Returns what must be sent now, in this order; call it ten times a second, and after every change.
    [[nodiscard]] std::vector<GrantSample> due(SteadyTime now, Time wall);

    [[nodiscard]] GrantView view(const GrantId& id, SteadyTime now) const;
    /// Whether this station may act on the grant: it holds it, and sent a heartbeat within 3 s.
    [[nodiscard]] bool mayAct(const GrantId& id, SteadyTime now) const;
    [[nodiscard]] std::vector<HeldGrant> held() const;  ///< grants to remember for the next run
    [[nodiscard]] std::vector<GrantId> known() const;   ///< all grants that were requested or heard of

private:
    struct Request {
        std::string station, title;
        SteadyTime last;
    };
    struct Entry {
        bool mine = false, asked = false;
        bool offered = false;   ///< requested, and the holder consented
        bool released = false;  ///< its last holder released it
        std::string holder, holderTitle;
        Sender holderSender = {};
        std::uint64_t term = 0;     ///< of the holder
        std::uint64_t highest = 0;  ///< highest term ever heard
        SteadyTime received = {};   ///< last heartbeat of another holder
        SteadyTime sent = {};       ///< last heartbeat of this station
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
