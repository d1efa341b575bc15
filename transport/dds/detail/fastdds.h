#pragma once

// The only file that knows Fast DDS's versions: 2.9 of Debian 12 and 3.1 of Debian 13. What differs between
// the two has one name here; the rest of transport writes `fastdds::rtps::Locator_t`, `efd::DataWriter`...

#if __has_include(<fastdds/LibrarySettings.hpp>)
#define LEITSTAND_FASTDDS_3 1
#define LEITSTAND_FLOW_CONTROLLERS (FASTDDS_VERSION_MAJOR > 3 || FASTDDS_VERSION_MINOR > 1)
#include <fastdds/LibrarySettings.hpp>
#include <fastdds/rtps/attributes/RTPSParticipantAttributes.hpp>
#include <fastdds/rtps/builtin/data/ParticipantBuiltinTopicData.hpp>
#include <fastdds/rtps/builtin/data/PublicationBuiltinTopicData.hpp>
#include <fastdds/rtps/builtin/data/SubscriptionBuiltinTopicData.hpp>
#include <fastdds/rtps/common/Guid.hpp>
#include <fastdds/rtps/common/SampleIdentity.hpp>
#include <fastdds/rtps/common/SequenceNumber.hpp>
#include <fastdds/rtps/common/Time_t.hpp>
#include <fastdds/rtps/common/WriteParams.hpp>
#include <fastdds/rtps/transport/ChainingTransport.hpp>
#include <fastdds/rtps/transport/ChainingTransportDescriptor.hpp>
#include <fastdds/rtps/transport/NetworkBuffer.hpp>
#include <fastdds/rtps/transport/TCPv4TransportDescriptor.hpp>
#include <fastdds/rtps/transport/UDPTransportDescriptor.hpp>
#include <fastdds/rtps/transport/UDPv4TransportDescriptor.hpp>
#include <fastdds/rtps/transport/shared_mem/SharedMemTransportDescriptor.hpp>
#include <fastdds/utils/IPLocator.hpp>
#else
#define LEITSTAND_FASTDDS_3 0
#define LEITSTAND_FLOW_CONTROLLERS true
#include <fastdds/rtps/attributes/ServerAttributes.h>
#include <fastdds/rtps/builtin/data/ParticipantProxyData.h>
#include <fastdds/rtps/builtin/data/ReaderProxyData.h>
#include <fastdds/rtps/builtin/data/WriterProxyData.h>
#include <fastdds/rtps/common/Guid.h>
#include <fastdds/rtps/common/SampleIdentity.h>
#include <fastdds/rtps/common/SequenceNumber.h>
#include <fastdds/rtps/common/Time_t.h>
#include <fastdds/rtps/common/WriteParams.h>
#include <fastdds/rtps/transport/ChainingTransport.h>
#include <fastdds/rtps/transport/ChainingTransportDescriptor.h>
#include <fastdds/rtps/transport/TCPv4TransportDescriptor.h>
#include <fastdds/rtps/transport/UDPTransportDescriptor.h>
#include <fastdds/rtps/transport/UDPv4TransportDescriptor.h>
#include <fastdds/rtps/transport/shared_mem/SharedMemTransportDescriptor.h>
#include <fastrtps/attributes/LibrarySettingsAttributes.h>
#include <fastrtps/utils/IPLocator.h>
#include <fastrtps/xmlparser/XMLProfileManager.h>
#endif

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include <fastdds/dds/core/policy/ParameterTypes.hpp>
#include <fastdds/dds/core/policy/QosPolicies.hpp>
#include <fastdds/dds/domain/DomainParticipantFactory.hpp>
#include <fastdds/dds/domain/DomainParticipantListener.hpp>
#include <fastdds/dds/publisher/DataWriter.hpp>
#include <fastdds/dds/publisher/qos/DataWriterQos.hpp>
#include <fastdds/dds/subscriber/DataReader.hpp>
#include <fastdds/dds/subscriber/qos/DataReaderQos.hpp>
#include <fastdds/dds/topic/TopicDataType.hpp>

namespace leitstand::detail::fastdds {

namespace dds = eprosima::fastdds::dds;

#if LEITSTAND_FASTDDS_3
namespace rtps = eprosima::fastdds::rtps;
using Duration = dds::Duration_t;
inline const Duration Infinite = dds::c_TimeInfinite;
inline const Duration Zero = dds::c_TimeZero;
inline constexpr const char* ProfilesVariable = "FASTDDS_DEFAULT_PROFILES_FILE";
/// XML namespace of the root element in a profiles file for this version of Fast DDS.
inline constexpr const char* ProfilesNamespace = "http://www.eprosima.com";
using ParticipantData = rtps::ParticipantBuiltinTopicData;
using WriterData = rtps::PublicationBuiltinTopicData;
using ReaderData = rtps::SubscriptionBuiltinTopicData;
/// A datagram for a transport to send, in one piece or several.
using Outgoing = const std::vector<rtps::NetworkBuffer>&;
#else
namespace rtps = eprosima::fastrtps::rtps;
using Duration = eprosima::fastrtps::Duration_t;
inline const Duration Infinite = eprosima::fastrtps::c_TimeInfinite;
inline const Duration Zero = eprosima::fastrtps::c_TimeZero;
inline constexpr const char* ProfilesVariable = "FASTRTPS_DEFAULT_PROFILES_FILE";
inline constexpr const char* ProfilesNamespace = "http://www.eprosima.com/XMLSchemas/fastRTPS_Profiles";
using ParticipantData = rtps::ParticipantProxyData;
using WriterData = rtps::WriterProxyData;
using ReaderData = rtps::ReaderProxyData;
using Outgoing = const rtps::octet*;
#endif

/// Whether participants may have flow controllers; not with Fast DDS 3.1. There, a participant with flow
/// controllers announces itself from a thread. If two others appear at the same time, the next announcement
/// is due before that thread has run. An assertion, which is active in Debian, then ends the process. Version
/// 3.2 announces in the same way as 2.9.
inline constexpr bool HasFlowControllers = LEITSTAND_FLOW_CONTROLLERS;

/// Converts @p duration to seconds; 0 when it is infinite.
[[nodiscard]] inline double secondsOf(const Duration& duration) {
    return duration == Infinite
               ? 0.0
               : static_cast<double>(duration.seconds) + static_cast<double>(duration.nanosec) * 1e-9;
}

/// Returns whether a call of the library succeeded.
template <class Code>
[[nodiscard]] bool succeeded(const Code& code) {
#if LEITSTAND_FASTDDS_3
    return code == dds::RETCODE_OK;
#else
    return code == ReturnCode_t::RETCODE_OK;
#endif
}

/// Writes @p sample; returns whether the writer's history accepted it.
[[nodiscard]] inline bool write(dds::DataWriter& writer, void* sample) {
#if LEITSTAND_FASTDDS_3
    return succeeded(writer.write(sample));
#else
    return writer.write(sample);
#endif
}

/// Writes @p sample with @p parameters, which receive its number; returns whether the history accepted it.
[[nodiscard]] inline bool write(dds::DataWriter& writer, void* sample, rtps::WriteParams& parameters) {
#if LEITSTAND_FASTDDS_3
    return succeeded(writer.write(sample, parameters));
#else
    return writer.write(sample, parameters);
#endif
}

/// Returns @p bytes as a datagram for a transport to send.
[[nodiscard]] inline std::remove_cvref_t<Outgoing> outgoing(std::span<const std::byte> bytes) {
#if LEITSTAND_FASTDDS_3
    return {rtps::NetworkBuffer(bytes.data(), static_cast<std::uint32_t>(bytes.size()))};
#else
    return reinterpret_cast<Outgoing>(bytes.data());
#endif
}

/// Returns the bytes of @p datagram, whose size is @p size [B]. If it has several pieces, they are copied to
/// @p joined.
[[nodiscard]] inline std::span<const std::byte> bytesOf(Outgoing datagram, std::uint32_t size,
                                                        std::vector<std::byte>& joined) {
#if LEITSTAND_FASTDDS_3
    const auto piece = [](const rtps::NetworkBuffer& one) {
        return std::span(static_cast<const std::byte*>(one.buffer), one.size);
    };
    if (datagram.size() == 1) return piece(datagram.front());
    joined.reserve(size);
    for (const rtps::NetworkBuffer& one : datagram)
        joined.insert(joined.end(), piece(one).begin(), piece(one).end());
    return joined;
#else
    static_cast<void>(joined);
    return std::as_bytes(std::span(datagram, size));
#endif
}

/// A sender resource of a transport. Its function for sending has a different name in each version.
class WayOut : public rtps::SenderResource {
protected:
    using Send =
        std::function<bool(Outgoing, std::uint32_t size, rtps::LocatorsIterator* first,
                           rtps::LocatorsIterator* last, const std::chrono::steady_clock::time_point& until)>;
    WayOut(std::int32_t kind, Send send) : SenderResource(kind) {
#if LEITSTAND_FASTDDS_3
        send_buffers_lambda_ = std::move(send);
#else
        send_lambda_ = std::move(send);
#endif
    }
};

/// Makes samples between endpoints of this process go the same way as all others.
inline void turnOffShortcuts() {
#if LEITSTAND_FASTDDS_3
    eprosima::fastdds::LibrarySettings library;
    library.intraprocess_delivery = eprosima::fastdds::INTRAPROCESS_OFF;
    dds::DomainParticipantFactory::get_instance()->set_library_settings(library);
#else
    eprosima::fastrtps::LibrarySettingsAttributes library;
    library.intraprocess_delivery = eprosima::fastrtps::IntraprocessDeliveryType::INTRAPROCESS_OFF;
    eprosima::fastrtps::xmlparser::XMLProfileManager::library_settings(library);
#endif
}

/// Sets how often a writer sends heartbeats while samples are unacknowledged. Also turns off the heartbeats
/// that 3.1 sends with each fragment of a sample.
inline void setHeartbeat(dds::DataWriterQos& qos, const Duration& period) {
#if LEITSTAND_FASTDDS_3
    qos.reliable_writer_qos().times.heartbeat_period = period;
    qos.reliable_writer_qos().disable_heartbeat_piggyback = true;
#else
    qos.reliable_writer_qos().times.heartbeatPeriod = period;
#endif
}

/// Makes the payload pool of a writer's topic large enough to include payloads that are being sent. A message
/// of 3.1 holds up to 64 payloads in addition to the history, and two threads may send for one writer. If the
/// pool is too small and a reader of the same topic leaves at that moment, an assertion
/// (`TopicPayloadPool::shrink`) ends the process. Without such a reader, samples are refused.
inline void countWhatIsSent(dds::DataWriterQos& qos) {
#if LEITSTAND_FASTDDS_3
    constexpr int Gathered = 65, Senders = 2;
    qos.resource_limits().extra_samples = 1 + Gathered * Senders;
    qos.resource_limits().allocated_samples = 0;  // else all of these are allocated at once
#else
    static_cast<void>(qos);
#endif
}

[[nodiscard]] inline dds::DataRepresentationQosPolicy& representationOf(dds::DataReaderQos& qos) {
#if LEITSTAND_FASTDDS_3
    return qos.representation();
#else
    return qos.type_consistency().representation;
#endif
}

#if LEITSTAND_FASTDDS_3
inline constexpr auto SuperClient = rtps::DiscoveryProtocol::SUPER_CLIENT;
#else
inline constexpr auto SuperClient = rtps::DiscoveryProtocol_t::SUPER_CLIENT;
#endif

/// Adds discovery server @p number at @p locator. Returns false when no server can have that number.
template <class DiscoverySettings>
[[nodiscard]] bool addServer(DiscoverySettings& discovery, int number, const rtps::Locator_t& locator) {
#if LEITSTAND_FASTDDS_3
    if (number > 255) return false;
    discovery.m_DiscoveryServers.push_back(locator);
#else
    eprosima::fastdds::rtps::RemoteServerAttributes server;
    if (!eprosima::fastdds::rtps::get_server_client_default_guidPrefix(number, server.guidPrefix))
        return false;
    server.metatrafficUnicastLocatorList.push_back(locator);
    discovery.m_DiscoveryServers.push_back(server);
#endif
    return true;
}

/// Makes a participant the discovery server number 0.
inline void becomeServer(dds::DomainParticipantQos& qos) {
#if LEITSTAND_FASTDDS_3
    qos.wire_protocol().builtin.discovery_config.discoveryProtocol = rtps::DiscoveryProtocol::SERVER;
#else
    qos.wire_protocol().builtin.discovery_config.discoveryProtocol = rtps::DiscoveryProtocol_t::SERVER;
    eprosima::fastdds::rtps::get_server_client_default_guidPrefix(0, qos.wire_protocol().prefix);
#endif
}

/// What discovery reports about a remote reader or writer.
struct EndpointData {
    rtps::GUID_t guid;
    std::string topic, type;
    bool keyed = false, exclusive = false;
    std::vector<std::string> partitions;
    dds::ReliabilityQosPolicy reliability;
    dds::DurabilityQosPolicy durability;
    dds::DeadlineQosPolicy deadline;
    dds::LifespanQosPolicy lifespan;
    dds::LivelinessQosPolicy liveliness;
    dds::DataRepresentationQosPolicy representation;
    std::vector<std::uint8_t> userData;
};

#if LEITSTAND_FASTDDS_3
template <class Data>
[[nodiscard]] EndpointData endpointOf(const Data& data) {
    EndpointData endpoint;
    endpoint.guid = data.guid;
    endpoint.topic = data.topic_name.to_string();
    endpoint.type = data.type_name.to_string();
    endpoint.keyed = data.topic_kind == rtps::WITH_KEY;
    endpoint.exclusive = data.ownership.kind == dds::EXCLUSIVE_OWNERSHIP_QOS;
    endpoint.partitions = data.partition.getNames();
    endpoint.reliability = data.reliability;
    endpoint.durability = data.durability;
    endpoint.deadline = data.deadline;
    if constexpr (requires { data.lifespan; }) endpoint.lifespan = data.lifespan;
    endpoint.liveliness = data.liveliness;
    endpoint.representation = data.representation;
    endpoint.userData = data.user_data.getValue();
    return endpoint;
}
[[nodiscard]] inline rtps::GUID_t guidOf(const ParticipantData& data) {
    return data.guid;
}
[[nodiscard]] inline std::string nameOf(const ParticipantData& data) {
    return data.participant_name.to_string();
}
[[nodiscard]] inline const auto& propertiesOf(const ParticipantData& data) {
    return data.properties;
}
#else
template <class Data>
[[nodiscard]] EndpointData endpointOf(const Data& data) {
    EndpointData endpoint;
    endpoint.guid = data.guid();
    endpoint.topic = data.topicName().to_string();
    endpoint.type = data.typeName().to_string();
    endpoint.keyed = data.topicKind() == rtps::WITH_KEY;
    endpoint.exclusive = data.m_qos.m_ownership.kind == dds::EXCLUSIVE_OWNERSHIP_QOS;
    endpoint.partitions = data.m_qos.m_partition.getNames();
    endpoint.reliability = data.m_qos.m_reliability;
    endpoint.durability = data.m_qos.m_durability;
    endpoint.deadline = data.m_qos.m_deadline;
    endpoint.lifespan = data.m_qos.m_lifespan;
    endpoint.liveliness = data.m_qos.m_liveliness;
    endpoint.representation = data.m_qos.representation;
    endpoint.userData = data.m_qos.m_userData.getValue();
    return endpoint;
}
[[nodiscard]] inline rtps::GUID_t guidOf(const ParticipantData& data) {
    return data.m_guid;
}
[[nodiscard]] inline std::string nameOf(const ParticipantData& data) {
    return data.m_participantName.to_string();
}
[[nodiscard]] inline const auto& propertiesOf(const ParticipantData& data) {
    return data.m_properties;
}
#endif

/// Receives everything that discovery finds, changes and loses, on threads of the library.
class DiscoveryListener : public dds::DomainParticipantListener {
protected:
    virtual void participantSeen(const ParticipantData& data) = 0;
    virtual void participantGone(const rtps::GUID_t& guid) = 0;
    virtual void participantJudged(const rtps::GUID_t& guid, bool refused) = 0;
    virtual void writerSeen(const EndpointData& data) = 0;
    virtual void readerSeen(const EndpointData& data) = 0;
    virtual void endpointGone(const rtps::GUID_t& guid) = 0;

private:
#if LEITSTAND_FASTDDS_3
    void on_participant_discovery(dds::DomainParticipant*, rtps::ParticipantDiscoveryStatus status,
                                  const ParticipantData& data, bool& ignored) override {
        using Status = rtps::ParticipantDiscoveryStatus;
        ignored = false;
        if (status == Status::REMOVED_PARTICIPANT || status == Status::DROPPED_PARTICIPANT)
            participantGone(data.guid);
        else if (status != Status::IGNORED_PARTICIPANT)
            participantSeen(data);
    }
    void on_data_writer_discovery(dds::DomainParticipant*, rtps::WriterDiscoveryStatus status,
                                  const WriterData& data, bool& ignored) override {
        using Status = rtps::WriterDiscoveryStatus;
        ignored = false;
        if (status == Status::REMOVED_WRITER)
            endpointGone(data.guid);
        else if (status != Status::IGNORED_WRITER)
            writerSeen(endpointOf(data));
    }
    void on_data_reader_discovery(dds::DomainParticipant*, rtps::ReaderDiscoveryStatus status,
                                  const ReaderData& data, bool& ignored) override {
        using Status = rtps::ReaderDiscoveryStatus;
        ignored = false;
        if (status == Status::REMOVED_READER)
            endpointGone(data.guid);
        else if (status != Status::IGNORED_READER)
            readerSeen(endpointOf(data));
    }
#else
    void on_participant_discovery(dds::DomainParticipant*, rtps::ParticipantDiscoveryInfo&& info) override {
        using Info = rtps::ParticipantDiscoveryInfo;
        if (info.status == Info::REMOVED_PARTICIPANT || info.status == Info::DROPPED_PARTICIPANT)
            participantGone(info.info.m_guid);
        else
            participantSeen(info.info);
    }
    void on_publisher_discovery(dds::DomainParticipant*, rtps::WriterDiscoveryInfo&& info) override {
        if (info.status == rtps::WriterDiscoveryInfo::REMOVED_WRITER)
            endpointGone(info.info.guid());
        else
            writerSeen(endpointOf(info.info));
    }
    void on_subscriber_discovery(dds::DomainParticipant*, rtps::ReaderDiscoveryInfo&& info) override {
        if (info.status == rtps::ReaderDiscoveryInfo::REMOVED_READER)
            endpointGone(info.info.guid());
        else
            readerSeen(endpointOf(info.info));
    }
#endif
    void onParticipantAuthentication(dds::DomainParticipant*,
                                     rtps::ParticipantAuthenticationInfo&& info) override {
        participantJudged(info.guid,
                          info.status == rtps::ParticipantAuthenticationInfo::UNAUTHORIZED_PARTICIPANT);
    }
};

/// A type without keys that announces its name, but not its structure.
class NamedType : public dds::TopicDataType {
public:
    /// @p size: initial size of payloads, not a limit [B].
    NamedType(const std::string& ddsName, std::uint32_t size) {
#if LEITSTAND_FASTDDS_3
        set_name(ddsName);
        max_serialized_type_size = size;
        is_compute_key_provided = false;
#else
        setName(ddsName.c_str());
        m_typeSize = size;
        m_isGetKeyDefined = false;
        auto_fill_type_object(false);
        auto_fill_type_information(false);
#endif
    }

protected:
    [[nodiscard]] virtual bool toPayload(const void* sample, rtps::SerializedPayload_t& payload) const = 0;
    [[nodiscard]] virtual bool fromPayload(const rtps::SerializedPayload_t& payload, void* sample) const = 0;
    [[nodiscard]] virtual std::uint32_t bytesOf(const void* sample) const = 0;
    [[nodiscard]] virtual void* make() const = 0;
    virtual void drop(void* sample) const = 0;

private:
#if LEITSTAND_FASTDDS_3
    bool serialize(const void* const sample, rtps::SerializedPayload_t& payload,
                   dds::DataRepresentationId_t) override {
        return toPayload(sample, payload);
    }
    bool deserialize(rtps::SerializedPayload_t& payload, void* sample) override {
        return fromPayload(payload, sample);
    }
    uint32_t calculate_serialized_size(const void* const sample, dds::DataRepresentationId_t) override {
        return bytesOf(sample);
    }
    void* create_data() override {
        return make();
    }
    void delete_data(void* sample) override {
        drop(sample);
    }
    bool compute_key(rtps::SerializedPayload_t&, rtps::InstanceHandle_t&, bool) override {
        return false;
    }
    bool compute_key(const void* const, rtps::InstanceHandle_t&, bool) override {
        return false;
    }
#else
    bool serialize(void* sample, rtps::SerializedPayload_t* payload) override {
        return toPayload(sample, *payload);
    }
    bool deserialize(rtps::SerializedPayload_t* payload, void* sample) override {
        return fromPayload(*payload, sample);
    }
    std::function<uint32_t()> getSerializedSizeProvider(void* sample) override {
        return [size = bytesOf(sample)] { return size; };
    }
    void* createData() override {
        return make();
    }
    void deleteData(void* sample) override {
        drop(sample);
    }
    bool getKey(void*, rtps::InstanceHandle_t*, bool) override {
        return false;
    }
    bool is_bounded() const override {
        return false;
    }
    bool is_plain() const override {
        return false;
    }
#endif
};

}  // namespace leitstand::detail::fastdds
