#pragma once

#include <algorithm>
#include <chrono>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <mutex>
#include <vector>

#include "tests/support/wait.h"
#include "transport/dds/node.h"

namespace leitstand::test {

/// @p size bytes that begin with a little-endian encapsulation header and then the number @p seed; the rest
/// follows from @p seed.
[[nodiscard]] inline Payload testPayload(std::size_t size, std::uint32_t seed) {
    auto bytes = std::make_shared<std::vector<std::byte>>(std::max<std::size_t>(size, 8));
    for (std::size_t i = 8; i < bytes->size(); ++i) (*bytes)[i] = static_cast<std::byte>(i * 31 + seed);
    (*bytes)[1] = std::byte{1};
    for (std::size_t i = 0; i < 4; ++i) (*bytes)[4 + i] = static_cast<std::byte>(seed >> (8 * i));
    return bytes;
}

/// Whether @p received is @p sent: RTPS carries whole words of 4 bytes, the rest of the last one is zero.
[[nodiscard]] inline bool sameBytes(const std::vector<std::byte>& received,
                                    const std::vector<std::byte>& sent) {
    const auto padding =
        received.begin() + static_cast<std::ptrdiff_t>(std::min(received.size(), sent.size()));
    return received.size() >= sent.size() && received.size() - sent.size() < 4 &&
           std::equal(sent.begin(), sent.end(), received.begin()) &&
           std::all_of(padding, received.end(), [](std::byte byte) { return byte == std::byte{0}; });
}

/// The seed of a testPayload.
[[nodiscard]] inline std::uint32_t seedOf(const ReceivedSample& sample) {
    std::uint32_t seed = 0;
    for (std::size_t i = 0; i < 4; ++i)
        seed |= std::to_integer<std::uint32_t>((*sample.event.cdr)[4 + i]) << (8 * i);
    return seed;
}

/// Keeps what a subscription receives. Must outlive the subscription.
class Inbox {
public:
    [[nodiscard]] SampleCallback callback() {
        return [this](ReceivedSample sample) {
            const std::scoped_lock lock(m_mutex);
            m_samples.push_back(std::move(sample));
        };
    }
    [[nodiscard]] std::size_t size() const {
        const std::scoped_lock lock(m_mutex);
        return m_samples.size();
    }
    [[nodiscard]] std::vector<ReceivedSample> samples() const {
        const std::scoped_lock lock(m_mutex);
        return m_samples;
    }
    [[nodiscard]] bool waitFor(std::size_t count,
                               std::chrono::milliseconds atMost = std::chrono::seconds(20)) const {
        return waitUntil([&] { return size() >= count; }, atMost);
    }

private:
    mutable std::mutex m_mutex;
    std::vector<ReceivedSample> m_samples;
};

}  // namespace leitstand::test
