#pragma once

#include <optional>
#include <unordered_map>
#include <unordered_set>
#include <vector>

#include "transport/screen/parameters.h"
#include "transport/screen/place.h"
#include "transport/screen/windows.h"

namespace leitstand::screen {

/// A participant of the domain that the screen let in, with what the screen remembers of it.
struct Remote {
    struct Bound {
        Place place;
        Moment received;
        bool speaks = false;  ///< more than announcements of itself came from there
    };
    Address host{};  ///< the host whose limits it counts against
    Place home;      ///< where it announces itself from; changes only after silence there
    Moment atHome;   ///< when it was last heard at home
    Moment first, received;
    Seconds lease{0.0};
    bool refused = false;            ///< it exceeded what a host may have: nothing of it passes
    std::vector<Address> announced;  ///< addresses that it claims to have
    std::vector<std::uint16_t> discoveryPorts, samplePorts;  ///< ports that it claims to receive on
    std::uint64_t announcement = 0;                          ///< hash of what it announced last
    std::vector<Bound> places;                               ///< where it sends from
    std::unordered_map<EntityId, std::size_t> endpoints;     ///< size of the announcement of each [B]
    /// The port from which a writer or reader speaks. A participant with several addresses uses the same port
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
    std::unordered_map<std::uint64_t, ReaderWindows> readers;  ///< key: its reader and our writer
    Budget unfinished{limits::UnfinishedSamples};

    /// Returns the state of a writer of this participant, or of its @p reader that answers our writer
    /// @p ours. Null when the participant never announced it and already uses many that it never announced:
    /// the library ignores these. Never null for writers that every participant has.
    [[nodiscard]] Writer* writerOf(EntityId writer);
    [[nodiscard]] ReaderWindows* windowsOf(EntityId reader, EntityId ours);
    /// Returns whether @p place is where @p voice speaks from: it has the port where the voice was heard
    /// first. Another place takes over when nothing at all came from that port for limits::Silence. Home
    /// takes over when nothing of this voice came for that time.
    [[nodiscard]] bool leads(const Voice& voice, const Place& place, Moment now) const;
    /// Returns whether a writer or reader speaks from @p place.
    [[nodiscard]] bool isVoice(const Place& place) const;
};

/// The participants of the domain that the screen let in: bounded for each host and in total. Processes that
/// were killed stay in memory until their lease is over. Up to limits::LeasedOfHost they take no place from
/// those that speak.
class Participants {
public:
    [[nodiscard]] Remote* find(const Prefix& prefix);
    /// Lets in the participant that @p declared announces; null when its host, or all hosts together, have
    /// too many.
    Remote* admit(const Announcement& declared, const Address& host, Moment now);
    void remove(const Prefix& prefix);
    /// Forgets participants that were silent for longer than their lease, as the library does.
    void forgetSilent(Moment now);

    /// Returns whether @p remote may send from @p place: where it was heard before, or a new place that is
    /// its own as far as can be judged (docs/wire.md). Notes that it was heard there. @p speaks: it does not
    /// only announce itself.
    [[nodiscard]] bool mayComeFrom(Remote& remote, const Place& place, bool speaks, Moment now);
    /// Returns whether @p remote announces itself from @p place, or may do so because its home is silent. An
    /// announcement may be changed or ended only from such a place. Otherwise anybody on the same host could
    /// have the participant removed while its new places are accepted; with keys, too, since announcements
    /// are plain.
    [[nodiscard]] static bool isHome(const Remote& remote, const Place& place, Moment now);
    /// Makes @p place the home of @p remote, which has just announced itself from there.
    static void setHome(Remote& remote, const Place& place, Moment now);
    /// Returns whether a participant sends from @p place.
    [[nodiscard]] bool isKnown(const Place& place) const { return m_places.contains(place); }

    /// Returns whether a participant receives discovery on @p port, and none receives samples there.
    [[nodiscard]] bool receiveDiscoveryOnly(std::uint16_t port) const;

    /// Notes an endpoint whose announcement has @p bytes. False when the host has too many: @p remote is
    /// refused from then on.
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
