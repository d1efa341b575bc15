#include "robots/simulation/scene/scene.h"

namespace leitstand::simulation {

Scene::Scene(const Arena& arena) : Scene(arena, meshOf(arena)) {}

}  // namespace leitstand::simulation
