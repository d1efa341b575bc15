#include "tests/transport/security/secured.h"

#include <cstring>

#include <fastdds/rtps/transport/UDPv4TransportDescriptor.h>
#include <fastrtps/xmlparser/XMLProfileManager.h>
#include <fmt/format.h>
#include <fastdds/dds/domain/DomainParticipantFactory.hpp>
#include <fastdds/dds/publisher/Publisher.hpp>
#include <fastdds/dds/subscriber/SampleInfo.hpp>
#include <fastdds/dds/subscriber/Subscriber.hpp>
#include <fastdds/dds/topic/TopicDataType.hpp>

namespace leitstand::test {
namespace efd = eprosima::fastdds::dds;
namespace {

/// A std_msgs/msg/String, as bytes.
class TextType final : public efd::TopicDataType {
public:
    TextType() {
        setName("std_msgs::msg::dds_::String_");
        m_typeSize = 64;
        m_isGetKeyDefined = false;
        auto_fill_type_object(false);
        auto_fill_type_information(false);
    }
    bool serialize(void* data, eprosima::fastrtps::rtps::SerializedPayload_t* payload) override {
        const auto& text = *static_cast<std::string*>(data);
        const auto size = static_cast<std::uint32_t>(text.size() + 1);
        if (payload->max_size < size + 8) return false;
        const unsigned char header[] = {0, 1, 0, 0};
        std::memcpy(payload->data, header, 4);
        std::memcpy(payload->data + 4, &size, 4);
        std::memcpy(payload->data + 8, text.c_str(), size);
        payload->length = size + 8;
        payload->encapsulation = CDR_LE;
        return true;
    }
    bool deserialize(eprosima::fastrtps::rtps::SerializedPayload_t* payload, void* data) override {
        static_cast<std::string*>(data)->assign(reinterpret_cast<char*>(payload->data), payload->length);
        return true;
    }
    std::function<std::uint32_t()> getSerializedSizeProvider(void* data) override {
        const auto size = static_cast<std::uint32_t>(static_cast<std::string*>(data)->size() + 9);
        return [size] { return size; };
    }
    void* createData() override { return new std::string; }
    void deleteData(void* data) override { delete static_cast<std::string*>(data); }
    bool getKey(void*, eprosima::fastrtps::rtps::InstanceHandle_t*, bool) override { return false; }
};

void add(efd::DomainParticipantQos& qos, std::string_view name, std::string_view value) {
    eprosima::fastrtps::rtps::Property property;
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
    eprosima::fastrtps::LibrarySettingsAttributes library;
    library.intraprocess_delivery = eprosima::fastrtps::INTRAPROCESS_OFF;
    eprosima::fastrtps::xmlparser::XMLProfileManager::library_settings(library);
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
    qos.endpoint().history_memory_policy = eprosima::fastrtps::rtps::PREALLOCATED_WITH_REALLOC_MEMORY_MODE;
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
    return m_writer->write(&text);
}

Reader::Reader(const Participant& participant, const std::string& topic) {
    efd::Topic* described = topicOf(participant.get(), topic);
    efd::Subscriber* subscriber = participant.get()->create_subscriber(efd::SUBSCRIBER_QOS_DEFAULT);
    efd::DataReaderQos qos;
    qos.endpoint().history_memory_policy = eprosima::fastrtps::rtps::PREALLOCATED_WITH_REALLOC_MEMORY_MODE;
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
    while (reader->take_next_sample(&text, &info) == ReturnCode_t::RETCODE_OK) {
        if (info.valid_data) ++m_samples;
    }
}

}  // namespace leitstand::test
