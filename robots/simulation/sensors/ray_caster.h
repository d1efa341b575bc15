#pragma once

#include <functional>
#include <span>

#include "robots/simulation/scene/scene.h"

namespace leitstand::simulation {

/// Casts rays, one hit for each: into a scene, or a wall that a test made up.
using CastRays = std::function<void(std::span<const Ray> rays, std::span<Hit> hits)>;

/// Casts into @p scene, which must outlive the result. @p without: body that is passed through; -1: none.
[[nodiscard]] inline CastRays castInto(const Scene& scene, RayKind kind, int without = -1) {
    return [&scene, kind, without](std::span<const Ray> rays, std::span<Hit> hits) {
        scene.cast(rays, hits, kind, without);
    };
}

}  // namespace leitstand::simulation
