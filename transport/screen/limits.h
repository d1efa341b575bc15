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
/// Highest sample number: 1 kHz for 24 days. The library counts one by one up to a writer's first number.
constexpr std::int64_t MostNumber = std::int64_t(1) << 31;
/// How far a writer's numbers may advance: after 64 s of silence by a million.
constexpr Budget::Size Numbers = {1 << 20, 1 << 16, 1 << 14};
/// How far numbers and counts from a participant's other places may be ahead of those from where it speaks.
/// In its first seconds anybody on its host can have such a place, and skipped numbers are not received.
constexpr std::int64_t Beside = 32;
/// How many numbers the GAPs of a writer may cover, repeated ones too: the library handles each number.
constexpr std::int64_t LongestGap = 1 << 17;
constexpr Budget::Size Gaps = {1 << 20, 1 << 20, 1 << 18};
/// How far the counts of HEARTBEAT, ACKNACK and the like may advance.
constexpr Budget::Size Counts = {1 << 18, 1 << 14, 1 << 12};
constexpr std::uint32_t LargestSample = 32U << 20;  // [B]
constexpr Budget::Size UnfinishedSamples = {64 << 20, 64 << 20,
                                            8 << 20};  // [B] a participant's, in fragments

/// Bounds for one host: those that were heard lately ...
constexpr std::size_t ParticipantsOfHost = 64, EndpointsOfHost = 4096;
constexpr auto Present = std::chrono::seconds(15);
/// ... and those plus the silent ones whose lease is not over: processes that were killed.
constexpr std::size_t LeasedOfHost = 192, LeasedEndpointsOfHost = 8192;
constexpr std::size_t Participants = 512, Endpoints = 16'384;
constexpr std::size_t AnnouncedBytesOfHost = 16U << 20;  // [B] of endpoints
constexpr std::size_t UnannouncedWindows = 64;           // of a participant's writers or readers
constexpr std::size_t PlacesOfParticipant = 8;           // addresses and ports that it sends from
constexpr std::size_t Strangers = 1024;                  // places without a participant
constexpr Budget::Size StrangersPackets = {400, 400, 200};
constexpr auto Introduction = std::chrono::seconds(10);  // a participant's new places are accepted so long
constexpr auto Silence = std::chrono::seconds(3);        // or when all others were silent for so long
}  // namespace limits

}  // namespace leitstand::screen
