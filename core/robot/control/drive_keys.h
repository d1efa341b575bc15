#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "core/robot/control/drive_setpoint.h"

namespace leitstand {

/// Keys that the operator drives with.
enum class DriveKey : std::uint8_t { Forward, Back, Left, Right, Slow, Fast };
inline constexpr std::size_t DriveKeyCount = 6;

/// Converts held keys to a velocity: 60 % of the robot's limits, 25 % with Slow, 100 % with Fast. Opposite
/// keys cancel each other. Pure.
class DriveKeys {
public:
    void set(DriveKey key, bool held) { m_held[static_cast<std::size_t>(key)] = held; }
    void releaseAll() { m_held.fill(false); }
    [[nodiscard]] bool any() const;  ///< whether a key that moves the robot is held
    [[nodiscard]] DriveVelocity sticks(const DriveLimits& limits) const;

    static constexpr double Usual = 0.6, Slowly = 0.25;  ///< shares of the robot's limits

private:
    [[nodiscard]] bool held(DriveKey key) const { return m_held[static_cast<std::size_t>(key)]; }

    std::array<bool, DriveKeyCount> m_held{};
};

}  // namespace leitstand
