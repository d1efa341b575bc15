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

/// Sends datagrams; those of discovery are sent three times, 30 ms apart. The library repeats a lost
/// discovery datagram only after a second (docs/wire.md). Any thread.
class DiscoverySender {
public:
    using Moment = std::chrono::steady_clock::time_point;
    /// Sends bytes to the locators from the first to the last iterator. Returns false when it could not send
    /// before the given time.
    using Send = std::function<bool(std::span<const std::byte>, fastdds::rtps::LocatorsIterator&,
                                    fastdds::rtps::LocatorsIterator&, Moment)>;

    /// @p screen knows the ports where other participants receive discovery. Encrypted datagrams to these
    /// ports are treated as discovery.
    explicit DiscoverySender(std::shared_ptr<const screen::Screen> screen);

    bool send(std::span<const std::byte> bytes, fastdds::rtps::LocatorsIterator& first,
              fastdds::rtps::LocatorsIterator& last, Moment until, const Send& by);
    /// Sends all waiting copies now. From then on, discovery is sent three times without a pause. Call it
    /// before what the `Send` functions use is destroyed.
    void finish();

private:
    using Locators = std::vector<fastdds::rtps::Locator_t>;
    [[nodiscard]] bool isDiscovery(screen::Traffic traffic, const Locators& to) const;
    bool sendOnce(std::span<const std::byte> bytes, const Locators& to, Moment until, const Send& by);
    struct Datagram;
    void repeat(std::shared_ptr<const Datagram> datagram, int times);

    const std::shared_ptr<const screen::Screen> m_screen;
    std::mutex m_sending;  // the library sends one datagram at a time, and relies on it
    Repeater m_repeater;   // last member: its thread uses the others
};

}  // namespace leitstand::detail
