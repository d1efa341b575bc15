#pragma once

#include <functional>
#include <span>

#include "robots/simulation/scene/scene.h"

namespace leitstand::simulation {

/// Casts rays into a scene (or, in tests, at an invented wall). Gives one hit for each ray.
using CastRays = std::function<void(std::span<const Ray> rays, std::span<Hit> hits)>;

/// Returns a function that casts into @p scene, which must outlive it. @p without: body that rays pass
/// through; -1: none.
[[nodiscard]] inline CastRays castInto(const Scene& scene, RayKind kind, int without = -1) {
    return [&scene, kind, without](std::span<const Ray> rays, std::span<Hit> hits) {
        scene.cast(rays, hits, kind, without);
    };
}

}  // namespace leitstand::simulation
