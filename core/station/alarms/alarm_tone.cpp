#include "core/station/alarms/alarm_tone.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace leitstand {
namespace {

/// A part of a tone.
struct Note {
    double pitch;    ///< [Hz]
    double seconds;  ///< duration [s]
    double pause;    ///< after it [s]
    double harsh;    ///< share of its third harmonic
    double loud;
};

constexpr Note Soft[] = {{660.0, 0.16, 0.04, 0.0, 0.35}, {494.0, 0.26, 0.05, 0.0, 0.35}};
constexpr Note Sharp[] = {
    {784.0, 0.11, 0.05, 0.35, 0.6}, {988.0, 0.11, 0.05, 0.35, 0.6}, {1319.0, 0.20, 0.05, 0.35, 0.6}};

void add(std::vector<float>& samples, const Note& note, int rate) {
    constexpr double Ramp = 0.012;  // [s]
    const int count = static_cast<int>(note.seconds * rate);
    for (int i = 0; i < count; ++i) {
        const double t = static_cast<double>(i) / rate;
        const double edge = std::min({1.0, t / Ramp, (note.seconds - t) / Ramp});
        const double phase = 2.0 * std::numbers::pi * note.pitch * t;
        const double wave = (std::sin(phase) + note.harsh * std::sin(3.0 * phase)) / (1.0 + note.harsh);
        samples.push_back(static_cast<float>(note.loud * std::max(0.0, edge) * wave));
    }
    samples.insert(samples.end(), static_cast<std::size_t>(note.pause * rate), 0.0F);
}

}  // namespace

std::vector<float> toneSamples(AlarmTone tone, int rate) {
    std::vector<float> samples;
    if (rate <= 0) return samples;
    if (tone == AlarmTone::Attention) {
        for (const Note& note : Soft) add(samples, note, rate);
    } else {
        for (const Note& note : Sharp) add(samples, note, rate);
    }
    return samples;
}

}  // namespace leitstand
