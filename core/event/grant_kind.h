#pragma once

#include <cstdint>

namespace leitstand {

/// What a station may hold: driving a robot, moving its cameras, registering the map.
enum class GrantKind : std::uint8_t { Drive, Camera, Map };

}  // namespace leitstand
