#pragma once

#include <cstdint>
#include <vector>

namespace leitstand {

/// The tones of alarms, which can be distinguished without looking at the window.
enum class AlarmTone : std::uint8_t {
    Attention,  ///< one soft, falling pair of tones
    Act,        ///< three sharp, rising tones
};

/// Returns @p tone as samples of one channel, from -1 to 1, @p rate per second. It begins and ends at zero to
/// avoid clicks.
[[nodiscard]] std::vector<float> toneSamples(AlarmTone tone, int rate);

}  // namespace leitstand
