#pragma once

#include <cstdint>

#include "core/io/yaml/yaml_fields.h"
#include "robots/simulation/arena/arena.h"

namespace leitstand::simulation {

/// Farthest that something may be from the arena's origin [m].
inline constexpr double FarthestPlace = 1'000.0;
inline constexpr double LargestGround = 100.0;  ///< largest edge of an arena [m]
inline constexpr double ColdestThing = -50.0;   ///< lowest temperature of a thing [degrees C]
inline constexpr double HottestThing = 500.0;   ///< highest temperature of a thing [degrees C]

/// Reads "position: [x, y, z]" [m] and "turn: [roll, pitch, yaw]" [degrees] from @p fields.
[[nodiscard]] Pose readPose(const detail::YamlFields& fields);
/// Reads @p key, a whole number of 64 bits, into @p seed. If the key is missing, @p seed does not change.
void readSeed(const detail::YamlFields& fields, const char* key, std::uint64_t& seed);
/// Reads an entry of "elements" and adds its mistakes to @p errors. @p ambient: temperature of elements that
/// have none of their own [degrees C].
[[nodiscard]] Element readElement(const detail::YamlPlace& place, double ambient, detail::YamlErrors& errors);

}  // namespace leitstand::simulation
