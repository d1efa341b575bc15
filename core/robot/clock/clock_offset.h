#pragma once

#include <array>
#include <chrono>
#include <cstddef>
#include <cstdint>
#include <optional>

#include "core/base/time.h"
#include "core/robot/link/link_status.h"

namespace leitstand {

/// The four times of a ping (RFC 5905, section 8).
struct PingTimes {
    Time sent{};           ///< when the station sent the ping, station's clock
    Time robotReceived{};  ///< when the robot received it, robot's clock
    Time robotReplied{};   ///< when the robot replied, robot's clock
    Time received{};       ///< when the reply arrived, station's clock
};

/// A robot's clock minus the station's, and the error of this difference.
struct ClockEstimate {
    std::chrono::nanoseconds ahead{};
    std::chrono::nanoseconds uncertainty{};  ///< the true difference is within ahead +- uncertainty
    ClockSource source = ClockSource::Pings;
};

/// Lower and upper bound of how far one clock is ahead of another [ns].
struct ClockBounds {
    std::int64_t least = 0, most = 0;
};

/// Estimates the offset of a clock from pings. No packet arrives before it was sent, so every ping bounds the
/// offset from both sides (Marzullo 1984). Together, all pings give the bounds of the quickest way there and
/// the quickest way back (Cristian 1989), even if all other pings are slow. Old bounds become wider with the
/// possible drift of clocks. Pings that contradict the bounds are outliers, until several of them agree: then
/// the clock stepped. Constant memory, no allocation.
class PingClock {
public:
    static constexpr double MaxDrift = 100e-6;  ///< largest drift of one clock against the other [s/s]
    /// Error if clocks are read in milliseconds [ns].
    static constexpr std::int64_t ReadingError = 1'000'000;
    /// Number of newest pings among which agreeing outliers are searched.
    static constexpr int Remembered = 8;
    static constexpr int Convinced = 3;  ///< number of outliers that must agree to be believed

    /// Takes a ping. Returns false when its times contradict each other. If the clock stepped by more than 50
    /// ms, sets @p stepped to the size of the step.
    bool add(const PingTimes& ping, SteadyTime now,
             std::optional<std::chrono::nanoseconds>* stepped = nullptr);
    [[nodiscard]] std::optional<ClockEstimate> estimate(SteadyTime now) const;
    [[nodiscard]] SteadyTime newest() const { return m_at; }  ///< when the newest accepted ping arrived

private:
    struct Doubt {
        ClockBounds bounds;
        SteadyTime at;
        bool open = false;  ///< whether it contradicted the bounds
    };
    [[nodiscard]] std::optional<ClockBounds> agreement(SteadyTime now) const;

    std::optional<ClockBounds> m_bounds;
    SteadyTime m_at;
    std::array<Doubt, Remembered> m_doubts;
    std::size_t m_count = 0;
};

/// Estimates the offset of a clock from the times at which samples were written and received, for robots that
/// do not answer pings. Assumes that no sample arrives before it was written, and that the quickest sample of
/// the last seconds took at most LeastDelay. Follows a step forward within a few samples. A step back first
/// looks like a link that became slow. It is followed within Window, when the last sample from before it is
/// dropped.
class StampClock {
public:
    /// Assumed largest delay of the quickest sample [ns].
    static constexpr std::int64_t LeastDelay = 50'000'000;
    static constexpr std::int64_t Step = 500'000'000;  ///< smaller changes are no step [ns]
    static constexpr int Window = 10;                  ///< samples are kept for this time [s]
    static constexpr int Convinced = 3;  ///< number of samples that must agree on a step forward

    /// Takes a sample. @p stepped: as for PingClock::add(), for steps of more than Step.
    void add(Time written, Time received, SteadyTime now,
             std::optional<std::chrono::nanoseconds>* stepped = nullptr);
    [[nodiscard]] std::optional<ClockEstimate> estimate(SteadyTime now) const;

private:
    struct Second {
        std::int64_t number = -1;  ///< number of the second on the steady clock
        std::int64_t most = 0;     ///< largest difference: written minus received [ns]
    };
    [[nodiscard]] std::optional<std::int64_t> envelope() const;
    void put(std::int64_t second, std::int64_t difference);

    std::array<Second, Window> m_seconds;
    std::optional<std::int64_t> m_reported;  ///< envelope at the last sample
    SteadyTime m_at;
    std::int64_t m_doubted = 0;  ///< a difference far above the envelope
    int m_doubts = 0;            ///< number of such differences in a row
};

/// Estimates the offset of a robot's clock from pings or, without them, from stamps.
class ClockOffset {
public:
    /// If pings are not answered for longer than this, stamps are used.
    static constexpr std::chrono::seconds PingsHold{60};

    /// Takes a ping. Returns false when its times contradict each other.
    bool ping(const PingTimes& ping, SteadyTime now);
    /// Takes a sample of the robot, @p written on the robot's clock and @p received on the station's.
    void stamp(Time written, Time received, SteadyTime now);
    /// Returns the offset; empty if nothing is known yet.
    [[nodiscard]] std::optional<ClockStatus> status(SteadyTime now) const;

private:
    [[nodiscard]] std::optional<ClockEstimate> estimate(SteadyTime now) const;
    void publish(const std::optional<std::chrono::nanoseconds>& stepped, SteadyTime now);

    PingClock m_pings;
    StampClock m_stamps;
    int m_steps = 0;
    std::chrono::nanoseconds m_lastStep{};
    SteadyTime m_steppedAt;
};

}  // namespace leitstand
