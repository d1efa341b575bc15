#include "transport/dds/detail/screened_transport.h"

#include <algorithm>
#include <cstring>
#include <fstream>
#include <iterator>

#include <fastdds/rtps/transport/ChainingTransport.h>
#include <fastdds/rtps/transport/ChainingTransportDescriptor.h>
#include <fastdds/rtps/transport/UDPTransportDescriptor.h>
#include <fastdds/rtps/transport/UDPv4TransportDescriptor.h>
#include <fastdds/rtps/transport/shared_mem/SharedMemTransportDescriptor.h>

#include "core/robot/screen_report.h"

namespace leitstand::detail {
namespace {

namespace efr = eprosima::fastdds::rtps;
namespace rtps = eprosima::fastrtps::rtps;
using ScreenPtr = std::shared_ptr<screen::Screen>;

struct ScreenedDescriptor final : efr::ChainingTransportDescriptor {
    ScreenedDescriptor(std::shared_ptr<efr::TransportDescriptorInterface> low, ScreenPtr before)
        : ChainingTransportDescriptor(std::move(low)), screen(std::move(before)) {}
    [[nodiscard]] efr::TransportInterface* create_transport() const override;

    ScreenPtr screen;
};

/// A transport whose datagrams pass the screen before the library sees them.
class ScreenedTransport final : public efr::ChainingTransport {
public:
    explicit ScreenedTransport(const ScreenedDescriptor& descriptor)
        : ChainingTransport(descriptor), m_descriptor(descriptor) {}

    efr::TransportDescriptorInterface* get_configuration() override { return &m_descriptor; }
    void shutdown() override { low_level_transport_->shutdown(); }

    bool send(rtps::SenderResource* low, const rtps::octet* bytes, uint32_t size,
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
};

efr::TransportInterface* ScreenedDescriptor::create_transport() const {
    return new ScreenedTransport(*this);  // the library takes it
}

/// What the library takes by itself: UDP, and shared memory within a computer.
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

/// Whether the rules of the domain protect messages as a whole. A file that is signed is text all the same.
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
