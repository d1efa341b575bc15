#include <algorithm>
#include <cmath>

#include "robots/simulation/arena/mesh/element_meshes.h"

namespace leitstand::simulation {
namespace {

/// Adds four legs of section @p thick, @p inset from the edges of @p size [m].
void legs(MeshBuilder& builder, const Eigen::Vector2d& size, double height, double thick, double inset) {
    const double x = std::max(thick, size.x() / 2 - inset - thick / 2);
    const double y = std::max(thick, size.y() / 2 - inset - thick / 2);
    for (const double sx : {-x, x}) {
        for (const double sy : {-y, y}) {
            builder.box({sx - thick / 2, sy - thick / 2, 0.0}, {sx + thick / 2, sy + thick / 2, height});
        }
    }
}

}  // namespace

void addTable(MeshBuilder& builder, const Element& element) {
    const Eigen::Vector3d& size = element.size;
    const double top = std::min(0.03, size.z() / 2);
    legs(builder, size.head<2>(), size.z() - top, 0.05, 0.15 * std::min(size.x(), size.y()));
    builder.box({-size.x() / 2, -size.y() / 2, size.z() - top}, {size.x() / 2, size.y() / 2, size.z()});
}

void addChair(MeshBuilder& builder, const Element& element) {
    const Eigen::Vector3d half = element.size / 2;
    const double seat = 0.52 * element.size.z();
    legs(builder, element.size.head<2>(), seat - 0.03, 0.035, 0.01);
    builder.box({-half.x(), -half.y(), seat - 0.03}, {half.x(), half.y(), seat});
    builder.box({-half.x(), half.y() - 0.03, seat + 0.1}, {half.x(), half.y(), element.size.z()});
    for (const double x : {-half.x() + 0.02, half.x() - 0.05}) {
        builder.box({x, half.y() - 0.05, seat}, {x + 0.03, half.y() - 0.031, element.size.z() - 0.02});
    }
}

void addHeater(MeshBuilder& builder, const Element& element) {
    const Eigen::Vector3d& size = element.size;
    const double foot = std::min(0.08, size.z() / 4);
    const int ribs = std::clamp(static_cast<int>(std::lround(size.x() / 0.07)), 2, 100);
    const double pitch = size.x() / ribs;
    for (int i = 0; i < ribs; ++i) {
        const double x = -size.x() / 2 + i * pitch;
        builder.box({x + 0.15 * pitch, -size.y() / 2, foot}, {x + 0.85 * pitch, size.y() / 2, size.z()});
    }
    // Pipes through the ribs, and feet.
    for (const double z : {foot + 0.15 * (size.z() - foot), foot + 0.85 * (size.z() - foot)}) {
        builder.box({-size.x() / 2, -size.y() / 6, z - 0.02}, {size.x() / 2, size.y() / 6, z + 0.02});
    }
    for (const double x : {-0.5 * size.x() + 0.5 * pitch, 0.5 * size.x() - 0.5 * pitch}) {
        builder.box({x - 0.015, -size.y() / 4, 0.0}, {x + 0.015, size.y() / 4, foot});
    }
}

void addLamp(MeshBuilder& builder, const Element& element) {
    const Eigen::Vector3d& size = element.size;
    const double radius = size.z() / 2;
    if (size.x() > 2 * size.z()) {
        builder.cylinder({-size.x() / 2, 0.0, radius}, {size.x() / 2, 0.0, radius}, radius);
    } else {
        builder.ellipsoid({0.0, 0.0, radius}, size / 2);
    }
}

}  // namespace leitstand::simulation
