#pragma once

#include <deque>
#include <optional>

#include "core/base/time.h"

namespace leitstand {

/// Settings of the detection of a rise of CO2.
struct GasRiseSettings {
    double least = 120.0;       ///< least rise over the baseline [ppm] ...
    double noise = 6.0;         ///< ... and in standard deviations of the sensor's noise
    double shareNoise = 0.015;  ///< share of the level that is added to the noise
    double window = 120.0;      ///< the baseline is the lowest level within this time [s]
    double settle = 5.0;        ///< least time of samples before a rise is reported [s]
    double trend = 6.0;         ///< time over which a fall of the level is measured [s]
    double falling = 0.06;      ///< greatest fall in that time, as a share of the rise (plus 8 ppm)
};

/// Level of CO2 and its baseline at this place.
struct GasRise {
    double level = 0.0;     ///< smoothed [ppm]
    double baseline = 0.0;  ///< [ppm]
    [[nodiscard]] double rise() const { return level - baseline; }
};

/// Detects the rise of a gas over its baseline, the cleanest air of the last minutes. A sensor's level lags
/// and falls slowly. While it falls, the robot has passed the source, and no rise is reported. Pure.
class GasWatch {
public:
    explicit GasWatch(const GasRiseSettings& settings = {}) : m_settings(settings) {}

    /// Takes a sample; returns the rise while there is one. Samples that are out of order, negative or not
    /// finite are left out.
    [[nodiscard]] std::optional<GasRise> add(Time stamp, double ppm);
    /// Level and baseline at the newest sample, also without a rise; empty before the first one.
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

/// Returns how far a breathing mouth may be from a sensor that measures @p rise [m]. This assumes breath of
/// usual strength, which thins to half in 0.4 m, and open air without a wall between.
[[nodiscard]] double breathReach(double rise);

}  // namespace leitstand
