#include "tests/transport/screen_wire/recorded_traffic.h"

#include <cstring>
#include <map>
#include <stdexcept>
#include <thread>

#include <fastdds/dds/domain/DomainParticipantFactory.hpp>
#include <fastdds/dds/subscriber/Subscriber.hpp>
#include <fastdds/dds/topic/TypeSupport.hpp>

#include "transport/dds/detail/endpoint_qos.h"
#include "transport/dds/detail/fastdds.h"
#include "transport/dds/detail/raw_type.h"
#include "transport/dds/names.h"
#include "transport/dds/network/participant_qos.h"
#include "transport/dds/network/screened_transport.h"

namespace leitstand::test {
namespace efd = eprosima::fastdds::dds;
namespace efr = eprosima::fastdds::rtps;
namespace rtps = detail::fastdds::rtps;

/// Told of each datagram below the screen and above it, by the thread that received it.
struct RecordingParticipant::Tap {
    explicit Tap(std::size_t most) : keep(most) {}

    void below(std::span<const std::byte> bytes, const rtps::Locator_t& remote) {
        const std::scoped_lock lock(mutex);
        ++arrived;
        pending[std::this_thread::get_id()].assign(bytes.begin(), bytes.end());
        if (packets.size() >= keep) return;
        RecordedPacket packet;
        packet.bytes.assign(bytes.begin(), bytes.end());
        std::memcpy(packet.place.address.data(), remote.address, 16);
        packet.place.port = static_cast<std::uint16_t>(remote.port);
        packets.push_back(std::move(packet));
    }
    void above(std::span<const std::byte> bytes) {
        const std::scoped_lock lock(mutex);
        ++passed;
        const auto& expected = pending[std::this_thread::get_id()];
        same = same && std::equal(bytes.begin(), bytes.end(), expected.begin(), expected.end());
    }

    const std::size_t keep;
    mutable std::mutex mutex;
    std::uint64_t arrived = 0, passed = 0;
    bool same = true;
    std::map<std::thread::id, std::vector<std::byte>> pending;
    std::vector<RecordedPacket> packets;
};

namespace {

using TapPtr = std::shared_ptr<RecordingParticipant::Tap>;

struct TapDescriptor final : efr::ChainingTransportDescriptor {
    TapDescriptor(std::shared_ptr<efr::TransportDescriptorInterface> low, TapPtr to, bool below)
        : ChainingTransportDescriptor(std::move(low)), tap(std::move(to)), isBelow(below) {}
    [[nodiscard]] efr::TransportInterface* create_transport() const override;
    TapPtr tap;
    bool isBelow;
};

class TapTransport final : public efr::ChainingTransport {
public:
    explicit TapTransport(const TapDescriptor& descriptor)
        : ChainingTransport(descriptor), m_descriptor(descriptor) {}
    efr::TransportDescriptorInterface* get_configuration() override { return &m_descriptor; }
    bool send(rtps::SenderResource* low, detail::fastdds::Outgoing bytes, uint32_t size,
              rtps::LocatorsIterator* first, rtps::LocatorsIterator* last,
              const std::chrono::steady_clock::time_point& until) override {
        return low->send(bytes, size, first, last, until);
    }
    void receive(efr::TransportReceiverInterface* next, const rtps::octet* bytes, uint32_t size,
                 const rtps::Locator_t& local, const rtps::Locator_t& remote) override {
        const auto all = std::as_bytes(std::span(bytes, size));
        m_descriptor.isBelow ? m_descriptor.tap->below(all, remote) : m_descriptor.tap->above(all);
        next->OnDataReceived(bytes, size, local, remote);
    }

private:
    TapDescriptor m_descriptor;
};

efr::TransportInterface* TapDescriptor::create_transport() const {
    return new TapTransport(*this);
}

}  // namespace

RecordingParticipant::RecordingParticipant(const NodeSettings& settings, std::size_t keep)
    : m_tap(std::make_shared<Tap>(keep)), m_screen(detail::screenFor(settings)) {
    auto made = detail::participantQos(settings);
    if (!made) throw std::runtime_error(made.error().text);
    efd::DomainParticipantQos qos = std::move(made).value();
    auto& transports = qos.transport().user_transports;
    for (auto& one : transports) {
        one = std::make_shared<TapDescriptor>(one, m_tap, true);
        one = detail::screened(one, m_screen);
        one = std::make_shared<TapDescriptor>(one, m_tap, false);
    }
    detail::fastdds::turnOffShortcuts();  // a node does so too; 3.1 obeys while there is no participant yet
    m_participant = efd::DomainParticipantFactory::get_instance()->create_participant(
        static_cast<efd::DomainId_t>(settings.domain), qos);
    if (m_participant == nullptr) throw std::runtime_error("no participant");
    m_subscriber = m_participant->create_subscriber(efd::SUBSCRIBER_QOS_DEFAULT);
}

RecordingParticipant::~RecordingParticipant() {
    m_participant->delete_contained_entities();
    efd::DomainParticipantFactory::get_instance()->delete_participant(m_participant);
}

void RecordingParticipant::listen(const std::string& topic, const Qos& qos, const std::string& type) {
    const std::string ddsType = ddsTypeOf(type);
    if (m_participant->find_type(ddsType).empty())
        m_participant->register_type(efd::TypeSupport(new detail::RawType(ddsType)), ddsType);
    efd::Topic* made = m_participant->create_topic(ddsTopicOf(topic), ddsType, efd::TOPIC_QOS_DEFAULT);
    if (made == nullptr || m_subscriber->create_datareader(made, detail::readerQos(qos)) == nullptr)
        throw std::runtime_error(topic + ": cannot be listened to");
}

std::uint64_t RecordingParticipant::arrived() const {
    const std::scoped_lock lock(m_tap->mutex);
    return m_tap->arrived;
}
std::uint64_t RecordingParticipant::passed() const {
    const std::scoped_lock lock(m_tap->mutex);
    return m_tap->passed;
}
bool RecordingParticipant::same() const {
    const std::scoped_lock lock(m_tap->mutex);
    return m_tap->same;
}
std::vector<RecordedPacket> RecordingParticipant::packets() const {
    const std::scoped_lock lock(m_tap->mutex);
    return m_tap->packets;
}

}  // namespace leitstand::test
