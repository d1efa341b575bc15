#include "transport/screen/screen.h"

#include <algorithm>

namespace leitstand::screen {
namespace {

using Why = ScreenDrop::Kind;

bool isSample(const Submessage& one) {
    return one.kind == Kind::Data || one.kind == Kind::DataFrag;
}
bool isFromWriter(const Submessage& one) {
    return isSample(one) || one.kind == Kind::Heartbeat || one.kind == Kind::HeartbeatFrag ||
           one.kind == Kind::Gap;
}
bool isFromReader(const Submessage& one) {
    return one.kind == Kind::AckNack || one.kind == Kind::NackFrag;
}
bool announcesParticipant(const Submessage& one) {
    return one.kind == Kind::Data && one.writer == entity::ParticipantWriter;
}
bool announcesEndpoint(const Submessage& one) {
    return one.kind == Kind::Data &&
           (one.writer == entity::PublicationsWriter || one.writer == entity::SubscriptionsWriter);
}

/// Returns whether all of @p writer must come from one place. It announces who somebody is and which
/// endpoints he has; what is skipped or forged there is never corrected. That place need not be a
/// participant's home: Fast DDS announces itself to the group from other sockets than it uses to reach one
/// participant.
bool speaksFromOnePlace(EntityId writer) {
    return writer == entity::PublicationsWriter || writer == entity::SubscriptionsWriter ||
           writer == entity::AuthenticationWriter;
}

/// Returns whether @p one may travel without protection when messages are encrypted: announcements of
/// participants and proofs of identity. Keys are exchanged in submessages that are protected on their own.
bool mayBePlain(const Submessage& one) {
    if (one.protectedBySignature) return true;
    if (isFromReader(one)) return one.reader == entity::AuthenticationReader;
    if (isFromWriter(one))
        return one.writer == entity::ParticipantWriter || one.writer == entity::AuthenticationWriter;
    return true;
}

/// Checks the content of samples of writers that every participant has: the library trusts it.
Fault checkContent(const Submessage& one) {
    if (one.kind != Kind::Data || one.payload.empty() || one.isKey) return {};
    if (one.writer == entity::AuthenticationWriter) return checkAuthentication(one.payload);
    if (one.writer != entity::LivelinessWriter) return {};
    Prefix participant{};
    if (const Fault fault = checkLiveliness(one.payload, participant); !fault.empty()) return fault;
    return participant == one.source ? Fault{} : "liveliness of another participant";
}

Prefix participantOf(const GuidBytes& guid) {
    Prefix prefix{};
    std::copy_n(guid.begin(), prefix.size(), prefix.begin());
    return prefix;
}
EntityId entityOf(const GuidBytes& guid) {
    EntityId id = 0;
    for (std::size_t i = 12; i < guid.size(); ++i) id = id << 8 | guid[i];
    return id;
}

/// Returns the FNV-1a hash of what a participant announces.
std::uint64_t hashOf(std::span<const std::byte> bytes) {
    std::uint64_t hash = 0xcbf29ce484222325;
    for (const std::byte byte : bytes) hash = (hash ^ std::to_integer<std::uint64_t>(byte)) * 0x100000001b3;
    return hash;
}

}  // namespace

Screen::Verdict Screen::judgeStranger(const Place& place, Moment now) {
    if (m_participants.isKnown(place)) return {};
    if (m_strangers.size() >= limits::Strangers && !m_strangers.contains(place))
        m_strangers.erase(m_strangers.begin());
    Budget& budget = m_strangers.try_emplace(place, limits::StrangersPackets).first->second;
    if (budget.take(1, now, limits::StrangersPackets)) return {};
    return {false, Why::Flood, "too many packets of one that is no participant"};
}

Screen::Verdict Screen::judgeAnnouncement(const Submessage& next, const Place& place, Moment now) {
    static thread_local Announcement declared;
    if (const Fault fault = read(next, declared); !fault.empty()) return {false, Why::NoRtps, fault};
    const bool own = declared.participant == next.source;
    if (!own && !m_settings.relayed) return {false, Why::Impostor, "one participant announces another"};
    Remote* remote = m_participants.find(declared.participant);
    if (remote == nullptr) {
        if (declared.ends) return judgeStranger(place, now);
        if (remote = m_participants.admit(declared, place.address, now); remote == nullptr)
            return {false, Why::TooMany, "more participants than a host may have"};
    }
    if (remote->refused) return {false, Why::TooMany, "a participant that was refused"};
    const std::uint64_t hash = hashOf(next.payload);
    const bool changes = declared.ends || hash != remote->announcement;
    if (own && changes && !Participants::isHome(*remote, place, now))
        return {false, Why::Impostor, "a participant changes or ends from a place that is not its own"};
    if (own && !m_participants.mayComeFrom(*remote, place, false, now)) {
        // The same again, for example from another interface, changes nothing.
        if (!changes) return {};
        return {false, Why::Impostor, "a participant announced from a place that is not its own"};
    }
    if (own && changes) Participants::setHome(*remote, place, now);
    if (declared.ends) {
        m_participants.remove(declared.participant);
        return {};
    }
    if (!own) remote->received = now;
    remote->lease = declared.lease;
    remote->announced = declared.addresses;
    remote->discoveryPorts = declared.discoveryPorts;
    remote->samplePorts = declared.samplePorts;
    remote->announcement = hash;
    return {};
}

Screen::Verdict Screen::judgeEndpoint(const Submessage& next, Moment now) {
    EndpointAnnouncement declared;
    if (const Fault fault = read(next, declared); !fault.empty()) return {false, Why::NoRtps, fault};
    const Prefix owner = participantOf(declared.endpoint);
    if (owner != next.source && !m_settings.relayed)
        return {false, Why::Impostor, "one participant announces another's endpoint"};
    Remote* const remote = m_participants.find(owner);
    if (remote == nullptr) return {};
    if (declared.ends) {
        m_participants.removeEndpoint(*remote, entityOf(declared.endpoint));
        return {};
    }
    if (m_participants.addEndpoint(*remote, entityOf(declared.endpoint), next.payload.size(), now)) return {};
    return {false, Why::TooMany, "more endpoints than a host may have"};
}

Screen::Verdict Screen::judgeKnown(const Submessage& next, Remote& remote, const Place& place, Moment now) {
    if (isFromWriter(next)) {
        if (next.last > limits::MostNumber || next.first > limits::MostNumber)
            return {false, Why::Numbers, "a number that no writer reaches"};
        if (Remote::Writer* const writer = remote.writerOf(next.writer); writer != nullptr) {
            const bool leads = remote.leads(writer->voice, place, now);
            if (!leads && speaksFromOnePlace(next.writer))
                return {false, Why::Impostor,
                        "discovery or a proof of identity from a place that is not its own"};
            const Fault fault = writer->window.admit(next, leads, remote.unfinished, now);
            if (!fault.empty()) return {false, Why::Numbers, fault};
            if (leads) writer->voice = {place.port, now};
        }
    }
    if (isFromReader(next)) {
        if (next.last > limits::MostNumber) return {false, Why::Numbers, "a number that no writer reaches"};
        if (auto* const windows = remote.windowsOf(next.reader, next.writer); windows != nullptr) {
            CountWindow& counts = next.kind == Kind::AckNack ? windows->acknowledgements : windows->fragments;
            const bool leads = remote.leads(windows->voice, place, now);
            if (!counts.admits(next.count, leads, now))
                return {false, Why::Numbers, "a count of ACKNACK that jumps"};
            if (leads) windows->voice = {place.port, now};
        }
    }
    return announcesEndpoint(next) ? judgeEndpoint(next, now) : Verdict{};
}

Screen::Verdict Screen::judgeSpeaker(const Prefix& speaker, const Place& place, Moment now) {
    Remote* const remote = m_participants.find(speaker);
    if (remote == nullptr) return judgeStranger(place, now);
    if (remote->refused) return {false, Why::TooMany, "a participant that was refused"};
    if (m_participants.mayComeFrom(*remote, place, true, now)) return {};
    return {false, Why::Impostor, "a participant speaks from a place that is not its own"};
}

Screen::Verdict Screen::judgeOne(const Submessage& next, const Place& place, Moment now) {
    if (announcesParticipant(next)) return judgeAnnouncement(next, place, now);
    if (const Fault fault = checkContent(next); !fault.empty()) return {false, Why::NoRtps, fault};
    if (const Verdict verdict = judgeSpeaker(next.source, place, now); !verdict.passes) return verdict;
    Remote* const remote = m_participants.find(next.source);
    if (remote == nullptr) return {};
    return judgeKnown(next, *remote, place, now);
}

Screen::Verdict Screen::judge(const Datagram& datagram, const Place& place, Moment now) {
    if (now - m_swept > std::chrono::seconds(1)) {
        m_participants.forgetSilent(now);
        m_swept = now;
    }
    bool judged = false;
    for (const Submessage& next : datagram.submessages) {
        if (m_settings.encrypted && !mayBePlain(next)) return {false, Why::Plain, "is not encrypted"};
        if (!isFromWriter(next) && !isFromReader(next)) continue;
        if (const Verdict verdict = judgeOne(next, place, now); !verdict.passes) return verdict;
        judged = judged || next.source == datagram.speaker;
    }
    return judged ? Verdict{} : judgeSpeaker(datagram.speaker, place, now);
}

bool Screen::count(const Verdict& verdict, const Place& place, Moment now) {
    if (verdict.passes) {
        ++m_passed;
    } else {
        m_drops.note(verdict.why, place.address, verdict.fault);
        m_unreported = true;
    }
    if (!m_unreported || now - m_reported < std::chrono::seconds(1)) return false;
    m_unreported = false;
    m_reported = now;
    return true;
}

bool Screen::passes(std::span<const std::byte> bytes, const Place& place, Moment now) {
    static thread_local Datagram datagram;
    const Fault fault = parse(bytes, datagram);
    Verdict verdict{false, Why::NoRtps, fault};
    bool due = false;
    {
        const std::lock_guard lock(m_mutex);
        if (fault.empty()) verdict = judge(datagram, place, now);
        due = count(verdict, place, now);
    }
    if (due && m_dropped) m_dropped();
    return verdict.passes;
}

bool Screen::isDiscoveryPort(std::uint16_t port) const {
    const std::lock_guard lock(m_mutex);
    return m_participants.receiveDiscoveryOnly(port);
}

std::vector<ScreenDrop> Screen::drops() const {
    const std::lock_guard lock(m_mutex);
    return m_drops.drops();
}

std::uint64_t Screen::passed() const {
    const std::lock_guard lock(m_mutex);
    return m_passed;
}

Fault Screen::lastFault() const {
    const std::lock_guard lock(m_mutex);
    return m_drops.lastFault();
}

}  // namespace leitstand::screen
