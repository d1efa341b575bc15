#pragma once

#include <deque>
#include <optional>

#include "core/base/time.h"

namespace leitstand {

/// Settings for detecting a rise of CO2.
struct GasRiseSettings {
    double least = 120.0;       ///< least rise above the baseline [ppm] ...
    double noise = 6.0;         ///< ... and in multiples of the sensor's noise (standard deviation)
    double shareNoise = 0.015;  ///< share of the level that is added to the noise
    double window = 120.0;      ///< the baseline is the lowest level within this last time [s]
    double settle = 5.0;        ///< samples must cover at least this time before a rise is reported [s]
    double trend = 6.0;         ///< period over which a fall of the level is measured [s]
    double falling = 0.06;      ///< largest fall in that period, as a share of the rise (plus 8 ppm)
};

/// The level of CO2, and its baseline at this place.
struct GasRise {
    double level = 0.0;     ///< smoothed [ppm]
    double baseline = 0.0;  ///< [ppm]
    [[nodiscard]] double rise() const { return level - baseline; }
};

/// Detects when a gas rises above its baseline, which is the cleanest air of the last minutes. The level of a
/// sensor lags and falls slowly. While it falls, the robot has passed the source, and no rise is reported.
/// Pure.
class GasWatch {
public:
    explicit GasWatch(const GasRiseSettings& settings = {}) : m_settings(settings) {}

    /// Takes a sample. Returns the rise while there is one. Ignores samples that are out of order, negative
    /// or not finite.
    [[nodiscard]] std::optional<GasRise> add(Time stamp, double ppm);
    /// Level and baseline at the newest sample, even without a rise; empty before the first sample.
    [[nodiscard]] std::optional<GasRise> newest() const { return m_newest; }

private:
    struct Entry {
        Time stamp;
        double level;
    };
    GasRiseSettings m_settings;
    std::deque<Entry> m_entries;
    std::optional<GasRise> m_newest;
};

/// Returns how far a breathing mouth may be from a sensor that measures @p rise [m]. Assumes usual breath,
/// whose concentration halves every 0.4 m, and open air without a wall in between.
[[nodiscard]] double breathReach(double rise);

}  // namespace leitstand
