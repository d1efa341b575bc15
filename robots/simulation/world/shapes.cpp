#include "robots/simulation/world/shapes.h"

#include <array>
#include <cmath>
#include <initializer_list>
#include <numbers>

#include <Eigen/Geometry>

namespace leitstand::simulation {
namespace {

std::uint32_t addCorner(Mesh& mesh, const Eigen::Vector3d& corner) {
    mesh.corners.push_back(corner.cast<float>());
    mesh.uv.push_back(Eigen::Vector2f::Zero());
    return static_cast<std::uint32_t>(mesh.corners.size() - 1);
}

void addTriangle(Mesh& mesh, int surface, std::uint32_t a, std::uint32_t b, std::uint32_t c) {
    mesh.triangles.push_back({a, b, c});
    mesh.surfaceOf.push_back(static_cast<std::uint16_t>(surface));
}

/// Adds a flat polygon, counter-clockwise from outside.
void addFace(Mesh& mesh, int surface, const Pose& pose, std::initializer_list<Eigen::Vector3d> corners) {
    std::uint32_t first = 0, last = 0;
    std::size_t count = 0;
    for (const Eigen::Vector3d& corner : corners) {
        const std::uint32_t added = addCorner(mesh, pose * corner);
        if (count == 0) first = added;
        if (count >= 2) addTriangle(mesh, surface, first, last, added);
        last = added;
        ++count;
    }
}

}  // namespace

int addSurface(Mesh& mesh, const Surface& surface) {
    mesh.surfaces.push_back(surface);
    return static_cast<int>(mesh.surfaces.size()) - 1;
}

void addBox(Mesh& mesh, int surface, const Eigen::Vector3d& from, const Eigen::Vector3d& to) {
    addBox(mesh, surface, Pose::Identity(), from, to);
}

void addBox(Mesh& mesh, int surface, const Pose& boxInMesh, const Eigen::Vector3d& from,
            const Eigen::Vector3d& to) {
    const auto corner = [&](int x, int y, int z) {
        return Eigen::Vector3d(x != 0 ? to.x() : from.x(), y != 0 ? to.y() : from.y(),
                               z != 0 ? to.z() : from.z());
    };
    const auto face = [&](const Eigen::Vector3d& a, const Eigen::Vector3d& b, const Eigen::Vector3d& c,
                          const Eigen::Vector3d& d) {
        addFace(mesh, surface, boxInMesh, {a, b, c, d});
    };
    face(corner(0, 0, 1), corner(1, 0, 1), corner(1, 1, 1), corner(0, 1, 1));
    face(corner(0, 0, 0), corner(0, 1, 0), corner(1, 1, 0), corner(1, 0, 0));
    face(corner(0, 0, 0), corner(1, 0, 0), corner(1, 0, 1), corner(0, 0, 1));
    face(corner(0, 1, 0), corner(0, 1, 1), corner(1, 1, 1), corner(1, 1, 0));
    face(corner(0, 0, 0), corner(0, 0, 1), corner(0, 1, 1), corner(0, 1, 0));
    face(corner(1, 0, 0), corner(1, 1, 0), corner(1, 1, 1), corner(1, 0, 1));
}

void addCylinder(Mesh& mesh, int surface, const Eigen::Vector3d& from, const Eigen::Vector3d& to,
                 double radius, int sides) {
    const Eigen::Vector3d axis = (to - from).normalized();
    const Eigen::Vector3d across = axis.unitOrthogonal(), upright = axis.cross(across);
    const auto rim = [&](int side) -> Eigen::Vector3d {
        const double angle = 2.0 * std::numbers::pi * side / sides;
        return radius * (std::cos(angle) * across + std::sin(angle) * upright);
    };
    for (int i = 0; i < sides; ++i) {
        const Eigen::Vector3d a = rim(i), b = rim(i + 1);
        addFace(mesh, surface, Pose::Identity(), {from + a, from + b, to + b, to + a});
        addFace(mesh, surface, Pose::Identity(), {to, to + a, to + b});
        addFace(mesh, surface, Pose::Identity(), {from, from + b, from + a});
    }
}

void addWedge(Mesh& mesh, int surface, const Pose& wedgeInMesh, const Eigen::Vector3d& size) {
    const double x = size.x(), y = 0.5 * size.y(), z = size.z();
    const Eigen::Vector3d a(0, -y, 0), b(0, y, 0), c(x, -y, 0), d(x, y, 0), e(x, -y, z), f(x, y, z);
    addFace(mesh, surface, wedgeInMesh, {a, e, f, b});
    addFace(mesh, surface, wedgeInMesh, {a, b, d, c});
    addFace(mesh, surface, wedgeInMesh, {c, d, f, e});
    addFace(mesh, surface, wedgeInMesh, {a, c, e});
    addFace(mesh, surface, wedgeInMesh, {b, f, d});
}

}  // namespace leitstand::simulation
