#pragma once

#include <cstdint>

namespace leitstand {

/// Increment between the states of a SplitMix64 sequence.
inline constexpr std::uint64_t MixedBitsStep = 0x9e3779b97f4a7c15U;

/// One step of SplitMix64 (Steele, Lea & Flood 2014) from the state @p bits, which may be any number. Returns
/// well-mixed bits, which are the same on every machine. For a sequence, pass bits, bits + MixedBitsStep, ...
[[nodiscard]] constexpr std::uint64_t mixedBits(std::uint64_t bits) {
    bits += MixedBitsStep;
    bits = (bits ^ (bits >> 30U)) * 0xbf58476d1ce4e5b9U;
    bits = (bits ^ (bits >> 27U)) * 0x94d049bb133111ebU;
    return bits ^ (bits >> 31U);
}

}  // namespace leitstand
