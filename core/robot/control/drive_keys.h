#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "core/robot/control/drive_setpoint.h"

namespace leitstand {

/// What the operator does with keys while driving.
enum class DriveKey : std::uint8_t { Forward, Back, Left, Right, Slow, Fast };
inline constexpr std::size_t DriveKeyCount = 6;

/// The sticks that held keys make: 60 % of what the robot may do, a quarter of it with Slow, all of it with
/// Fast. Keys against each other make nothing. Pure.
class DriveKeys {
public:
    void set(DriveKey key, bool held) { m_held[static_cast<std::size_t>(key)] = held; }
    void releaseAll() { m_held.fill(false); }
    [[nodiscard]] bool any() const;  ///< of the keys that move
    [[nodiscard]] DriveVelocity sticks(const DriveLimits& limits) const;

    static constexpr double Usual = 0.6, Slowly = 0.25;  ///< shares of the limits

private:
    [[nodiscard]] bool held(DriveKey key) const { return m_held[static_cast<std::size_t>(key)]; }

    std::array<bool, DriveKeyCount> m_held{};
};

}  // namespace leitstand
