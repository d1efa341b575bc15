#include "transport/dds/detail/participant.h"

#include <algorithm>
#include <cstdio>
#include <sstream>
#include <utility>

#include <fmt/format.h>
#include <fastdds/dds/log/Log.hpp>
#include <fastdds/dds/topic/Topic.hpp>

#include "core/base/printable.h"
#include "transport/convert/message_catalog.h"
#include "transport/dds/detail/convert.h"
#include "transport/dds/detail/endpoint_qos.h"
#include "transport/dds/detail/fastdds.h"
#include "transport/dds/detail/raw_type.h"
#include "transport/dds/names.h"
#include "transport/dds/network/participant_qos.h"
#include "transport/dds/network/screened_transport.h"

namespace leitstand::detail {
namespace {

namespace efd = eprosima::fastdds::dds;

/// Prints log entries of Fast DDS to stderr as printable lines: some contain names that others chose.
class PrintableConsumer final : public efd::LogConsumer {
public:
    void Consume(const efd::Log::Entry& entry) override {
        std::ostringstream text;
        print_timestamp(text, entry, false);
        print_header(text, entry, false);
        print_message(text, entry, false);
        print_context(text, entry, false);
        std::fprintf(stderr, "%s\n", printable(text.str()).c_str());
    }
};

/// Sets up the library, once per process. Fast DDS logs to stderr (stdout is for results). Without profiles,
/// samples of a process to itself take the same way as all others.
void setUpLibrary(bool profiles) {
    static std::once_flag once;
    std::call_once(once, [profiles] {
        efd::Log::ClearConsumers();
        efd::Log::RegisterConsumer(std::make_unique<PrintableConsumer>());
        if (!profiles) fastdds::turnOffShortcuts();
    });
}

/// Reads the user's QoS for a topic; false when the profiles have none by its ROS or DDS name.
template <class EndpointQos, class Lookup>
bool fromProfile(const NodeSettings& settings, const std::string& topic, EndpointQos& qos, Lookup lookup) {
    if (!usesProfiles(settings)) return false;
    if (!fastdds::succeeded(lookup(topic, qos)) && !fastdds::succeeded(lookup(ddsTopicOf(topic), qos)))
        return false;
    keepSound(qos);
    return true;
}

template <class EndpointQos>
Qos effective(const EndpointQos& endpoint) {
    Qos qos;
    qos.reliability = endpoint.reliability().kind == efd::RELIABLE_RELIABILITY_QOS
                          ? Qos::Reliability::Reliable
                          : Qos::Reliability::BestEffort;
    qos.durability = endpoint.durability().kind == efd::VOLATILE_DURABILITY_QOS
                         ? Qos::Durability::Volatile
                         : Qos::Durability::TransientLocal;
    qos.deadline = fastdds::secondsOf(endpoint.deadline().period);
    return qos;
}

/// Tells the type's hash as rmw does from Iron on, if it is known ("typehash=RIHS01_...;").
template <class EndpointQos>
void announceTypeHash(EndpointQos& qos, const std::string& type, const std::string& given = {}) {
    const MessageType* const known = findMessageType(type);
    if (known == nullptr && given.empty()) return;
    const std::string words = fmt::format("typehash={};", given.empty() ? std::string(known->hash) : given);
    qos.user_data() = std::vector<std::uint8_t>(words.begin(), words.end());
}

Error gone(const std::string& topic) {
    return Error{topic + ": the node has left its domain"};
}

}  // namespace

Participant::Participant(const NodeSettings& settings)
    : m_settings(settings),
      m_screen(screenFor(settings, [this] { m_small->wake(); })),
      m_discovery([this] { m_small->wake(); }, settings.security.has_value()),
      m_small(std::make_unique<LaneThread>("dds-small", [this] { notifyDiscovery(); })),
      m_large(std::make_unique<LaneThread>("dds-large")) {}

Participant::~Participant() {
    leave();
}

Result<void> Participant::join() {
    setUpLibrary(usesProfiles(m_settings));
    const std::scoped_lock lock(m_mutex);
    return enter();
}

Result<void> Participant::enter() {
    auto made = participantQos(m_settings);
    if (!made) return made.error();
    efd::DomainParticipantQos qos = std::move(made).value();
    m_unscreened = putBefore(qos, m_screen);
    m_factory = efd::DomainParticipantFactory::get_shared_instance();
    m_participant = m_factory->create_participant(static_cast<efd::DomainId_t>(m_settings.domain), qos,
                                                  &m_discovery, efd::StatusMask::none());
    if (m_participant == nullptr) {
        const char* hint =
            m_settings.security ? " (are the security files of one authority, and still valid?)" : "";
        return Error{fmt::format("domain {}: no participant could be made{}", m_settings.domain, hint)};
    }
    m_guid = guidOf(m_participant->guid());
    m_publisher = m_participant->create_publisher(efd::PUBLISHER_QOS_DEFAULT);
    m_subscriber = m_participant->create_subscriber(efd::SUBSCRIBER_QOS_DEFAULT);
    if (m_publisher == nullptr || m_subscriber == nullptr) {
        return Error{fmt::format("domain {}: the participant can neither read nor write", m_settings.domain)};
    }
    return {};
}

Result<void> Participant::rejoin(const std::function<void(const Guid&)>& entered) {
    const std::scoped_lock alone(m_rejoining);
    std::vector<std::shared_ptr<Reader>> readers;
    std::vector<std::shared_ptr<Writer>> writers;
    efd::DomainParticipant* left = nullptr;
    {
        const std::scoped_lock lock(m_mutex);
        if (m_left) return Error{"the node has left its domain"};
        m_away = true;
        readers = m_readers;
        writers = m_writers;
    }
    for (const auto& reader : readers) reader->suspend();
    for (const auto& writer : writers) writer->suspend();
    {
        const std::scoped_lock lock(m_mutex);
        left = std::exchange(m_participant, nullptr);
        m_topics.clear();
    }
    // Without the lock: a running listener may need it.
    if (left != nullptr) {
        left->delete_contained_entities();
        m_factory->delete_participant(left);
    }
    m_discovery.clear();
    {
        const std::scoped_lock lock(m_mutex);
        if (auto done = enter(); !done) return done;
    }
    if (entered) entered(guid());
    {
        const std::scoped_lock lock(m_mutex);
        m_away = false;
        readers = m_readers;  // some have come, some have gone meanwhile
        writers = m_writers;
    }
    std::string problems;
    const auto note = [&](const Result<void>& opened) {
        if (!opened) problems += (problems.empty() ? "" : "; ") + opened.error().text;
    };
    for (const auto& reader : readers) note(reader->open());
    for (const auto& writer : writers) note(writer->open());
    if (!problems.empty()) return Error{problems};
    return {};
}

Guid Participant::guid() const {
    const std::scoped_lock lock(m_mutex);
    return m_guid;
}

DomainReception Participant::reception() const {
    DomainReception reception = m_discovery.reception();
    std::vector<std::shared_ptr<Reader>> readers;
    {
        const std::scoped_lock lock(m_mutex);
        readers = m_readers;
    }
    for (OfferedWriter& writer : reception.writers) {
        writer.received = std::any_of(readers.begin(), readers.end(),
                                      [&](const auto& reader) { return reader->hasReceived(writer.guid); });
    }
    return reception;
}

void Participant::leave() {
    const std::scoped_lock alone(m_rejoining);
    std::vector<std::shared_ptr<Reader>> readers;
    std::vector<std::shared_ptr<Writer>> writers;
    {
        const std::scoped_lock lock(m_mutex);
        if (m_left) return;
        m_left = true;
        readers.swap(m_readers);
        writers.swap(m_writers);
    }
    m_small->stop();
    m_large->stop();
    for (const auto& reader : readers) reader->close();
    for (const auto& writer : writers) writer->close();
    const std::scoped_lock lock(m_mutex);
    if (m_participant == nullptr) return;
    m_participant->delete_contained_entities();
    m_factory->delete_participant(m_participant);
    m_participant = nullptr;
}

void Participant::deliver(const std::shared_ptr<Reader>& reader) {
    const std::scoped_lock lock(m_mutex);
    if (!m_left) laneOf(*reader).add(reader);
}

LaneThread& Participant::laneOf(const Reader& reader) {
    return reader.settings().lane == Lane::Small ? *m_small : *m_large;
}

Result<std::shared_ptr<Reader>> Participant::subscribe(const ReaderSettings& settings,
                                                       SampleCallback callback) {
    auto reader = std::make_shared<Reader>(*this, settings, std::move(callback));
    {
        const std::scoped_lock lock(m_mutex);
        if (m_left) return gone(settings.topic);
        m_readers.push_back(reader);  // before it is opened: rejoin() misses none
    }
    if (auto opened = reader->open(); !opened) {
        release(reader);
        return opened.error();
    }
    return reader;
}

Result<std::shared_ptr<Writer>> Participant::publish(const WriterSettings& settings) {
    auto writer = std::make_shared<Writer>(*this, settings);
    {
        const std::scoped_lock lock(m_mutex);
        if (m_left) return gone(settings.topic);
        m_writers.push_back(writer);
    }
    if (auto opened = writer->open(); !opened) {
        release(writer);
        return opened.error();
    }
    return writer;
}

void Participant::release(const std::shared_ptr<Reader>& reader) {
    reader->close();
    const std::scoped_lock lock(m_mutex);
    std::erase(m_readers, reader);
}

void Participant::release(const std::shared_ptr<Writer>& writer) {
    writer->close();
    const std::scoped_lock lock(m_mutex);
    std::erase(m_writers, writer);
}

Result<efd::Topic*> Participant::acquireTopic(const std::string& rosTopic, const std::string& rosType) {
    const std::string name = ddsTopicOf(rosTopic), type = ddsTypeOf(rosType);
    UsedTopic& used = m_topics[name];
    if (used.topic != nullptr && used.topic->get_type_name() != type) {
        return Error{fmt::format("{}: is used here as {} already, not as {}", rosTopic,
                                 rosTypeOf(used.topic->get_type_name()), rosType)};
    }
    if (used.topic == nullptr) {
        if (m_participant->find_type(type).empty()) {
            m_participant->register_type(efd::TypeSupport(new RawType(type)), type);
        }
        used.topic = m_participant->create_topic(name, type, efd::TOPIC_QOS_DEFAULT);
    }
    if (used.topic == nullptr) {
        m_topics.erase(name);
        return Error{fmt::format("{}: no topic of type {} could be made", rosTopic, rosType)};
    }
    ++used.users;
    return used.topic;
}

void Participant::releaseTopic(const std::string& ddsTopic) {
    const auto found = m_topics.find(ddsTopic);
    if (found == m_topics.end() || --found->second.users > 0) return;
    m_participant->delete_topic(found->second.topic);
    m_topics.erase(found);
}

Result<efd::DataReader*> Participant::createReader(const ReaderSettings& settings,
                                                   efd::DataReaderListener& listener) {
    const std::scoped_lock lock(m_mutex);
    if (m_left) return gone(settings.topic);
    if (m_away) return static_cast<efd::DataReader*>(nullptr);
    const auto topic = acquireTopic(settings.topic, settings.type);
    if (!topic) return topic.error();
    efd::DataReaderQos qos = readerQos(settings.qos);
    fromProfile(m_settings, settings.topic, qos, [this](const std::string& name, efd::DataReaderQos& into) {
        return m_subscriber->get_datareader_qos_from_profile(name, into);
    });
    announceTypeHash(qos, settings.type);
    auto* reader =
        m_subscriber->create_datareader(*topic, qos, &listener, efd::StatusMask::subscription_matched());
    if (reader == nullptr) {
        releaseTopic(ddsTopicOf(settings.topic));
        return Error{fmt::format("{}: no reader could be made with this QoS", settings.topic)};
    }
    m_discovery.add(guidOf(reader->guid()), {LocalEndpoint::Kind::Reader,
                                             ddsTopicOf(settings.topic),
                                             ddsTypeOf(settings.type),
                                             effective(qos),
                                             {}});
    return reader;
}

void Participant::deleteReader(const Reader& reader, efd::DataReader* what) {
    const std::scoped_lock lock(m_mutex);
    laneOf(reader).remove(reader);
    const Guid guid = guidOf(what->guid());
    m_subscriber->delete_datareader(what);
    m_discovery.remove(guid);
    releaseTopic(ddsTopicOf(reader.settings().topic));
}

Result<efd::DataWriter*> Participant::createWriter(const WriterSettings& settings,
                                                   efd::DataWriterListener& listener) {
    const std::scoped_lock lock(m_mutex);
    if (m_left) return gone(settings.topic);
    if (m_away) return static_cast<efd::DataWriter*>(nullptr);
    const auto topic = acquireTopic(settings.topic, settings.type);
    if (!topic) return topic.error();
    efd::DataWriterQos qos = writerQos(settings.qos, settings.flow);
    fromProfile(m_settings, settings.topic, qos, [this](const std::string& name, efd::DataWriterQos& into) {
        return m_publisher->get_datawriter_qos_from_profile(name, into);
    });
    announceTypeHash(qos, settings.type, settings.typeHash);
    auto* writer =
        m_publisher->create_datawriter(*topic, qos, &listener, efd::StatusMask::publication_matched());
    if (writer == nullptr) {
        releaseTopic(ddsTopicOf(settings.topic));
        return Error{fmt::format("{}: no writer could be made with this QoS", settings.topic)};
    }
    m_discovery.add(guidOf(writer->guid()), {LocalEndpoint::Kind::Writer,
                                             ddsTopicOf(settings.topic),
                                             ddsTypeOf(settings.type),
                                             effective(qos),
                                             {}});
    return writer;
}

void Participant::deleteWriter(const Writer& writer, efd::DataWriter* what) {
    const std::scoped_lock lock(m_mutex);
    const Guid guid = guidOf(what->guid());
    m_publisher->delete_datawriter(what);
    m_discovery.remove(guid);
    releaseTopic(ddsTopicOf(writer.settings().topic));
}

void Participant::onDiscovery(std::function<void()> changed) {
    {
        const std::scoped_lock lock(m_notifyMutex);
        m_notify = std::move(changed);
    }
    m_small->wake();
}

void Participant::notifyDiscovery() {
    const std::scoped_lock lock(m_notifyMutex);
    if (const auto notify = m_notify; notify) notify();
}

}  // namespace leitstand::detail
