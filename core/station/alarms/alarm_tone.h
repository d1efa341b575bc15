#pragma once

#include <cstdint>
#include <vector>

namespace leitstand {

/// The tones of alarms, told apart without seeing the window.
enum class AlarmTone : std::uint8_t {
    Attention,  ///< one soft, falling pair
    Act,        ///< three sharp, rising ones
};

/// @p tone as samples of one channel, -1 to 1, @p rate of them a second; it begins and ends in silence, so
/// that nothing clicks.
[[nodiscard]] std::vector<float> toneSamples(AlarmTone tone, int rate);

}  // namespace leitstand
