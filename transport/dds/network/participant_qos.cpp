#include "transport/dds/network/participant_qos.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <memory>
#include <string>

#include <fmt/format.h>
#include <fastdds/dds/domain/DomainParticipantFactory.hpp>
#include <fastdds/rtps/flowcontrol/FlowControllerDescriptor.hpp>

#include "transport/dds/detail/fastdds.h"
#include "transport/dds/network/interfaces.h"
#include "transport/dds/network/socket_buffers.h"

namespace leitstand::detail {
namespace {

namespace efd = eprosima::fastdds::dds;
namespace rtps = fastdds::rtps;
using eprosima::fastdds::rtps::FlowControllerDescriptor;
using eprosima::fastdds::rtps::UDPv4TransportDescriptor;
using fastdds::ProfilesVariable;

constexpr const char* MulticastGroup = "239.255.0.1";  // of discovery: RTPS 2.2, section 9.6.1.4
constexpr std::uint16_t ServerPort = 11811;
constexpr std::uint32_t PeersPerHost = 10;
constexpr int SecurePiece = 7500;  // [B] smaller ones spend the link on signatures

rtps::Locator_t locator(const std::string& address, std::uint32_t port) {
    rtps::Locator_t made;
    made.kind = LOCATOR_KIND_UDPv4;
    rtps::IPLocator::setIPv4(made, address);
    made.port = port;
    return made;
}

Result<void> addTransport(const NodeSettings& settings, efd::DomainParticipantQos& qos) {
    const auto udp = std::make_shared<UDPv4TransportDescriptor>();
    udp->sendBufferSize = udp->receiveBufferSize = SocketBufferSize;
    udp->maxInitialPeersRange = PeersPerHost;
    const auto addresses = addressesOf(settings.interfaces);
    if (!addresses) return addresses.error();
    udp->interfaceWhiteList = *addresses;
    auto& transport = qos.transport();
    transport.use_builtin_transports = false;
    transport.user_transports = {udp};
    transport.send_socket_buffer_size = transport.listen_socket_buffer_size = SocketBufferSize;
    return {};
}

Result<void> addPeers(const NodeSettings& settings, efd::DomainParticipantQos& qos) {
    auto& builtin = qos.wire_protocol().builtin;
    for (const std::string& text : settings.initialPeers) {
        const auto peer = parsePeer(text, "initial peers");
        if (!peer) return peer.error();
        builtin.initialPeersList.push_back(locator(peer->address, peer->port));
    }
    if (!settings.multicast) {
        // Any unicast locator of our own replaces the default ones, and with them the multicast group.
        builtin.metatrafficUnicastLocatorList.push_back(locator("0.0.0.0", 0));
    } else if (!settings.initialPeers.empty()) {
        const std::uint32_t port =
            qos.wire_protocol().port.getMulticastPort(static_cast<std::uint32_t>(settings.domain));
        builtin.initialPeersList.push_back(locator(MulticastGroup, port));
    }
    return {};
}

Result<void> addServers(const NodeSettings& settings, efd::DomainParticipantQos& qos) {
    if (settings.discoveryServer.empty()) return {};
    auto& discovery = qos.wire_protocol().builtin.discovery_config;
    // An ordinary client would learn only about the topics that it uses itself.
    discovery.discoveryProtocol = fastdds::SuperClient;
    std::string_view rest = settings.discoveryServer;
    for (int number = 0;; ++number) {
        const auto end = rest.find(';');
        if (const std::string text(rest.substr(0, end)); !text.empty()) {
            const auto peer = parsePeer(text, "discovery server");
            if (!peer) return peer.error();
            const std::uint16_t port = peer->port == 0 ? ServerPort : peer->port;
            if (!fastdds::addServer(discovery, number, locator(peer->address, port))) {
                return Error{fmt::format("discovery server: \"{}\": there may be 256 at most", text)};
            }
        }
        if (end == std::string_view::npos) return {};
        rest.remove_prefix(end + 1);
    }
}

/// Returns whether nothing leaves this computer.
bool staysHere(const NodeSettings& settings) {
    const auto addresses = addressesOf(settings.interfaces);
    return addresses && !addresses->empty() &&
           std::all_of(addresses->begin(), addresses->end(),
                       [](const std::string& address) { return address.starts_with("127."); });
}

void addFlow(Flow flow, FlowLimit limit, bool secure, efd::DomainParticipantQos& qos) {
    if (secure && limit.bytes > 0 && limit.bytes < SecurePiece) {
        limit.milliseconds = limit.milliseconds * SecurePiece / limit.bytes;
        limit.bytes = SecurePiece;
    }
    const auto controller = std::make_shared<FlowControllerDescriptor>();
    controller->name = flowControllerName(flow);
    controller->max_bytes_per_period = limit.bytes;
    controller->period_ms = static_cast<std::uint64_t>(limit.milliseconds);
    qos.flow_controllers().push_back(controller);
}

void addFlows(const NodeSettings& settings, efd::DomainParticipantQos& qos) {
    if constexpr (!fastdds::HasFlowControllers) {
        // A limit of the transport would also limit what is received.
        if (settings.scanLimit.bytes > 0 && !staysHere(settings))
            qos.properties().properties().emplace_back("fastdds.max_message_size",
                                                       std::to_string(settings.scanLimit.bytes));
        return;
    }
    const bool secure = settings.security.has_value(), here = staysHere(settings);
    const std::pair<Flow, FlowLimit> flows[] = {{Flow::Telemetry, settings.telemetryLimit},
                                                {Flow::Scans, settings.scanLimit},
                                                {Flow::Pictures, settings.pictureLimit}};
    for (const auto& [flow, limit] : flows) addFlow(flow, here ? FlowLimit{.bytes = 0} : limit, secure, qos);
}

Result<void> addSecurity(const SecurityFiles& files, efd::DomainParticipantQos& qos) {
    auto& properties = qos.properties().properties();
    const auto add = [&](const char* name, const std::string& value) {
        properties.emplace_back(name, value);
    };
    const auto addFile = [&](const char* name, const std::filesystem::path& file) -> Result<void> {
        if (!std::ifstream(file)) return Error{fmt::format("security: {}: cannot be opened", file.string())};
        add(name, "file://" + std::filesystem::absolute(file).string());
        return {};
    };
    add("dds.sec.auth.plugin", "builtin.PKI-DH");
    add("dds.sec.access.plugin", "builtin.Access-Permissions");
    add("dds.sec.crypto.plugin", "builtin.AES-GCM-GMAC");
    const std::pair<const char*, std::filesystem::path> all[] = {
        {"dds.sec.auth.builtin.PKI-DH.identity_ca", files.identityCa},
        {"dds.sec.auth.builtin.PKI-DH.identity_certificate", files.certificate},
        {"dds.sec.auth.builtin.PKI-DH.private_key", files.privateKey},
        {"dds.sec.access.builtin.Access-Permissions.permissions_ca",
         files.permissionsCa.empty() ? files.identityCa : files.permissionsCa},
        {"dds.sec.access.builtin.Access-Permissions.governance", files.governance},
        {"dds.sec.access.builtin.Access-Permissions.permissions", files.permissions},
    };
    for (const auto& [name, file] : all) {
        if (auto added = addFile(name, file); !added) return added;
    }
    return {};
}

fastdds::Duration duration(double seconds) {
    const double whole = std::floor(seconds);
    return {static_cast<int32_t>(whole), static_cast<uint32_t>((seconds - whole) * 1e9)};
}

}  // namespace

const char* flowControllerName(Flow flow) {
    switch (flow) {
        case Flow::Telemetry:
            return "leitstand_telemetry";
        case Flow::Scans:
            return "leitstand_scans";
        case Flow::Pictures:
            return "leitstand_pictures";
        case Flow::Immediate:
            break;
    }
    return "";
}

bool usesProfiles(const NodeSettings& settings) {
    const char* file = std::getenv(ProfilesVariable);
    return settings.useXmlProfiles && file != nullptr && *file != '\0';
}

Result<efd::DomainParticipantQos> participantQos(const NodeSettings& settings) {
    if (settings.domain < 0 || settings.domain > 232) {
        return Error{fmt::format("domain: {}: expected 0 to 232", settings.domain)};
    }
    efd::DomainParticipantQos qos;
    const bool profiles = usesProfiles(settings);
    if (profiles) {
        const char* file = std::getenv(ProfilesVariable);
        if (!std::ifstream(file))
            return Error{fmt::format("{}={}: cannot be opened", ProfilesVariable, file)};
        efd::DomainParticipantFactory::get_instance()->load_profiles();
        efd::DomainParticipantFactory::get_instance()->get_default_participant_qos(qos);
    } else {
        auto& discovery = qos.wire_protocol().builtin.discovery_config;
        discovery.leaseDuration = duration(settings.lease);
        discovery.leaseDuration_announcementperiod = duration(std::min(1.0, settings.lease / 3.0));
    }
    if (!profiles || qos.name() == efd::DomainParticipantQos().name()) qos.name(settings.name);
    // rmw takes participants for processes of ROS 2 by their enclave.
    constexpr std::string_view Enclave = "enclave=/;";
    if (qos.user_data().empty()) qos.user_data() = std::vector<std::uint8_t>(Enclave.begin(), Enclave.end());
    if (!profiles || !settings.interfaces.empty()) {
        if (auto added = addTransport(settings, qos); !added) return added.error();
    }
    if (auto added = addPeers(settings, qos); !added) return added.error();
    if (auto added = addServers(settings, qos); !added) return added.error();
    addFlows(settings, qos);
    if (settings.security) {
        if (auto added = addSecurity(*settings.security, qos); !added) return added.error();
    }
    return qos;
}

}  // namespace leitstand::detail
