#pragma once

#include <algorithm>
#include <chrono>
#include <cstddef>
#include <cstdint>

#include "core/base/time.h"

namespace leitstand::screen {

using Clock = std::chrono::steady_clock;
using Moment = Clock::time_point;

/// An allowance that refills with time (token bucket): it bounds bursts and the average.
class Budget {
public:
    struct Size {
        double most, atFirst, perSecond;
    };
    explicit Budget(const Size& size) : m_left(size.atFirst) {}

    /// Takes @p amount, all or nothing; false when less is left.
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

/// Bounds of the screen, explained in docs/wire.md.
namespace limits {
/// Highest sample number that passes: a writer at 1 kHz reaches it after 24 days. The library counts one by
/// one up to the first number of a writer.
constexpr std::int64_t MostNumber = std::int64_t(1) << 31;
/// How far a writer's numbers may advance: by 16 384 a second, after 64 s of silence by 2^20 at once.
constexpr Budget::Size Numbers = {1 << 20, 1 << 16, 1 << 14};
/// How far numbers and counts from other places of a participant may be ahead of those from where it speaks.
/// In the participant's first seconds anybody on its host can send in its name. Readers never receive the
/// numbers that a jump skips.
constexpr std::int64_t Beside = 32;
/// How many numbers one GAP may cover. `Gaps` bounds all GAPs of a writer together, repeated numbers counted
/// again. The library handles each number.
constexpr std::int64_t LongestGap = 1 << 17;
constexpr Budget::Size Gaps = {1 << 20, 1 << 20, 1 << 18};
/// How far the counts of HEARTBEAT, ACKNACK and the like may advance.
constexpr Budget::Size Counts = {1 << 18, 1 << 14, 1 << 12};
constexpr std::uint32_t LargestSample = 32U << 20;  // [B]
constexpr Budget::Size UnfinishedSamples = {64 << 20, 64 << 20,
                                            8 << 20};  // [B] that a participant has begun in fragments

/// Bounds for one host, of participants that were heard within Present and of their endpoints.
constexpr std::size_t ParticipantsOfHost = 64, EndpointsOfHost = 4096;
constexpr auto Present = std::chrono::seconds(15);
/// Bounds for one host with silent participants, which are kept until their lease is over: killed processes.
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
