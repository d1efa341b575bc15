#include "core/station/pad/pad_capture.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace leitstand {
namespace {

constexpr double WellPushed = 0.6;  ///< share of the way to the end
constexpr double NearEnd = 0.7;     ///< axes that rest beyond this are triggers

/// Returns where an axis rests that is at @p value while nobody touches it: sticks are never quite in the
/// middle.
double restOf(double value) {
    if (std::abs(value) < NearEnd) return 0.0;
    return value < 0.0 ? -1.0 : 1.0;
}

}  // namespace

PadCapture::PadCapture(PadState rest) : m_rest(std::move(rest)) {}

std::optional<PadControl> PadCapture::update(const PadState& now) {
    for (std::size_t i = 0; i < now.buttons.size(); ++i) {
        const int index = static_cast<int>(i);
        if (now.buttons[i] && !m_rest.button(index)) return padButton(index);
        if (!now.buttons[i] && i < m_rest.buttons.size()) m_rest.buttons[i] = false;
    }
    std::optional<PadControl> furthest;
    double most = WellPushed;
    for (std::size_t i = 0; i < now.axes.size(); ++i) {
        const int index = static_cast<int>(i);
        const double rest = restOf(m_rest.axis(index));
        const int towards = now.axes[i] < rest ? -1 : 1;
        if (towards == static_cast<int>(rest)) continue;  // it is at this end already
        const PadControl control = padAxis(index, towards, rest);
        const double amount = amountOf(control, now);
        if (amount <= most) continue;
        most = amount;
        furthest = control;
    }
    return furthest;
}

}  // namespace leitstand
