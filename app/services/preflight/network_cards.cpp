#include "app/services/preflight/network_cards.h"

#include <algorithm>
#include <array>

#include <arpa/inet.h>
#include <ifaddrs.h>
#include <net/if.h>
#include <netinet/in.h>

namespace leitstand {

std::vector<NetworkCard> networkCards(const std::vector<std::string>& chosen) {
    std::vector<NetworkCard> cards;
    ifaddrs* first = nullptr;
    if (getifaddrs(&first) != 0) return cards;
    for (const ifaddrs* one = first; one != nullptr; one = one->ifa_next) {
        if (one->ifa_addr == nullptr || one->ifa_addr->sa_family != AF_INET) continue;
        std::array<char, INET_ADDRSTRLEN> text{};
        const auto* address = reinterpret_cast<const sockaddr_in*>(one->ifa_addr);
        if (inet_ntop(AF_INET, &address->sin_addr, text.data(), text.size()) == nullptr) continue;
        NetworkCard card;
        card.name = one->ifa_name;
        card.address = text.data();
        card.up = (one->ifa_flags & IFF_UP) != 0 && (one->ifa_flags & IFF_RUNNING) != 0;
        card.loopback = (one->ifa_flags & IFF_LOOPBACK) != 0;
        card.used = chosen.empty() ? card.up
                                   : std::any_of(chosen.begin(), chosen.end(), [&](const std::string& word) {
                                         return word == card.name || word == card.address;
                                     });
        cards.push_back(std::move(card));
    }
    freeifaddrs(first);
    return cards;
}

}  // namespace leitstand
