#include "robots/simulation/sensors/noise.h"

#include <bit>
#include <cmath>
#include <numbers>

#include "core/base/mixed_bits.h"

namespace leitstand::simulation {
namespace {

/// Returns the next of a series of well-mixed numbers, to spread a seed over a state.
std::uint64_t spread(std::uint64_t& state) {
    const std::uint64_t bits = mixedBits(state);
    state += MixedBitsStep;
    return bits;
}

}  // namespace

Noise::Noise(std::uint64_t seed, std::string_view name) {
    std::uint64_t hash = 0xcbf29ce484222325U;  // FNV-1a
    for (const char letter : name) hash = (hash ^ static_cast<unsigned char>(letter)) * 0x100000001b3U;
    std::uint64_t state = spread(seed) ^ hash;
    for (std::uint64_t& word : m_state) word = spread(state);
}

std::uint64_t Noise::bits() {
    const std::uint64_t result = std::rotl(m_state[0] + m_state[3], 23) + m_state[0];
    const std::uint64_t shifted = m_state[1] << 17U;
    m_state[2] ^= m_state[0];
    m_state[3] ^= m_state[1];
    m_state[1] ^= m_state[2];
    m_state[0] ^= m_state[3];
    m_state[2] ^= shifted;
    m_state[3] = std::rotl(m_state[3], 45);
    return result;
}

double Noise::uniform() {
    return static_cast<double>(bits() >> 11U) * 0x1p-53;
}

double Noise::normal() {
    if (m_hasSpare) {
        m_hasSpare = false;
        return m_spare;
    }
    const double radius = std::sqrt(-2.0 * std::log(1.0 - uniform()));
    const double angle = 2.0 * std::numbers::pi * uniform();
    m_spare = radius * std::sin(angle);
    m_hasSpare = true;
    return radius * std::cos(angle);
}

float Noise::quickNormal() {
    const std::uint64_t word = bits();
    const auto sum = static_cast<float>((word & 0xffffU) + ((word >> 16U) & 0xffffU) +
                                        ((word >> 32U) & 0xffffU) + (word >> 48U));
    constexpr float Mean = 2.0F * 65535.0F, Deviation = 37837.2F;  // 65536 * sqrt(4 / 12)
    return (sum - Mean) / Deviation;
}

}  // namespace leitstand::simulation
