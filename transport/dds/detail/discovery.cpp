#include "transport/dds/detail/discovery.h"

#include <algorithm>
#include <set>

#include <fastdds/rtps/builtin/data/ParticipantProxyData.h>
#include <fastdds/rtps/builtin/data/ReaderProxyData.h>
#include <fastdds/rtps/builtin/data/WriterProxyData.h>
#include <fastrtps/utils/IPLocator.h>
#include <fastdds/dds/core/policy/ParameterTypes.hpp>

#include "transport/dds/detail/convert.h"
#include "transport/dds/detail/endpoint_qos.h"
#include "transport/dds/names.h"

namespace leitstand::detail {
namespace {

namespace efd = eprosima::fastdds::dds;
namespace rtps = eprosima::fastrtps::rtps;
using Clock = std::chrono::steady_clock;

constexpr auto SecureMatchTime = std::chrono::seconds(2);  // keys are exchanged before endpoints match

std::string addressOf(const rtps::RemoteLocatorList& locators) {
    for (const auto& locator : locators.unicast) {
        if (locator.kind == LOCATOR_KIND_UDPv4) return rtps::IPLocator::toIPv4string(locator);
    }
    return {};
}

std::string hostOf(const rtps::ParticipantProxyData& data) {
    for (const auto& property : data.m_properties) {
        if (property.first() != efd::parameter_policy_physical_data_host) continue;
        // "name:number of the machine"
        if (const std::string host = property.second(); !host.empty()) return host.substr(0, host.find(':'));
    }
    const std::string address = addressOf(data.metatraffic_locators);
    return address.empty() ? addressOf(data.default_locators) : address;
}

template <class Policies>
bool speaksXcdr1(const Policies& policies) {
    const auto& listed = policies.representation.m_value;  // nothing listed means XCDR1
    return listed.empty() ||
           std::find(listed.begin(), listed.end(), efd::XCDR_DATA_REPRESENTATION) != listed.end();
}

Guid participantOf(const rtps::GUID_t& endpoint) {
    return guidOf(rtps::GUID_t(endpoint.guidPrefix, rtps::c_EntityId_RTPSParticipant));
}

}  // namespace

Discovery::Discovery(std::function<void()> changed, bool secure)
    : m_changed(std::move(changed)), m_secure(secure) {}

void Discovery::on_participant_discovery(Participant*, rtps::ParticipantDiscoveryInfo&& info) {
    using Info = rtps::ParticipantDiscoveryInfo;
    const Guid guid = guidOf(info.info.m_guid);
    {
        const std::scoped_lock lock(m_mutex);
        if (info.status == Info::REMOVED_PARTICIPANT || info.status == Info::DROPPED_PARTICIPANT) {
            m_participants.erase(guid);
            std::erase_if(m_endpoints,
                          [&](const auto& known) { return known.second.endpoint.participant == guid; });
        } else {
            RemoteParticipant& participant = known(guid);
            participant.name = info.info.m_participantName.to_string();
            participant.host = hostOf(info.info);
        }
    }
    m_changed();
}

void Discovery::onParticipantAuthentication(Participant*, rtps::ParticipantAuthenticationInfo&& info) {
    const Guid guid = guidOf(info.guid);
    {
        const std::scoped_lock lock(m_mutex);
        RemoteParticipant& participant = known(guid);
        participant.refused = info.status == rtps::ParticipantAuthenticationInfo::UNAUTHORIZED_PARTICIPANT;
    }
    m_changed();
}

template <class ProxyData>
void Discovery::note(const ProxyData& data, RemoteEndpoint::Kind kind, const MatchTerms& terms) {
    RemoteEndpoint endpoint;
    endpoint.kind = kind;
    endpoint.guid = guidOf(data.guid());
    endpoint.participant = participantOf(data.guid());
    const std::string topic = data.topicName().to_string();
    endpoint.ros = topic.starts_with("rt/");
    endpoint.topic = rosTopicOf(topic);
    endpoint.type = rosTypeOf(data.typeName().to_string());
    endpoint.keyed = data.topicKind() == rtps::WITH_KEY;
    endpoint.exclusiveOwnership = data.m_qos.m_ownership.kind == efd::EXCLUSIVE_OWNERSHIP_QOS;
    endpoint.partitions = data.m_qos.m_partition.getNames();
    endpoint.qos = qosOf(data.m_qos, 1);
    {
        const std::scoped_lock lock(m_mutex);
        const auto [place, added] = m_endpoints.try_emplace(endpoint.guid);
        if (added) place->second.since = Clock::now();
        place->second.endpoint = std::move(endpoint);
        place->second.terms = terms;
    }
    m_changed();
}

void Discovery::forget(const Guid& endpoint) {
    {
        const std::scoped_lock lock(m_mutex);
        m_endpoints.erase(endpoint);
    }
    m_changed();
}

void Discovery::on_publisher_discovery(Participant*, rtps::WriterDiscoveryInfo&& info) {
    if (info.status == rtps::WriterDiscoveryInfo::REMOVED_WRITER) return forget(guidOf(info.info.guid()));
    MatchTerms terms;
    terms.xcdr1 = speaksXcdr1(info.info.m_qos);
    note(info.info, RemoteEndpoint::Kind::Writer, terms);
}

void Discovery::on_subscriber_discovery(Participant*, rtps::ReaderDiscoveryInfo&& info) {
    if (info.status == rtps::ReaderDiscoveryInfo::REMOVED_READER) return forget(guidOf(info.info.guid()));
    const auto& liveliness = info.info.m_qos.m_liveliness;
    MatchTerms terms;
    terms.xcdr1 = speaksXcdr1(info.info.m_qos);
    terms.automaticLiveliness = liveliness.kind == efd::AUTOMATIC_LIVELINESS_QOS &&
                                liveliness.lease_duration == eprosima::fastrtps::c_TimeInfinite;
    note(info.info, RemoteEndpoint::Kind::Reader, terms);
}

void Discovery::add(const Guid& local, LocalEndpoint endpoint) {
    {
        const std::scoped_lock lock(m_mutex);
        auto matched = std::move(m_local[local].matched);  // a match may have been faster than we are
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

DomainHearing Discovery::hearing() const {
    const std::scoped_lock lock(m_mutex);
    const auto now = Clock::now();
    const auto secondsSince = [now](Clock::time_point since) {
        return std::chrono::duration<double>(now - since).count();
    };
    DomainHearing hearing;
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
        hearing.writers.push_back({guid, theirs.participant, theirs.topic, secondsSince(known.since), matched,
                                   theirs.qos.reliability == Qos::Reliability::BestEffort, false});
    }
    for (const auto& [guid, known] : m_participants) {
        if (!speaking.contains(guid)) hearing.mute.push_back({known.participant, secondsSince(known.since)});
    }
    return hearing;
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
