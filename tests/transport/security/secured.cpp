#include "tests/transport/security/secured.h"

#include <cstring>

#include <fmt/format.h>
#include <fastdds/dds/domain/DomainParticipantFactory.hpp>
#include <fastdds/dds/publisher/Publisher.hpp>
#include <fastdds/dds/subscriber/SampleInfo.hpp>
#include <fastdds/dds/subscriber/Subscriber.hpp>

#include "transport/dds/detail/fastdds.h"

namespace leitstand::test {
namespace efd = eprosima::fastdds::dds;
namespace fastdds = detail::fastdds;
namespace {

/// A std_msgs/msg/String, as bytes.
class TextType final : public fastdds::NamedType {
public:
    TextType() : NamedType("std_msgs::msg::dds_::String_", 64) {}

private:
    bool toPayload(const void* sample, fastdds::rtps::SerializedPayload_t& payload) const override {
        const auto& text = *static_cast<const std::string*>(sample);
        const auto size = static_cast<std::uint32_t>(text.size() + 1);
        if (payload.max_size < size + 8) return false;
        const unsigned char header[] = {0, 1, 0, 0};
        std::memcpy(payload.data, header, 4);
        std::memcpy(payload.data + 4, &size, 4);
        std::memcpy(payload.data + 8, text.c_str(), size);
        payload.length = size + 8;
        payload.encapsulation = CDR_LE;
        return true;
    }
    bool fromPayload(const fastdds::rtps::SerializedPayload_t& payload, void* sample) const override {
        static_cast<std::string*>(sample)->assign(reinterpret_cast<char*>(payload.data), payload.length);
        return true;
    }
    std::uint32_t bytesOf(const void* sample) const override {
        return static_cast<std::uint32_t>(static_cast<const std::string*>(sample)->size() + 9);
    }
    void* make() const override { return new std::string; }
    void drop(void* sample) const override { delete static_cast<std::string*>(sample); }
};

void add(efd::DomainParticipantQos& qos, std::string_view name, std::string_view value) {
    fastdds::rtps::Property property;
    property.name() = fmt::format("dds.sec.{}", name);
    property.value() = value;
    qos.properties().properties().push_back(property);
}

void addSecurity(const SecurityFiles& files, efd::DomainParticipantQos& qos) {
    const std::pair<const char*, std::filesystem::path> paths[] = {
        {"auth.builtin.PKI-DH.identity_ca", files.identityCa},
        {"auth.builtin.PKI-DH.identity_certificate", files.certificate},
        {"auth.builtin.PKI-DH.private_key", files.privateKey},
        {"access.builtin.Access-Permissions.permissions_ca", files.permissionsCa},
        {"access.builtin.Access-Permissions.governance", files.governance},
        {"access.builtin.Access-Permissions.permissions", files.permissions}};
    add(qos, "auth.plugin", "builtin.PKI-DH");
    add(qos, "access.plugin", "builtin.Access-Permissions");
    add(qos, "crypto.plugin", "builtin.AES-GCM-GMAC");
    for (const auto& [name, file] : paths) add(qos, name, fmt::format("file://{}", file.string()));
}

efd::Topic* topicOf(efd::DomainParticipant* participant, const std::string& name) {
    if (auto* known = dynamic_cast<efd::Topic*>(participant->lookup_topicdescription(name))) return known;
    return participant->create_topic(name, "std_msgs::msg::dds_::String_", efd::TOPIC_QOS_DEFAULT);
}

}  // namespace

Participant::Participant(int domain, const std::optional<SecurityFiles>& files) {
    // Samples go over the wire, also between participants of one process.
    fastdds::turnOffShortcuts();
    efd::DomainParticipantQos qos = efd::PARTICIPANT_QOS_DEFAULT;  // its constructor trips GCC 12's warnings
    qos.name("stock");
    qos.transport().use_builtin_transports = false;
    qos.transport().user_transports.push_back(
        std::make_shared<eprosima::fastdds::rtps::UDPv4TransportDescriptor>());
    if (files) addSecurity(*files, qos);
    m_participant = efd::DomainParticipantFactory::get_instance()->create_participant(
        static_cast<efd::DomainId_t>(domain), qos);
    if (m_participant != nullptr) m_participant->register_type(efd::TypeSupport(new TextType));
}

Participant::~Participant() {
    if (m_participant == nullptr) return;
    m_participant->delete_contained_entities();
    efd::DomainParticipantFactory::get_instance()->delete_participant(m_participant);
}

Writer::Writer(const Participant& participant, const std::string& topic) {
    efd::Topic* described = topicOf(participant.get(), topic);
    efd::Publisher* publisher = participant.get()->create_publisher(efd::PUBLISHER_QOS_DEFAULT);
    efd::DataWriterQos qos;
    qos.endpoint().history_memory_policy = fastdds::rtps::PREALLOCATED_WITH_REALLOC_MEMORY_MODE;
    qos.data_sharing().off();
    qos.reliability().kind = efd::RELIABLE_RELIABILITY_QOS;
    m_writer = publisher->create_datawriter(described, qos);
}

int Writer::matched() const {
    efd::PublicationMatchedStatus status;
    m_writer->get_publication_matched_status(status);
    return status.current_count;
}

bool Writer::write(const std::string& bytes) {
    std::string text = bytes;
    return fastdds::write(*m_writer, &text);
}

Reader::Reader(const Participant& participant, const std::string& topic) {
    efd::Topic* described = topicOf(participant.get(), topic);
    efd::Subscriber* subscriber = participant.get()->create_subscriber(efd::SUBSCRIBER_QOS_DEFAULT);
    efd::DataReaderQos qos;
    qos.endpoint().history_memory_policy = fastdds::rtps::PREALLOCATED_WITH_REALLOC_MEMORY_MODE;
    qos.data_sharing().off();
    qos.reliability().kind = efd::RELIABLE_RELIABILITY_QOS;
    m_reader = subscriber->create_datareader(described, qos, this);
}

Reader::~Reader() {
    if (m_reader != nullptr) m_reader->set_listener(nullptr);
}

int Reader::matched() const {
    efd::SubscriptionMatchedStatus status;
    m_reader->get_subscription_matched_status(status);
    return status.current_count;
}

void Reader::on_data_available(efd::DataReader* reader) {
    std::string text;
    efd::SampleInfo info;
    while (fastdds::succeeded(reader->take_next_sample(&text, &info))) {
        if (info.valid_data) ++m_samples;
    }
}

}  // namespace leitstand::test
