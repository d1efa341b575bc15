#pragma once

#include <deque>
#include <optional>

#include "core/base/time.h"

namespace leitstand {

/// What a rise of CO2 is.
struct GasRiseSettings {
    double least = 120.0;       ///< over the baseline [ppm]
    double noise = 6.0;         ///< ... and in deviations of the sensor's noise
    double shareNoise = 0.015;  ///< of the value, that the noise grows by
    double window = 120.0;      ///< in which the air was clean at some time [s]
    double settle = 5.0;        ///< of samples before anything is told [s]
    double trend = 6.0;         ///< over so long a falling level is told: the source is behind [s]
    double falling = 0.06;      ///< share of the rise that it loses in that time, at most
};

/// CO2 over what is usual here.
struct GasRise {
    double level = 0.0;     ///< smoothed [ppm]
    double baseline = 0.0;  ///< [ppm]
    [[nodiscard]] double rise() const { return level - baseline; }
};

/// Tells the rise of a gas over its baseline, which follows the cleanest air of the last minutes. A sensor's
/// level lags and falls slowly: while it falls, the source is behind, and nothing is told. Pure.
class GasWatch {
public:
    explicit GasWatch(const GasRiseSettings& settings = {}) : m_settings(settings) {}

    /// Takes a sample; the rise while there is one. Samples out of order or not finite are left out.
    [[nodiscard]] std::optional<GasRise> add(Time stamp, double ppm);
    [[nodiscard]] std::optional<GasRise> newest() const { return m_newest; }  ///< rise or not

private:
    struct Entry {
        Time stamp;
        double level;
    };
    GasRiseSettings m_settings;
    std::deque<Entry> m_entries;
    std::optional<GasRise> m_newest;
};

/// How far the mouth that breathes may be from a sensor that tells @p rise [m], for breath of usual strength,
/// which thins to half in 0.4 m; open air, no wall between.
[[nodiscard]] double breathReach(double rise);

}  // namespace leitstand
