#include "transport/dds/detail/discovery.h"

#include <algorithm>
#include <cstdint>
#include <set>
#include <string_view>

#include "core/base/time.h"
#include "transport/dds/detail/convert.h"
#include "transport/dds/detail/endpoint_qos.h"
#include "transport/dds/names.h"

namespace leitstand::detail {
namespace {

namespace efd = eprosima::fastdds::dds;
namespace rtps = fastdds::rtps;
using Clock = std::chrono::steady_clock;

constexpr auto SecureMatchTime = std::chrono::seconds(2);  // keys are exchanged before endpoints match

std::string addressOf(const rtps::RemoteLocatorList& locators) {
    for (const auto& locator : locators.unicast) {
        if (locator.kind == LOCATOR_KIND_UDPv4) return rtps::IPLocator::toIPv4string(locator);
    }
    return {};
}

std::string hostOf(const fastdds::ParticipantData& data) {
    for (const auto& property : fastdds::propertiesOf(data)) {
        if (property.first() != efd::parameter_policy_physical_data_host) continue;
        // "name:number of the machine"
        if (const std::string host = property.second(); !host.empty()) return host.substr(0, host.find(':'));
    }
    const std::string address = addressOf(data.metatraffic_locators);
    return address.empty() ? addressOf(data.default_locators) : address;
}

bool speaksXcdr1(const fastdds::EndpointData& data) {
    const auto& listed = data.representation.m_value;  // nothing listed means XCDR1
    return listed.empty() ||
           std::find(listed.begin(), listed.end(), efd::XCDR_DATA_REPRESENTATION) != listed.end();
}

Guid participantOf(const rtps::GUID_t& endpoint) {
    return guidOf(rtps::GUID_t(endpoint.guidPrefix, rtps::c_EntityId_RTPSParticipant));
}

/// Returns the type's hash in what an endpoint says about itself, "key=value;key=value;"; empty: there is
/// none.
std::string typeHashIn(const std::vector<std::uint8_t>& userData) {
    constexpr std::string_view Key = "typehash=", Version = "RIHS01_";
    constexpr std::size_t Digits = 64;
    const std::string_view text(reinterpret_cast<const char*>(userData.data()), userData.size());
    const std::size_t key = text.find(Key);
    if (key == std::string_view::npos) return {};
    const std::string_view hash = text.substr(key + Key.size(), Version.size() + Digits);
    const bool right = hash.size() == Version.size() + Digits && hash.starts_with(Version) &&
                       std::all_of(hash.begin() + Version.size(), hash.end(),
                                   [](char c) { return (c >= '0' && c <= '9') || (c >= 'a' && c <= 'f'); });
    return right ? std::string(hash) : std::string();
}

}  // namespace

Discovery::Discovery(std::function<void()> changed, bool secure)
    : m_changed(std::move(changed)), m_secure(secure) {}

void Discovery::participantSeen(const fastdds::ParticipantData& data) {
    const Guid guid = guidOf(fastdds::guidOf(data));
    {
        const std::scoped_lock lock(m_mutex);
        RemoteParticipant& participant = known(guid);
        participant.name = fastdds::nameOf(data);
        participant.host = hostOf(data);
    }
    m_changed();
}

void Discovery::participantGone(const rtps::GUID_t& gone) {
    const Guid guid = guidOf(gone);
    {
        const std::scoped_lock lock(m_mutex);
        m_participants.erase(guid);
        std::erase_if(m_endpoints,
                      [&](const auto& known) { return known.second.endpoint.participant == guid; });
    }
    m_changed();
}

void Discovery::participantJudged(const rtps::GUID_t& judged, bool refused) {
    const Guid guid = guidOf(judged);
    {
        const std::scoped_lock lock(m_mutex);
        RemoteParticipant& participant = known(guid);
        participant.refused = refused;
    }
    m_changed();
}

void Discovery::note(const fastdds::EndpointData& data, RemoteEndpoint::Kind kind, const MatchTerms& terms) {
    RemoteEndpoint endpoint;
    endpoint.kind = kind;
    endpoint.guid = guidOf(data.guid);
    endpoint.participant = participantOf(data.guid);
    endpoint.ros = data.topic.starts_with("rt/");
    endpoint.topic = rosTopicOf(data.topic);
    endpoint.type = rosTypeOf(data.type);
    endpoint.keyed = data.keyed;
    endpoint.exclusiveOwnership = data.exclusive;
    endpoint.typeHash = typeHashIn(data.userData);
    endpoint.partitions = data.partitions;
    endpoint.qos = qosOf(data, 1);
    {
        const std::scoped_lock lock(m_mutex);
        const auto [place, added] = m_endpoints.try_emplace(endpoint.guid);
        if (added) place->second.since = Clock::now();
        place->second.endpoint = std::move(endpoint);
        place->second.terms = terms;
    }
    m_changed();
}

void Discovery::endpointGone(const rtps::GUID_t& endpoint) {
    {
        const std::scoped_lock lock(m_mutex);
        m_endpoints.erase(guidOf(endpoint));
    }
    m_changed();
}

void Discovery::writerSeen(const fastdds::EndpointData& data) {
    MatchTerms terms;
    terms.xcdr1 = speaksXcdr1(data);
    note(data, RemoteEndpoint::Kind::Writer, terms);
}

void Discovery::readerSeen(const fastdds::EndpointData& data) {
    MatchTerms terms;
    terms.xcdr1 = speaksXcdr1(data);
    terms.automaticLiveliness = data.liveliness.kind == efd::AUTOMATIC_LIVELINESS_QOS &&
                                data.liveliness.lease_duration == fastdds::Infinite;
    note(data, RemoteEndpoint::Kind::Reader, terms);
}

void Discovery::add(const Guid& local, LocalEndpoint endpoint) {
    {
        const std::scoped_lock lock(m_mutex);
        auto matched = std::move(m_local[local].matched);  // a match may already have been reported
        m_local[local] = std::move(endpoint);
        m_local[local].matched.merge(matched);
    }
    m_changed();
}

void Discovery::remove(const Guid& local) {
    {
        const std::scoped_lock lock(m_mutex);
        m_local.erase(local);
    }
    m_changed();
}

void Discovery::matched(const Guid& local, const Guid& remote, bool now) {
    {
        const std::scoped_lock lock(m_mutex);
        if (now) m_local[local].matched.insert(remote);
        if (!now && m_local.contains(local)) m_local[local].matched.erase(remote);
    }
    m_changed();
}

RemoteParticipant& Discovery::known(const Guid& participant) {
    const auto [place, added] = m_participants.try_emplace(participant);
    if (added) {
        place->second.participant.guid = participant;
        place->second.since = Clock::now();
    }
    return place->second.participant;
}

void Discovery::clear() {
    {
        const std::scoped_lock lock(m_mutex);
        m_participants.clear();
        m_endpoints.clear();
        m_local.clear();
    }
    m_changed();
}

std::vector<Guid> Discovery::matchedWith(const Guid& local) const {
    const std::scoped_lock lock(m_mutex);
    const auto found = m_local.find(local);
    if (found == m_local.end()) return {};
    return {found->second.matched.begin(), found->second.matched.end()};
}

std::map<Guid, LocalEndpoint> Discovery::local() const {
    const std::scoped_lock lock(m_mutex);
    return m_local;
}

RemoteEndpoint Discovery::named(RemoteEndpoint endpoint) const {
    if (const auto found = m_participants.find(endpoint.participant); found != m_participants.end()) {
        endpoint.participantName = found->second.participant.name;
        endpoint.host = found->second.participant.host;
    }
    return endpoint;
}

std::vector<RemoteParticipant> Discovery::participants() const {
    const std::scoped_lock lock(m_mutex);
    std::vector<RemoteParticipant> all;
    for (const auto& [guid, known] : m_participants) all.push_back(known.participant);
    return all;
}

std::vector<RemoteEndpoint> Discovery::endpoints() const {
    const std::scoped_lock lock(m_mutex);
    std::vector<RemoteEndpoint> all;
    for (const auto& [guid, known] : m_endpoints) all.push_back(named(known.endpoint));
    return all;
}

DomainReception Discovery::reception() const {
    const std::scoped_lock lock(m_mutex);
    const auto now = Clock::now();
    const auto secondsSince = [now](Clock::time_point since) { return toSeconds(now - since); };
    DomainReception reception;
    std::set<Guid> speaking;
    for (const auto& [guid, known] : m_endpoints) {
        const RemoteEndpoint& theirs = known.endpoint;
        speaking.insert(theirs.participant);
        if (theirs.kind != RemoteEndpoint::Kind::Writer) continue;
        bool listened = false, matched = false;
        for (const auto& [ownGuid, ours] : m_local) {
            if (ours.kind != LocalEndpoint::Kind::Reader || rosTopicOf(ours.ddsTopic) != theirs.topic)
                continue;
            listened = true;
            matched = matched || ours.matched.contains(guid);
        }
        if (!listened) continue;
        reception.writers.push_back({guid, theirs.participant, theirs.topic, secondsSince(known.since),
                                     matched, theirs.qos.reliability == Qos::Reliability::BestEffort, false});
    }
    for (const auto& [guid, known] : m_participants) {
        if (!speaking.contains(guid))
            reception.mute.push_back({known.participant, secondsSince(known.since)});
    }
    return reception;
}

std::vector<Mismatch> Discovery::mismatches() const {
    const std::scoped_lock lock(m_mutex);
    std::vector<Mismatch> all;
    for (const auto& [ownGuid, ours] : m_local) {
        const auto theirKind = ours.kind == LocalEndpoint::Kind::Reader ? RemoteEndpoint::Kind::Writer
                                                                        : RemoteEndpoint::Kind::Reader;
        const std::string topic = rosTopicOf(ours.ddsTopic);  // once: others may have thousands of endpoints
        for (const auto& [guid, known] : m_endpoints) {
            const RemoteEndpoint& theirs = known.endpoint;
            const bool sameTopic = theirs.kind == theirKind && theirs.topic == topic;
            if (!sameTopic || ours.matched.contains(guid)) continue;
            auto why = whyNoMatch(ours, theirs, known.terms);
            if (why.empty() && m_secure && Clock::now() - known.since > SecureMatchTime)
                why.push_back({WireProblem::Kind::Security});
            if (!why.empty()) all.push_back({{theirs.topic, std::move(why)}, guid});
        }
    }
    return all;
}

}  // namespace leitstand::detail
