#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "core/base/time.h"
#include "core/robot/control/grants.h"
#include "core/robot/link/link_status.h"

namespace leitstand {

/// A grant as a station sees it.
struct GrantView {
    bool mine = false;                ///< this station has it
    bool asked = false;               ///< this station wants it and waits
    bool silent = false;              ///< its holder was not heard for 3 s
    std::string holder, holderTitle;  ///< who has it, this station too; empty: nobody that was heard
    std::string requestedBy, requestedByTitle;  ///< of a grant of this station: who asked first for it
    std::string refusedBy;                      ///< who said no to the last question of this station
    std::string lostTo;                         ///< who has it now that this station had; until it asks again
    friend bool operator==(const GrantView&, const GrantView&) = default;
};

/// What a station holds, asks for and hears of others (design, section 4). Pure: no clock, no thread.
///
/// - A grant that nobody holds is taken by who asks for it, after 3 s of listening (at once when its holder
///   released it). One that is held is asked for once a second: the holder consents or refuses; when it was
///   silent for 3 s, the asking station takes over.
/// - Every taking raises the term. When two stations hold the same grant (both took it in the same moment, or
///   could not hear each other for a while), the higher term is right, and of equal terms the smaller
///   identity: both come to the same result, and the one that is wrong consents to the other.
/// - A station that starts again holds what it held under the term of then: whoever took over meanwhile has a
///   higher one.
/// - Terms begin with the seconds of the wall clock, so that a station that lost its memory is not below
///   itself. A wrong clock only decides who is right after a conflict; silence is never measured with it.
class GrantBook {
public:
    GrantBook(const StationIdentity& me, const Sender& sender, SteadyTime now,
              const GrantTiming& timing = {});

    /// The station's process has another identity in the domain from now on; what it holds it goes on
    /// holding.
    void rejoined(const Sender& sender);
    void ask(const GrantId& id);                      ///< wants it from now on
    void release(const GrantId& id, SteadyTime now);  ///< gives it up (to who asked first), asks no more
    /// The operator's answer to the station that asked first; nothing when nobody asks.
    void answer(const GrantId& id, bool consent, SteadyTime now);
    void leave(SteadyTime now);  ///< gives up everything, as at the end of the program

    void hear(const GrantSample& sample, const Sender& from, SteadyTime now);
    /// What has to be sent now, in this order; to be asked ten times a second, and after every change.
    [[nodiscard]] std::vector<GrantSample> due(SteadyTime now, Time wall);

    [[nodiscard]] GrantView view(const GrantId& id, SteadyTime now) const;
    /// Whether this station may act on it: it has it, and others heard so within 3 s.
    [[nodiscard]] bool mayAct(const GrantId& id, SteadyTime now) const;
    [[nodiscard]] std::vector<HeldGrant> held() const;  ///< to be remembered
    [[nodiscard]] std::vector<GrantId> known() const;   ///< all that was asked for or heard of

private:
    struct Request {
        std::string station, title;
        SteadyTime last;
    };
    struct Entry {
        bool mine = false, asked = false;
        bool offered = false;   ///< asked for, and consented
        bool released = false;  ///< nobody has it, as its last holder said
        std::string holder, holderTitle;
        Sender holderSender = {};
        std::uint64_t term = 0;     ///< of the holder
        std::uint64_t highest = 0;  ///< ever heard
        SteadyTime heard = {};      ///< last heartbeat of another holder
        SteadyTime sent = {};       ///< last heartbeat of our own
        SteadyTime nextSay = {};    ///< heartbeat or request
        std::vector<Request> requests;
        std::string refusedBy, lostTo;
    };
    struct Saying {
        GrantId id;
        GrantSample::Action action;
        std::string other;
        std::uint64_t term;
    };

    Entry* entryOf(const GrantId& id);
    void hearHold(const GrantId& id, Entry& entry, const GrantSample& sample, const Sender& from,
                  SteadyTime now);
    void hearWord(Entry& entry, const GrantSample& sample, const Sender& from, SteadyTime now);
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
    std::vector<Saying> m_sayings;  ///< decided, to be sent before heartbeats
};

}  // namespace leitstand
