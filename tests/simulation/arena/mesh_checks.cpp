#include "tests/simulation/arena/mesh_checks.h"

#include "core/event/all_samples.h"

namespace leitstand::simulation::test {
namespace {

template <class Visit>
void eachTriangle(const Mesh& mesh, const Visit& visit) {
    for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
        const auto& [a, b, c] = mesh.triangles[i];
        visit(mesh.corners[a].cast<double>(), mesh.corners[b].cast<double>(), mesh.corners[c].cast<double>(),
              mesh.surfaces[mesh.surfaceOf[i]]);
    }
}

}  // namespace

Eigen::Vector3d openArea(const Mesh& mesh) {
    Eigen::Vector3d sum = Eigen::Vector3d::Zero();
    eachTriangle(mesh, [&](const Eigen::Vector3d& a, const Eigen::Vector3d& b, const Eigen::Vector3d& c,
                           const Surface&) { sum += (b - a).cross(c - a) / 2; });
    return sum;
}

double volumeOf(const Mesh& mesh) {
    double sum = 0.0;
    eachTriangle(mesh, [&](const Eigen::Vector3d& a, const Eigen::Vector3d& b, const Eigen::Vector3d& c,
                           const Surface&) { sum += a.dot(b.cross(c)) / 6; });
    return sum;
}

double areaOf(const Mesh& mesh, Label label) {
    double sum = 0.0;
    eachTriangle(mesh, [&](const Eigen::Vector3d& a, const Eigen::Vector3d& b, const Eigen::Vector3d& c,
                           const Surface& surface) {
        if (surface.label == label) sum += (b - a).cross(c - a).norm() / 2;
    });
    return sum;
}

double areaOf(const Mesh& mesh) {
    return areaOf(mesh, Label::Unlabelled) + areaOf(mesh, Label::Floor) + areaOf(mesh, Label::Wall) +
           areaOf(mesh, Label::Ceiling);
}

Eigen::AlignedBox3d boundsOf(const Mesh& mesh) {
    Eigen::AlignedBox3d box;
    for (const Eigen::Vector3f& corner : mesh.corners) box.extend(corner.cast<double>());
    return box;
}

std::string faultOf(const Mesh& mesh) {
    if (mesh.uv.size() != mesh.corners.size()) return "uv";
    if (mesh.surfaceOf.size() != mesh.triangles.size()) return "surfaceOf";
    for (const Eigen::Vector3f& corner : mesh.corners) {
        if (!corner.allFinite()) return "a corner is not finite";
    }
    for (const Eigen::Vector2f& uv : mesh.uv) {
        if (!(uv.minCoeff() >= 0.0F && uv.maxCoeff() <= 1.0F)) return "uv outside the texture";
    }
    for (const auto& triangle : mesh.triangles) {
        for (const std::uint32_t corner : triangle) {
            if (corner >= mesh.corners.size()) return "a triangle's corner";
        }
    }
    for (const std::uint16_t surface : mesh.surfaceOf) {
        if (surface >= mesh.surfaces.size()) return "a triangle's surface";
    }
    for (const Surface& surface : mesh.surfaces) {
        if (surface.texture >= static_cast<int>(mesh.textures.size())) return "a surface's texture";
    }
    for (const Texture& texture : mesh.textures) {
        if (texture.pixels.size() != static_cast<std::size_t>(3 * texture.width * texture.height))
            return "pixels";
    }
    return {};
}

Arena arenaOf(const Element& element) {
    Arena arena;
    arena.from = {-4, -4};
    arena.to = {4, 4};
    arena.elements.push_back(element);
    return arena;
}

}  // namespace leitstand::simulation::test
