#pragma once

#include <cstdint>

namespace leitstand {

/// What a station may hold: the right to drive a robot, to move its cameras, or to register the map.
enum class GrantKind : std::uint8_t { Drive, Camera, Map };

}  // namespace leitstand
