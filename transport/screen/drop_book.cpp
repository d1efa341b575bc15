#include "transport/screen/drop_book.h"

namespace leitstand::screen {

void DropBook::note(ScreenDrop::Kind why, const Address& from, Fault fault) {
    constexpr std::size_t MostAddresses = 16;
    m_lastFault = fault;
    auto& counts = m_counts[why];
    const auto known = counts.find(from);
    if (known == counts.end() && counts.size() >= MostAddresses) {
        ++m_others[why];
    } else {
        ++counts[from];
    }
}

std::vector<ScreenDrop> DropBook::drops() const {
    std::vector<ScreenDrop> all;
    for (const auto& [why, counts] : m_counts) {
        for (const auto& [address, packets] : counts) all.push_back({why, toString(address), packets});
    }
    for (const auto& [why, packets] : m_others) all.push_back({why, {}, packets});
    return all;
}

}  // namespace leitstand::screen
