#pragma once

#include <cstdint>
#include <vector>

namespace leitstand {

/// The tones of alarms, distinct without a look at the window.
enum class AlarmTone : std::uint8_t {
    Attention,  ///< one soft, falling pair
    Act,        ///< three sharp, rising ones
};

/// Returns @p tone as samples of one channel, -1 to 1, @p rate per second. It begins and ends in silence, so
/// that nothing clicks.
[[nodiscard]] std::vector<float> toneSamples(AlarmTone tone, int rate);

}  // namespace leitstand
