#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include <Eigen/Core>

#include "core/base/pose.h"
#include "core/cloud/scan.h"
#include "robots/simulation/arena/arena.h"

namespace leitstand::simulation {

/// What is painted on a surface, besides its colour.
struct Texture {
    int width = 0, height = 0;         ///< [px]
    std::vector<std::uint8_t> pixels;  ///< rgb8, row-major, first row at v = 1
};

/// What a part of a mesh looks like to each sensor.
struct Surface {
    Material material = Material::Plywood;
    Label label = Label::Unlabelled;  ///< true one: what a perfect labelling would say
    Eigen::Vector3f colour = Eigen::Vector3f::Constant(0.5F);  ///< red, green, blue, 0 to 1
    float temperature = 293.15F;                               ///< [K]
    float glow = 0.0F;                                         ///< light that it gives, 0: none
    int texture = -1;                                          ///< of Mesh::textures
    int element = -1;                                          ///< of Arena::elements; -1: none
};

/// Triangles, in one frame.
struct Mesh {
    std::vector<Eigen::Vector3f> corners;                 ///< [m]
    std::vector<Eigen::Vector2f> uv;                      ///< one a corner, 0 to 1 on the texture
    std::vector<std::array<std::uint32_t, 3>> triangles;  ///< counter-clockwise from outside
    std::vector<std::uint16_t> surfaceOf;                 ///< of each triangle: one of surfaces
    std::vector<Surface> surfaces;
    std::vector<Texture> textures;
};

/// A part that moves by itself: a waving arm, a spectator.
struct MovingPart {
    Mesh mesh;                                        ///< in its own frame
    Pose hinge = Pose::Identity();                    ///< of the part's frame in the arena's, at rest
    Eigen::Vector3d axis = Eigen::Vector3d::UnitX();  ///< about which it swings, in the part's frame
    double swing = 0.0;                               ///< to each side [rad]
    double period = 1.0;                              ///< [s]
    Eigen::Vector3d sway = Eigen::Vector3d::Zero();   ///< how far it walks to and fro, arena's frame [m]

    [[nodiscard]] Pose at(double seconds) const;  ///< part's frame in the arena's
};

/// All that stands in an arena.
struct ArenaMesh {
    Mesh still;  ///< arena's frame
    std::vector<MovingPart> moving;
};

[[nodiscard]] ArenaMesh meshOf(const Arena& arena);

}  // namespace leitstand::simulation
