#include "transport/dds/network/screened_transport.h"

#include <algorithm>
#include <cstring>
#include <fstream>
#include <iterator>
#include <span>
#include <vector>

#include "core/robot/link/screen_report.h"
#include "transport/dds/detail/fastdds.h"
#include "transport/dds/network/discovery_sender.h"

namespace leitstand::detail {
namespace {

namespace efr = eprosima::fastdds::rtps;
namespace rtps = fastdds::rtps;
using ScreenPtr = std::shared_ptr<screen::Screen>;
struct ScreenedDescriptor final : efr::ChainingTransportDescriptor {
    ScreenedDescriptor(std::shared_ptr<efr::TransportDescriptorInterface> low, ScreenPtr before)
        : ChainingTransportDescriptor(std::move(low)), screen(std::move(before)) {}
    [[nodiscard]] efr::TransportInterface* create_transport() const override;

    ScreenPtr screen;
};

/// A sender resource of the transport below. It sends discovery three times, and what is left at its end:
/// when a participant ends, its sender resources go before their transport.
class ScreenedWay final : public fastdds::WayOut {
public:
    ScreenedWay(DiscoverySender& sender, std::unique_ptr<rtps::SenderResource> low)
        : WayOut(low->kind(),
                 [this](fastdds::Outgoing datagram, uint32_t size, rtps::LocatorsIterator* first,
                        rtps::LocatorsIterator* last, const DiscoverySender::Moment& until) {
                     return send(datagram, size, *first, *last, until);
                 }),
          m_sender(sender),
          m_low(std::move(low)) {}
    ~ScreenedWay() override { m_sender.finish(); }
    ScreenedWay(const ScreenedWay&) = delete;
    ScreenedWay& operator=(const ScreenedWay&) = delete;

    void add_locators_to_list(rtps::LocatorList_t& locators) const override {
        m_low->add_locators_to_list(locators);
    }

private:
    bool send(fastdds::Outgoing datagram, uint32_t size, rtps::LocatorsIterator& first,
              rtps::LocatorsIterator& last, const DiscoverySender::Moment& until) {
        const auto send = [low = m_low.get()](std::span<const std::byte> what, rtps::LocatorsIterator& to,
                                              rtps::LocatorsIterator& end, DiscoverySender::Moment atMost) {
            return low->send(fastdds::outgoing(what), static_cast<uint32_t>(what.size()), &to, &end, atMost);
        };
        std::vector<std::byte> joined;
        return m_sender.send(fastdds::bytesOf(datagram, size, joined), first, last, until, send);
    }

    DiscoverySender& m_sender;
    std::unique_ptr<rtps::SenderResource> m_low;
};

/// A transport whose datagrams pass the screen before the library sees them, and which sends discovery three
/// times.
class ScreenedTransport final : public efr::ChainingTransport {
public:
    explicit ScreenedTransport(const ScreenedDescriptor& descriptor)
        : ChainingTransport(descriptor), m_descriptor(descriptor), m_sender(descriptor.screen) {}

    efr::TransportDescriptorInterface* get_configuration() override { return &m_descriptor; }
    void shutdown() override {
        m_sender.finish();
        low_level_transport_->shutdown();
    }

    bool OpenOutputChannel(efr::SendResourceList& ways, const rtps::Locator_t& to) override {
        const std::size_t known = ways.size();
        const bool opened = low_level_transport_->OpenOutputChannel(ways, to);
        for (std::size_t i = known; i < ways.size(); ++i)
            ways[i] = std::make_unique<ScreenedWay>(m_sender, std::move(ways[i]));
        return opened;
    }
    /// For sender resources that a ChainingTransport opens itself; there are none here.
    bool send(rtps::SenderResource* low, fastdds::Outgoing bytes, uint32_t size,
              rtps::LocatorsIterator* first, rtps::LocatorsIterator* last,
              const std::chrono::steady_clock::time_point& until) override {
        return low->send(bytes, size, first, last, until);
    }

    void receive(efr::TransportReceiverInterface* next, const rtps::octet* bytes, uint32_t size,
                 const rtps::Locator_t& local, const rtps::Locator_t& remote) override {
        screen::Place place;
        std::memcpy(place.address.data(), remote.address, place.address.size());
        place.port = static_cast<std::uint16_t>(remote.port);
        if (m_descriptor.screen->passes(std::as_bytes(std::span(bytes, size)), place))
            next->OnDataReceived(bytes, size, local, remote);
    }

private:
    ScreenedDescriptor m_descriptor;
    DiscoverySender m_sender;
};

efr::TransportInterface* ScreenedDescriptor::create_transport() const {
    return new ScreenedTransport(*this);  // the library owns it
}

/// Lists the library's built-in transports explicitly: UDP, and shared memory within a computer.
void spellOutBuiltin(eprosima::fastdds::dds::TransportConfigQos& transport) {
    if (!transport.use_builtin_transports) return;
    transport.use_builtin_transports = false;
    const auto udp = std::make_shared<efr::UDPv4TransportDescriptor>();
    udp->sendBufferSize = transport.send_socket_buffer_size;
    udp->receiveBufferSize = transport.listen_socket_buffer_size;
    const auto memory = std::make_shared<efr::SharedMemTransportDescriptor>();
    memory->segment_size(2 *
                         std::max(transport.send_socket_buffer_size, transport.listen_socket_buffer_size));
    memory->max_message_size(udp->max_message_size());
    transport.user_transports.insert(transport.user_transports.begin(), {udp, memory});
}

/// Returns whether the rules of the domain protect messages as a whole. A signed file is still plain text.
bool protectsMessages(const std::filesystem::path& governance) {
    std::ifstream in(governance, std::ios::binary);
    const std::string text{std::istreambuf_iterator<char>(in), {}};
    return text.find("<rtps_protection_kind>") != std::string::npos &&
           text.find("<rtps_protection_kind>NONE<") == std::string::npos;
}

}  // namespace

ScreenPtr screenFor(const NodeSettings& settings, std::function<void()> dropped) {
    screen::ScreenSettings how;
    how.encrypted = settings.security && protectsMessages(settings.security->governance);
    how.relayed = !settings.discoveryServer.empty();
    return std::make_shared<screen::Screen>(how, std::move(dropped));
}

std::shared_ptr<efr::TransportDescriptorInterface> screened(
    std::shared_ptr<efr::TransportDescriptorInterface> transport, ScreenPtr screen) {
    return std::make_shared<ScreenedDescriptor>(std::move(transport), std::move(screen));
}

std::vector<std::string> putBefore(eprosima::fastdds::dds::DomainParticipantQos& qos, ScreenPtr screen) {
    std::vector<std::string> warnings;
    auto& transport = qos.transport();
    spellOutBuiltin(transport);
    for (auto& one : transport.user_transports) {
        if (std::dynamic_pointer_cast<efr::UDPTransportDescriptor>(one)) {
            one = screened(one, screen);
        } else {
            const bool memory = std::dynamic_pointer_cast<efr::SharedMemTransportDescriptor>(one) != nullptr;
            warnings.push_back(worded(memory ? Unscreened::SharedMemory : Unscreened::Tcp));
        }
    }
    return warnings;
}

}  // namespace leitstand::detail
