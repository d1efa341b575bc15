#pragma once

#include <array>
#include <chrono>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>

#include "core/base/time.h"
#include "core/robot/link/link_status.h"

namespace leitstand {

/// One received sample of a stream.
struct StreamArrival {
    std::size_t bytes = 0;
    std::array<std::uint8_t, 16> writer{};  ///< identity of the writer; it changes when the robot restarts
    std::uint64_t sequence = 0;  ///< the writer's number for the sample, from 1; gaps are losses; 0: unknown
    Time written{};              ///< when it was written, writer's clock; epoch: unknown
    Time received{};             ///< when it was received, station's clock
};

/// Figures of a stream, as StreamMonitor computes them.
struct StreamFigures {
    double rate = 0.0;            ///< [Hz]
    double lossRatio = 0.0;       ///< share of lost samples, 0 to 1
    std::uint64_t lossBasis = 0;  ///< number of samples, received or lost, from which the ratio is computed
    double megabitsPerSecond = 0.0;
    double age = std::numeric_limits<double>::infinity();  ///< since the newest sample arrived [s]
    /// Arrival on the station's clock minus writing on the robot's clock. It is the least value in the last
    /// second, or that of the newest sample. Empty: unknown.
    std::optional<std::chrono::nanoseconds> transit;
};

/// Counts the samples of one topic. Constant memory, no allocation.
class StreamMonitor {
public:
    static constexpr std::chrono::milliseconds Slot{500};
    static constexpr int Slots = 20;      ///< loss is computed over the last 10 s
    static constexpr int RateSlots = 10;  ///< rate and Mbit/s are computed over the last 5 s
    /// Number of writers that are distinguished. A further writer replaces the one that has been silent
    /// longest.
    static constexpr int Writers = 4;
    static constexpr int Learned = 5;  ///< number of intervals after which the rate is known
    /// Number of consecutive long intervals after which the stream is slower, instead of having losses.
    static constexpr int Convinced = 3;

    void add(const StreamArrival& arrival, SteadyTime now);
    [[nodiscard]] StreamFigures figures(SteadyTime now) const;
    /// Interval at which the writer makes samples [s], independent of losses and delays. Empty until it is
    /// known.
    [[nodiscard]] std::optional<double> interval() const;
    [[nodiscard]] std::uint64_t samples() const { return m_samples; }
    [[nodiscard]] std::uint64_t lost() const { return m_lost; }
    [[nodiscard]] SteadyTime newest() const { return m_newest; }  ///< meaningless before the first sample

private:
    struct Writer {
        std::array<std::uint8_t, 16> id{};
        std::uint64_t sequence = 0;
        Time written{};
        SteadyTime arrived;
        bool known = false;
    };
    struct Count {
        std::int64_t slot = -1;
        std::uint64_t samples = 0, lost = 0, bytes = 0;
        SteadyTime first;
        std::optional<std::chrono::nanoseconds> transit;  ///< least transit
    };
    Writer& writerOf(const StreamArrival& arrival);
    void learn(const Writer& before, const StreamArrival& arrival, SteadyTime now);

    std::array<Writer, Writers> m_writers;
    std::array<Count, Slots> m_counts;
    std::uint64_t m_samples = 0, m_lost = 0;
    SteadyTime m_newest;
    std::optional<std::chrono::nanoseconds> m_transit;  ///< transit of the newest sample
    double m_interval = 0.0;
    int m_intervals = 0;  ///< number of intervals from which m_interval was learned, at most Learned
    int m_long = 0;       ///< number of consecutive intervals that were much longer
};

}  // namespace leitstand
