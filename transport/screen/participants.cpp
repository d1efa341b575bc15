#include "transport/screen/participants.h"

#include <algorithm>

namespace leitstand::screen {
namespace {

template <class Value>
bool contains(const std::vector<Value>& values, const Value& value) {
    return std::find(values.begin(), values.end(), value) != values.end();
}

bool isOfEveryParticipant(EntityId writer) {
    return writer == entity::ParticipantWriter || writer == entity::PublicationsWriter ||
           writer == entity::SubscriptionsWriter || writer == entity::LivelinessWriter ||
           writer == entity::AuthenticationWriter;
}

}  // namespace

Remote::Writer* Remote::writerOf(EntityId writer) {
    if (const auto known = writers.find(writer); known != writers.end()) return &known->second;
    const bool many = writers.size() >= endpoints.size() + limits::UnannouncedWindows;
    if (many && !isOfEveryParticipant(writer)) return nullptr;
    return &writers[writer];
}

Remote::ReaderWindows* Remote::windowsOf(EntityId reader, EntityId ours) {
    const std::uint64_t both = std::uint64_t(reader) << 32 | ours;
    if (const auto known = readers.find(both); known != readers.end()) return &known->second;
    if (readers.size() >= 2 * endpoints.size() + limits::UnannouncedWindows) return nullptr;
    return &readers[both];
}

bool Remote::leads(const Voice& voice, const Place& place, Moment now) const {
    if (!voice.port || place.port == *voice.port) return true;
    if (place == home && now - voice.received > limits::Silence) return true;
    return std::none_of(places.begin(), places.end(), [&](const Bound& bound) {
        return bound.place.port == *voice.port && now - bound.received <= limits::Silence;
    });
}

bool Remote::isVoice(const Place& place) const {
    const auto speaks = [&](const auto& one) { return one.second.voice.port == place.port; };
    return std::any_of(writers.begin(), writers.end(), speaks) ||
           std::any_of(readers.begin(), readers.end(), speaks);
}

Remote* Participants::find(const Prefix& prefix) {
    const auto found = m_remotes.find(prefix);
    return found == m_remotes.end() ? nullptr : &found->second;
}

Remote* Participants::admit(const Announcement& declared, const Address& host, Moment now) {
    const auto full = [&] {
        if (m_remotes.size() >= limits::Participants) return true;
        const auto use = m_hosts.find(host);
        if (use == m_hosts.end() || use->second.participants < limits::ParticipantsOfHost) return false;
        return use->second.participants >= limits::LeasedOfHost ||
               presentUse(host, now).participants >= limits::ParticipantsOfHost;
    };
    if (full()) forgetSilent(now);
    if (full()) return nullptr;
    Remote& remote = m_remotes[declared.participant];
    remote.host = host;
    remote.first = remote.received = now;
    ++m_hosts[host].participants;
    return &remote;
}

Participants::Use Participants::presentUse(const Address& host, Moment now) const {
    Use use;
    for (const auto& [prefix, remote] : m_remotes) {
        if (remote.host != host || now - remote.received > limits::Present) continue;
        ++use.participants;
        use.endpoints += remote.endpoints.size();
    }
    return use;
}

void Participants::forget(Remotes::iterator one) {
    Remote& remote = one->second;
    for (const Remote::Bound& bound : remote.places) {
        if (const auto place = m_places.find(bound.place); --place->second == 0) m_places.erase(place);
    }
    const auto use = m_hosts.find(remote.host);
    for (const auto& [endpoint, bytes] : remote.endpoints) use->second.bytes -= bytes;
    use->second.endpoints -= remote.endpoints.size();
    m_endpoints -= remote.endpoints.size();
    if (--use->second.participants == 0) m_hosts.erase(use);
    m_remotes.erase(one);
}

void Participants::remove(const Prefix& prefix) {
    if (const auto found = m_remotes.find(prefix); found != m_remotes.end()) forget(found);
}

void Participants::forgetSilent(Moment now) {
    constexpr Seconds Late{1.0};  // the library looks at its clock later than we at ours
    for (auto one = m_remotes.begin(); one != m_remotes.end();) {
        const auto next = std::next(one);
        if (Seconds(now - one->second.received) > one->second.lease + Late) forget(one);
        one = next;
    }
}

bool Participants::isHome(const Remote& remote, const Place& place, Moment now) {
    return remote.places.empty() || place == remote.home || now - remote.atHome > limits::Silence;
}

void Participants::setHome(Remote& remote, const Place& place, Moment now) {
    remote.home = place;
    remote.atHome = now;
}

bool Participants::bind(Remote& remote, const Place& place, bool speaks, Moment now) {
    if (remote.places.size() >= limits::PlacesOfParticipant) {
        // Keeps home and the places where it speaks from: else a handful of ports would displace them.
        auto oldest = remote.places.end();
        for (auto one = remote.places.begin(); one != remote.places.end(); ++one) {
            const bool silent = now - one->received > limits::Silence;
            if (!silent && (one->place == remote.home || remote.isVoice(one->place))) continue;
            if (oldest == remote.places.end() || one->received < oldest->received) oldest = one;
        }
        if (oldest == remote.places.end()) return false;
        if (const auto known = m_places.find(oldest->place); --known->second == 0) m_places.erase(known);
        remote.places.erase(oldest);
    }
    remote.places.push_back({place, now, speaks});
    ++m_places[place];
    return true;
}

bool Participants::mayComeFrom(Remote& remote, const Place& place, bool speaks, Moment now) {
    auto& places = remote.places;
    const auto known = std::find_if(places.begin(), places.end(),
                                    [&](const Remote::Bound& bound) { return bound.place == place; });
    if (known != places.end()) {
        known->received = remote.received = now;
        if (place == remote.home) remote.atHome = now;
        known->speaks = known->speaks || speaks;
        return true;
    }
    const auto all = [&](auto holds) { return std::all_of(places.begin(), places.end(), holds); };
    const bool silent =
        all([&](const Remote::Bound& bound) { return now - bound.received > limits::Silence; });
    const bool mute = all([](const Remote::Bound& bound) { return !bound.speaks; });
    const bool sameHost = std::any_of(places.begin(), places.end(), [&](const Remote::Bound& bound) {
        return bound.place.address == place.address;
    });
    const bool itsOwn =
        silent || sameHost || isLoopback(place.address) || contains(remote.announced, place.address);
    if (!itsOwn || !(silent || mute || now - remote.first < limits::Introduction)) return false;
    if (!bind(remote, place, speaks, now)) return false;
    remote.received = now;
    return true;
}

bool Participants::receiveDiscoveryOnly(std::uint16_t port) const {
    const auto one = [&](auto receives) { return std::any_of(m_remotes.begin(), m_remotes.end(), receives); };
    return one([&](const auto& remote) { return contains(remote.second.discoveryPorts, port); }) &&
           !one([&](const auto& remote) { return contains(remote.second.samplePorts, port); });
}

bool Participants::addEndpoint(Remote& remote, EntityId endpoint, std::size_t bytes, Moment now) {
    Use& use = m_hosts[remote.host];
    const auto [place, isNew] = remote.endpoints.try_emplace(endpoint, 0);
    if (bytes > place->second) {
        use.bytes += bytes - place->second;
        place->second = bytes;
    }
    use.endpoints += isNew ? 1 : 0;
    m_endpoints += isNew ? 1 : 0;
    const bool few = use.endpoints <= limits::EndpointsOfHost ||
                     (use.endpoints <= limits::LeasedEndpointsOfHost &&
                      presentUse(remote.host, now).endpoints <= limits::EndpointsOfHost);
    const bool fits = few && m_endpoints <= limits::Endpoints && use.bytes <= limits::AnnouncedBytesOfHost;
    if (!fits) {
        removeEndpoint(remote, endpoint);
        remote.refused = true;
    }
    return fits;
}

void Participants::removeEndpoint(Remote& remote, EntityId endpoint) {
    const auto known = remote.endpoints.find(endpoint);
    if (known == remote.endpoints.end()) return;
    Use& use = m_hosts[remote.host];
    use.bytes -= known->second;
    --use.endpoints;
    --m_endpoints;
    remote.endpoints.erase(known);
}

}  // namespace leitstand::screen
