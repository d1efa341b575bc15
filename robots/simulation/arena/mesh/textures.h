#pragma once

#include "robots/simulation/arena/mesh.h"

namespace leitstand::simulation {

// Procedural textures of materials; each is always the same.
[[nodiscard]] const Texture& plywoodTexture();    ///< grain along u, knots, joints of the veneer
[[nodiscard]] const Texture& concreteTexture();   ///< spots, pores and fine cracks
[[nodiscard]] const Texture& plasterTexture();    ///< smudges and scratches
[[nodiscard]] const Texture& newspaperTexture();  ///< headlines, columns and a photograph
[[nodiscard]] const Texture& clothTexture();      ///< stripes; for curtains

/// Edge of what the textures of plywood, concrete and plaster show [m].
inline constexpr double MaterialTextureSize = 2.4;

}  // namespace leitstand::simulation
