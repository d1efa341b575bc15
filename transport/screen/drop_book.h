#pragma once

#include <cstdint>
#include <map>
#include <vector>

#include "core/robot/link/screen_report.h"
#include "transport/screen/datagram.h"
#include "transport/screen/place.h"

namespace leitstand::screen {

/// Counts dropped datagrams by reason and sender's address. The first sixteen addresses of each reason are
/// counted separately, all others together, because an attacker may use a new address each time.
class DropBook {
public:
    void note(ScreenDrop::Kind why, const Address& from, Fault fault);
    [[nodiscard]] std::vector<ScreenDrop> drops() const;
    [[nodiscard]] Fault lastFault() const { return m_lastFault; }

private:
    std::map<ScreenDrop::Kind, std::map<Address, std::uint64_t>> m_counts;
    std::map<ScreenDrop::Kind, std::uint64_t> m_others;
    Fault m_lastFault;
};

}  // namespace leitstand::screen
