#pragma once

#include <chrono>
#include <functional>
#include <memory>
#include <mutex>
#include <span>
#include <vector>

#include "transport/dds/detail/fastdds.h"
#include "transport/dds/network/repeater.h"
#include "transport/screen/screen.h"
#include "transport/screen/traffic.h"

namespace leitstand::detail {

/// Sends what is given to it, and discovery three times, a little later each time: the library would miss a
/// datagram of that which is lost for a second (docs/wire.md). Any thread.
class DiscoverySender {
public:
    using Moment = std::chrono::steady_clock::time_point;
    /// Sends bytes to locators, which it goes through; false: could not, until that moment.
    using Send = std::function<bool(std::span<const std::byte>, fastdds::rtps::LocatorsIterator&,
                                    fastdds::rtps::LocatorsIterator&, Moment)>;

    /// @p screen knows where others hear discovery, which tells encrypted datagrams apart.
    explicit DiscoverySender(std::shared_ptr<const screen::Screen> screen);

    bool send(std::span<const std::byte> bytes, fastdds::rtps::LocatorsIterator& first,
              fastdds::rtps::LocatorsIterator& last, Moment until, const Send& by);
    /// Sends what waits now, and from here on three times without a pause. Before what sends is gone.
    void finish();

private:
    using Locators = std::vector<fastdds::rtps::Locator_t>;
    [[nodiscard]] bool isDiscovery(screen::Traffic traffic, const Locators& to) const;
    bool sendOnce(std::span<const std::byte> bytes, const Locators& to, Moment until, const Send& by);
    struct Datagram;
    void repeat(std::shared_ptr<const Datagram> datagram, int times);

    const std::shared_ptr<const screen::Screen> m_screen;
    std::mutex m_sending;  // the library sends one datagram at a time, and counts on it
    Repeater m_repeater;   // last member: its thread uses the others
};

}  // namespace leitstand::detail
