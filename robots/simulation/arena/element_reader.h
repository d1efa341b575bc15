#pragma once

#include <cstdint>

#include "core/io/robot/yaml_fields.h"
#include "robots/simulation/arena/arena.h"

namespace leitstand::simulation {

inline constexpr double FarthestPlace = 1'000.0;  ///< from the arena's origin [m]
inline constexpr double LargestGround = 100.0;    ///< edge of an arena [m]
inline constexpr double ColdestThing = -50.0;     ///< [degrees C]
inline constexpr double HottestThing = 500.0;     ///< [degrees C]

/// Reads "position: [x, y, z]" [m] and "turn: [roll, pitch, yaw]" [degrees] of @p fields.
[[nodiscard]] Pose readPose(const detail::YamlFields& fields);
/// Reads @p key, a whole number of 64 bits; without the key @p seed stays as it is.
void readSeed(const detail::YamlFields& fields, const char* key, std::uint64_t& seed);
/// Reads one entry of "elements" and adds what is wrong to @p errors. @p ambient: temperature of elements
/// that have none of their own [degrees C].
[[nodiscard]] Element readElement(const detail::YamlPlace& place, double ambient, detail::YamlErrors& errors);

}  // namespace leitstand::simulation
