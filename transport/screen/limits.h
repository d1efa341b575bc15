#pragma once

#include <algorithm>
#include <chrono>
#include <cstddef>
#include <cstdint>

#include "core/base/time.h"

namespace leitstand::screen {

using Clock = std::chrono::steady_clock;
using Moment = Clock::time_point;

/// An allowance that is refilled over time (token bucket). It limits bursts and the average.
class Budget {
public:
    struct Size {
        double most, atFirst, perSecond;
    };
    explicit Budget(const Size& size) : m_left(size.atFirst) {}

    /// Takes @p amount if that much is left; otherwise takes nothing and returns false.
    bool take(double amount, Moment now, const Size& size) {
        if (m_filled != Moment{}) {
            const double seconds = toSeconds(now - m_filled);
            m_left = std::min(size.most, m_left + std::max(0.0, seconds) * size.perSecond);
        }
        m_filled = now;
        if (amount > m_left) return false;
        m_left -= amount;
        return true;
    }
    void giveBack(double amount, const Size& size) { m_left = std::min(size.most, m_left + amount); }

private:
    double m_left;
    Moment m_filled{};
};

/// Limits of the screen, explained in docs/wire.md.
namespace limits {
/// Highest sample number that is accepted; a writer at 1 kHz reaches it after 24 days. It is limited because
/// the library counts one by one up to a writer's first number.
constexpr std::int64_t MostNumber = std::int64_t(1) << 31;
/// How fast a writer's numbers may increase: by 16 384 per second, or after 64 s of silence by 2^20 at once.
constexpr Budget::Size Numbers = {1 << 20, 1 << 16, 1 << 14};
/// How far numbers and counts from other places of a participant may be ahead of those from the place where
/// it speaks. In the participant's first seconds, anybody on its host can send in its name. Readers never
/// receive the numbers that a jump skips.
constexpr std::int64_t Beside = 32;
/// How many numbers one GAP may have. `Gaps` limits all GAPs of a writer together, including repeated
/// numbers. The library handles each number separately.
constexpr std::int64_t LongestGap = 1 << 17;
constexpr Budget::Size Gaps = {1 << 20, 1 << 20, 1 << 18};
/// How fast the counts of HEARTBEAT, ACKNACK and similar submessages may increase.
constexpr Budget::Size Counts = {1 << 18, 1 << 14, 1 << 12};
constexpr std::uint32_t LargestSample = 32U << 20;  // [B]
constexpr Budget::Size UnfinishedSamples = {64 << 20, 64 << 20,
                                            8 << 20};  // [B] that a participant has begun in fragments

/// Limits per host for participants that were heard within Present, and for their endpoints.
constexpr std::size_t ParticipantsOfHost = 64, EndpointsOfHost = 4096;
constexpr auto Present = std::chrono::seconds(15);
/// Limits per host that include silent participants, which are kept until their lease is over: processes that
/// were killed.
constexpr std::size_t LeasedOfHost = 192, LeasedEndpointsOfHost = 8192;
constexpr std::size_t Participants = 512, Endpoints = 16'384;
constexpr std::size_t AnnouncedBytesOfHost = 16U << 20;  // [B] of endpoints
constexpr std::size_t UnannouncedWindows = 64;           // of writers or readers that were never announced
constexpr std::size_t PlacesOfParticipant = 8;           // addresses and ports that it sends from
constexpr std::size_t Strangers = 1024;                  // places that no participant sends from
constexpr Budget::Size StrangersPackets = {400, 400, 200};
constexpr auto Introduction = std::chrono::seconds(10);  // how long a new participant may use new places
constexpr auto Silence = std::chrono::seconds(3);        // later: when all its places were silent so long
}  // namespace limits

}  // namespace leitstand::screen
