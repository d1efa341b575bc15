#include <algorithm>
#include <cmath>

#include "robots/simulation/arena/mesh/element_meshes.h"
#include "robots/simulation/arena/random.h"

namespace leitstand::simulation {
namespace {

struct Piece {
    Eigen::Vector3d size;
    Material material;
};

Piece pieceFrom(Random& random, const Eigen::Vector3d& room) {
    if (random.chance(0.7)) return {{0.24, 0.115, 0.071}, Material::Concrete};
    const double most = 0.6 * std::min(room.x(), room.y());
    return {{std::min(random.between(0.35, 0.7), most), random.between(0.08, 0.15), 0.02}, Material::Plywood};
}

}  // namespace

void addRubble(MeshBuilder& builder, const ElementPlace& place) {
    const Eigen::Vector3d& size = place.element.size;
    Random random(place.element.seed);
    const int pieces = std::clamp(static_cast<int>(std::lround(45.0 * size.x() * size.y())), 6, 400);
    const Look brick = lookOf(place, builder);
    const Look board = lookOf(place, Material::Plywood, builder);
    for (int i = 0; i < pieces; ++i) {
        const Piece piece = pieceFrom(random, size);
        // The heap is higher in its middle; pieces sink into those below.
        const double u = random.between(-1.0, 1.0);
        const double v = random.between(-1.0, 1.0);
        const double heap = std::max(0.0, size.z() - 0.5 * piece.size.x()) * (1.0 - u * u) * (1.0 - v * v);
        const double reach = piece.size.norm() / 2;
        const Eigen::Vector3d centre(u * std::max(0.0, size.x() / 2 - reach),
                                     v * std::max(0.0, size.y() / 2 - reach),
                                     piece.size.z() / 2 + heap * random.between(0.2, 0.8));
        const double tilt = std::min(0.5, centre.z() / piece.size.x() * 1.6);
        const Pose frame = poseFrom(centre, random.between(-tilt, tilt), random.between(-tilt, tilt),
                                    random.between(-3.14, 3.14));
        builder.setLook(piece.material == Material::Plywood ? board : brick);
        builder.box(frame, -piece.size / 2, piece.size / 2);
    }
    builder.setLook(brick);
}

}  // namespace leitstand::simulation
