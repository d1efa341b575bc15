#include "transport/dds/network/interfaces.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <memory>

#include <arpa/inet.h>
#include <fmt/format.h>
#include <ifaddrs.h>
#include <netdb.h>
#include <netinet/in.h>
#include <sys/socket.h>

namespace leitstand::detail {
namespace {

struct Interface {
    std::string name, address;
};

std::string dotted(const sockaddr* address) {
    std::array<char, INET_ADDRSTRLEN> text{};
    const auto* ipv4 = reinterpret_cast<const sockaddr_in*>(address);
    inet_ntop(AF_INET, &ipv4->sin_addr, text.data(), text.size());
    return text.data();
}

std::vector<Interface> localInterfaces() {
    ifaddrs* first = nullptr;
    if (getifaddrs(&first) != 0) return {};
    const std::unique_ptr<ifaddrs, decltype(&freeifaddrs)> owner(first, &freeifaddrs);
    std::vector<Interface> found;
    for (const ifaddrs* i = first; i != nullptr; i = i->ifa_next) {
        if (i->ifa_addr != nullptr && i->ifa_addr->sa_family == AF_INET) {
            found.push_back({i->ifa_name, dotted(i->ifa_addr)});
        }
    }
    return found;
}

}  // namespace

Result<std::vector<std::string>> addressesOf(const std::vector<std::string>& interfaces) {
    const std::vector<Interface> local = localInterfaces();
    std::vector<std::string> addresses;
    for (const std::string& wanted : interfaces) {
        const auto before = addresses.size();
        for (const Interface& i : local) {
            if (i.name == wanted || i.address == wanted) addresses.push_back(i.address);
        }
        if (addresses.size() > before) continue;
        std::vector<std::string> there;
        for (const Interface& i : local) there.push_back(fmt::format("{} ({})", i.name, i.address));
        return Error{fmt::format("interfaces: \"{}\" has no IPv4 address here; there are {}", wanted,
                                 fmt::join(there, ", "))};
    }
    return addresses;
}

Result<Peer> parsePeer(const std::string& text, const std::string& setting) {
    Peer peer;
    const auto colon = text.find(':');
    const std::string host = text.substr(0, colon);
    if (colon != std::string::npos) {
        const char* begin = text.data() + colon + 1;
        const char* end = text.data() + text.size();
        const auto [last, error] = std::from_chars(begin, end, peer.port);
        if (error != std::errc{} || last != end || peer.port == 0) {
            return Error{
                fmt::format("{}: \"{}\": expected a port from 1 to 65535 after the colon", setting, text)};
        }
    }
    addrinfo hints{};
    hints.ai_family = AF_INET;
    hints.ai_socktype = SOCK_DGRAM;
    addrinfo* first = nullptr;
    if (host.empty() || getaddrinfo(host.c_str(), nullptr, &hints, &first) != 0) {
        return Error{
            fmt::format("{}: \"{}\": expected an IPv4 address or the name of a computer", setting, text)};
    }
    peer.address = dotted(first->ai_addr);
    freeaddrinfo(first);
    return peer;
}

}  // namespace leitstand::detail
