#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include <Eigen/Core>

#include "core/base/pose.h"
#include "core/cloud/scan.h"
#include "robots/simulation/arena/arena.h"

namespace leitstand::simulation {

/// Picture painted on a surface, in place of its colour.
struct Texture {
    int width = 0, height = 0;         ///< [px]
    std::vector<std::uint8_t> pixels;  ///< rgb8, row-major, first row at v = 1
};

/// What a part of a mesh looks like to each sensor.
struct Surface {
    Material material = Material::Plywood;
    Label label = Label::Unlabelled;  ///< true label, as a perfect labelling would give it
    Eigen::Vector3f colour = Eigen::Vector3f::Constant(0.5F);  ///< red, green, blue, 0 to 1
    float temperature = 293.15F;                               ///< [K]
    float glow = 0.0F;                                         ///< light that it emits; 0: none
    int texture = -1;                                          ///< index into Mesh::textures; -1: none
    int element = -1;                                          ///< index into Arena::elements; -1: none
};

/// Triangles in one frame.
struct Mesh {
    std::vector<Eigen::Vector3f> corners;                 ///< [m]
    std::vector<Eigen::Vector2f> uv;                      ///< one per corner, 0 to 1 on the texture
    std::vector<std::array<std::uint32_t, 3>> triangles;  ///< counter-clockwise from outside
    std::vector<std::uint16_t> surfaceOf;                 ///< index into surfaces, one per triangle
    std::vector<Surface> surfaces;
    std::vector<Texture> textures;
};

/// A part that moves by itself: a waving arm, a spectator.
struct MovingPart {
    Mesh mesh;                                        ///< in its own frame
    Pose hinge = Pose::Identity();                    ///< part's frame in the arena's, at rest
    Eigen::Vector3d axis = Eigen::Vector3d::UnitX();  ///< about which it swings, in the part's frame
    double swing = 0.0;                               ///< to each side [rad]
    double period = 1.0;                              ///< [s]
    Eigen::Vector3d sway = Eigen::Vector3d::Zero();   ///< how far it walks to and fro, arena's frame [m]

    [[nodiscard]] Pose at(double seconds) const;  ///< part's frame in the arena's
};

/// Meshes of all that stands in an arena.
struct ArenaMesh {
    Mesh still;  ///< arena's frame
    std::vector<MovingPart> moving;
};

[[nodiscard]] ArenaMesh meshOf(const Arena& arena);

}  // namespace leitstand::simulation
