#pragma once

#include <optional>
#include <unordered_map>
#include <unordered_set>
#include <vector>

#include "transport/screen/parameters.h"
#include "transport/screen/place.h"
#include "transport/screen/windows.h"

namespace leitstand::screen {

/// A participant that was let in.
struct Remote {
    struct Bound {
        Place place;
        Moment heard;
        bool speaks = false;  ///< and does not only announce itself
    };
    Address host{};  ///< whose places it takes
    Place home;      ///< that it announced itself from first, or since that is silent ...
    Moment atHome;   ///< ... and when it was heard there
    Moment first, heard;
    Seconds lease{0.0};
    bool refused = false;            ///< it went beyond what a host may have: nothing of it passes
    std::vector<Address> announced;  ///< where it says that it is
    std::vector<std::uint16_t> discoveryPorts, samplePorts;  ///< that it says it hears on
    std::uint64_t announcement = 0;                          ///< hash of what it announced last
    std::vector<Bound> places;                               ///< where it sends from
    std::unordered_map<EntityId, std::size_t> endpoints;     ///< with the bytes of their announcements
    /// Where a writer or reader speaks from. A port: a participant with several addresses speaks from the
    /// same one at all of them, and nobody else on its host has that.
    struct Voice {
        std::optional<std::uint16_t> port;
        Moment heard;
    };
    struct Writer {
        Voice voice;
        WriterWindow window;
    };
    struct ReaderWindows {
        Voice voice;
        CountWindow acknowledgements, fragments;
    };
    std::unordered_map<EntityId, Writer> writers;
    std::unordered_map<std::uint64_t, ReaderWindows> readers;  ///< by reader and our writer
    Budget unfinished{limits::UnfinishedSamples};

    /// A writer of its, or a reader that hears a writer of ours. Null for those that it never announced, when
    /// there are many: the library hears none of them. Those that every participant has are always there.
    [[nodiscard]] Writer* writerOf(EntityId writer);
    [[nodiscard]] ReaderWindows* windowsOf(EntityId reader, EntityId ours);
    /// Whether @p place is where @p voice speaks from: the first place that it was heard from. Another one
    /// takes its place when nothing at all comes from there for a while; home does when nothing of this voice
    /// does.
    [[nodiscard]] bool leads(const Voice& voice, const Place& place, Moment now) const;
    /// Whether a writer or reader speaks from @p place.
    [[nodiscard]] bool isVoice(const Place& place) const;
};

/// Who is in the domain, as far as the screen let them in: bounded for each host and in total. Processes that
/// were killed keep their memory until their lease is over, but take no place of those that speak.
class Participants {
public:
    [[nodiscard]] Remote* find(const Prefix& prefix);
    /// Lets a participant in that says @p said; null when its host has too many, or all hosts together.
    Remote* admit(const Announcement& said, const Address& host, Moment now);
    void remove(const Prefix& prefix);
    /// Lets go of those that were silent for their lease, as the library does.
    void forgetSilent(Moment now);

    /// Whether @p remote may send from @p place: one where it was heard before, or a new one that is its own
    /// by all that can be told (see docs/wire.md). Notes that it was heard there.
    [[nodiscard]] bool mayComeFrom(Remote& remote, const Place& place, bool speaks, Moment now);
    /// Whether @p place is where @p remote announces itself from, or may be because that is silent. What
    /// changes or ends its announcement has to come from there: in the time in which new places are taken
    /// anybody on its host could send it away otherwise, with keys, too, since that is plain.
    [[nodiscard]] static bool isHome(const Remote& remote, const Place& place, Moment now);
    /// Notes that @p remote announced itself from @p place, which is its own.
    static void setHome(Remote& remote, const Place& place, Moment now);
    /// Whether a participant sends from @p place.
    [[nodiscard]] bool isKnown(const Place& place) const { return m_places.contains(place); }

    /// Whether one of them hears discovery on @p port, and none samples.
    [[nodiscard]] bool hearDiscoveryOnly(std::uint16_t port) const;

    /// Notes an endpoint; false when its host has too many: then the participant is refused.
    [[nodiscard]] bool addEndpoint(Remote& remote, EntityId endpoint, std::size_t bytes, Moment now);
    void removeEndpoint(Remote& remote, EntityId endpoint);

    [[nodiscard]] std::size_t size() const { return m_remotes.size(); }

private:
    using Remotes = std::unordered_map<Prefix, Remote, BytesHash>;
    struct Use {
        std::size_t participants = 0, endpoints = 0, bytes = 0;
    };
    void forget(Remotes::iterator one);
    /// What those of @p host have that were heard lately.
    [[nodiscard]] Use presentUse(const Address& host, Moment now) const;
    /// Notes that @p remote sends from @p place; false where it sends from too many.
    [[nodiscard]] bool bind(Remote& remote, const Place& place, bool speaks, Moment now);

    Remotes m_remotes;
    std::unordered_map<Address, Use, BytesHash> m_hosts;
    std::unordered_map<Place, int, BytesHash> m_places;  // how many participants send from there
    std::size_t m_endpoints = 0;
};

}  // namespace leitstand::screen
