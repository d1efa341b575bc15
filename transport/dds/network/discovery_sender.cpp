#include "transport/dds/network/discovery_sender.h"

#include <algorithm>
#include <utility>

namespace leitstand::detail {
namespace {

namespace rtps = fastdds::rtps;
using screen::Traffic;

/// Longer than most bursts of loss, and much shorter than the second that the library waits.
constexpr std::chrono::milliseconds CopyAfter{30};
/// Two participants find each other with some eighty datagrams. On a radio that loses 5 %, one in 400 would
/// be lost twice; with one copy, every fifth start waited for a second.
constexpr int Copies = 2;
constexpr std::size_t MostWaiting = 1 << 20;  // [B]

/// Iterates over collected locators.
class Places final : public rtps::LocatorsIterator {
public:
    explicit Places(const rtps::Locator_t* at) : m_at(at) {}
    rtps::LocatorsIterator& operator++() override {
        ++m_at;
        return *this;
    }
    bool operator==(const rtps::LocatorsIterator& other) const override {
        return m_at == static_cast<const Places&>(other).m_at;
    }
    bool operator!=(const rtps::LocatorsIterator& other) const override { return !(*this == other); }
    const rtps::Locator_t& operator*() const override { return *m_at; }

private:
    const rtps::Locator_t* m_at;
};

}  // namespace

DiscoverySender::DiscoverySender(std::shared_ptr<const screen::Screen> screen)
    : m_screen(std::move(screen)), m_repeater(CopyAfter, MostWaiting) {}

bool DiscoverySender::isDiscovery(Traffic traffic, const Locators& to) const {
    if (traffic == Traffic::Discovery) return true;
    return std::all_of(to.begin(), to.end(), [this](const rtps::Locator_t& one) {
        return m_screen->isDiscoveryPort(static_cast<std::uint16_t>(one.port));
    });
}

bool DiscoverySender::sendOnce(std::span<const std::byte> bytes, const Locators& to, Moment until,
                               const Send& by) {
    Places first(to.data()), last(to.data() + to.size());
    const std::scoped_lock alone(m_sending);
    return by(bytes, first, last, until);
}

/// A datagram that is sent again.
struct DiscoverySender::Datagram {
    std::vector<std::byte> bytes;
    Locators to;
    std::chrono::steady_clock::duration patience;
    Send by;
};

void DiscoverySender::repeat(std::shared_ptr<const Datagram> datagram, int times) {
    m_repeater.later(datagram->bytes.size(), [this, datagram, times] {
        auto bytes = datagram->bytes;  // the library writes statistics into what it sends
        sendOnce(bytes, datagram->to, std::chrono::steady_clock::now() + datagram->patience, datagram->by);
        if (times > 1) repeat(datagram, times - 1);
    });
}

bool DiscoverySender::send(std::span<const std::byte> bytes, rtps::LocatorsIterator& first,
                           rtps::LocatorsIterator& last, Moment until, const Send& by) {
    const Traffic traffic = screen::trafficOf(bytes);
    if (traffic == Traffic::Samples) {
        const std::scoped_lock alone(m_sending);
        return by(bytes, first, last, until);
    }
    Locators to;  // the library's iterator can be used only once
    for (; first != last; ++first) to.push_back(*first);
    if (!to.empty() && isDiscovery(traffic, to)) {
        const auto patience = until - std::chrono::steady_clock::now();
        repeat(std::make_shared<const Datagram>(Datagram{{bytes.begin(), bytes.end()}, to, patience, by}),
               Copies);
    }
    return sendOnce(bytes, to, until, by);
}

void DiscoverySender::finish() {
    m_repeater.finish();
}

}  // namespace leitstand::detail
