#pragma once

#include <optional>
#include <unordered_map>
#include <unordered_set>
#include <vector>

#include "transport/screen/parameters.h"
#include "transport/screen/place.h"
#include "transport/screen/windows.h"

namespace leitstand::screen {

/// A participant that the screen has admitted, and what the screen remembers of it.
struct Remote {
    struct Bound {
        Place place;
        Moment received;
        bool speaks = false;  ///< whether it has sent more than announcements of itself from there
    };
    Address host{};  ///< host whose limits apply to it
    Place home;      ///< place from which it announces itself; changes only after silence there
    Moment atHome;   ///< when it was last heard at home
    Moment first, received;
    Seconds lease{0.0};
    bool refused = false;            ///< whether it exceeded its host's limits; nothing from it is passed
    std::vector<Address> announced;  ///< addresses that it claims to have
    std::vector<std::uint16_t> discoveryPorts, samplePorts;  ///< ports on which it claims to receive
    std::uint64_t announcement = 0;                          ///< hash of its last announcement
    std::vector<Bound> places;                               ///< places from which it sends
    std::unordered_map<EntityId, std::size_t> endpoints;     ///< size of each endpoint's announcement [B]
    /// The port from which a writer or reader sends. A participant with several addresses uses the same port
    /// at all of them, and nobody else on its host has that port.
    struct Voice {
        std::optional<std::uint16_t> port;
        Moment received;
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
    std::unordered_map<std::uint64_t, ReaderWindows> readers;  ///< the key combines its reader and our writer
    Budget unfinished{limits::UnfinishedSamples};

    /// Returns the state of a writer of this participant, or of its @p reader that answers our writer
    /// @p ours. Null: the participant never announced it and already uses many others that it never
    /// announced; the library ignores these. Never null for writers that every participant has.
    [[nodiscard]] Writer* writerOf(EntityId writer);
    [[nodiscard]] ReaderWindows* windowsOf(EntityId reader, EntityId ours);
    /// Returns whether @p voice speaks from @p place: the place has the port from which the voice was first
    /// heard. Another place takes over when nothing at all came from that port for limits::Silence. The home
    /// place takes over when nothing of this voice came for that time.
    [[nodiscard]] bool leads(const Voice& voice, const Place& place, Moment now) const;
    /// Returns whether a writer or reader speaks from @p place.
    [[nodiscard]] bool isVoice(const Place& place) const;
};

/// The participants of the domain that the screen has admitted; their number is limited for each host and in
/// total. Processes that were killed remain until their lease is over. Up to limits::LeasedOfHost, they do
/// not take the places of participants that speak.
class Participants {
public:
    [[nodiscard]] Remote* find(const Prefix& prefix);
    /// Admits the participant that @p declared announces. Null: its host, or all hosts together, have too
    /// many.
    Remote* admit(const Announcement& declared, const Address& host, Moment now);
    void remove(const Prefix& prefix);
    /// Forgets participants that have been silent for longer than their lease, as the library does.
    void forgetSilent(Moment now);

    /// Returns whether @p remote may send from @p place. It may if it was heard there before, or if the place
    /// is new and belongs to it as far as can be judged (docs/wire.md). Notes that it was heard there.
    /// @p speaks: whether it sends more than announcements of itself.
    [[nodiscard]] bool mayComeFrom(Remote& remote, const Place& place, bool speaks, Moment now);
    /// Returns whether @p remote announces itself from @p place, or may do so because its home is silent. An
    /// announcement may be changed or ended only from such a place. Otherwise anybody on the same host could
    /// have the participant removed while its new places are accepted. Keys do not prevent this, since
    /// announcements are not encrypted.
    [[nodiscard]] static bool isHome(const Remote& remote, const Place& place, Moment now);
    /// Makes @p place the home of @p remote, which has just announced itself from there.
    static void setHome(Remote& remote, const Place& place, Moment now);
    /// Returns whether a participant sends from @p place.
    [[nodiscard]] bool isKnown(const Place& place) const { return m_places.contains(place); }

    /// Returns whether some participant receives discovery on @p port, and none receives samples there.
    [[nodiscard]] bool receiveDiscoveryOnly(std::uint16_t port) const;

    /// Notes an endpoint whose announcement has @p bytes bytes. False: the host has too many, and @p remote
    /// is refused from now on.
    [[nodiscard]] bool addEndpoint(Remote& remote, EntityId endpoint, std::size_t bytes, Moment now);
    void removeEndpoint(Remote& remote, EntityId endpoint);

    [[nodiscard]] std::size_t size() const { return m_remotes.size(); }

private:
    using Remotes = std::unordered_map<Prefix, Remote, BytesHash>;
    struct Use {
        std::size_t participants = 0, endpoints = 0, bytes = 0;
    };
    void forget(Remotes::iterator one);
    /// Counts the participants of @p host that were heard within limits::Present, and their endpoints.
    [[nodiscard]] Use presentUse(const Address& host, Moment now) const;
    /// Notes that @p remote sends from @p place; false when it already sends from too many places.
    [[nodiscard]] bool bind(Remote& remote, const Place& place, bool speaks, Moment now);

    Remotes m_remotes;
    std::unordered_map<Address, Use, BytesHash> m_hosts;
    std::unordered_map<Place, int, BytesHash> m_places;  // how many participants send from there
    std::size_t m_endpoints = 0;
};

}  // namespace leitstand::screen
