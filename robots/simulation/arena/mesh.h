#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include <Eigen/Core>

#include "core/base/pose.h"
#include "core/cloud/scan.h"
#include "robots/simulation/arena/arena.h"

namespace leitstand::simulation {

/// Picture on a surface, instead of a single colour.
struct Texture {
    int width = 0, height = 0;         ///< [px]
    std::vector<std::uint8_t> pixels;  ///< rgb8, row by row; the first row is at v = 1
};

/// How a part of a mesh looks to each sensor.
struct Surface {
    Material material = Material::Plywood;
    Label label = Label::Unlabelled;  ///< true label, as a perfect labelling would give
    Eigen::Vector3f colour = Eigen::Vector3f::Constant(0.5F);  ///< red, green, blue, 0 to 1
    float temperature = 293.15F;                               ///< [K]
    float glow = 0.0F;                                         ///< light that it emits; 0: none
    int texture = -1;                                          ///< index into Mesh::textures; -1: none
    int element = -1;                                          ///< index into Arena::elements; -1: none
};

/// Triangles in one frame.
struct Mesh {
    std::vector<Eigen::Vector3f> corners;  ///< [m]
    std::vector<Eigen::Vector2f> uv;       ///< one per corner: position on the texture, 0 to 1
    /// Corners of each triangle, counter-clockwise seen from outside.
    std::vector<std::array<std::uint32_t, 3>> triangles;
    std::vector<std::uint16_t> surfaceOf;  ///< surface of each triangle, as an index into `surfaces`
    std::vector<Surface> surfaces;
    std::vector<Texture> textures;
};

/// A part that moves by itself: a waving arm, a spectator.
struct MovingPart {
    Mesh mesh;                                        ///< in its own frame
    Pose hinge = Pose::Identity();                    ///< pose of the part's frame in the arena, at rest
    Eigen::Vector3d axis = Eigen::Vector3d::UnitX();  ///< axis about which it swings, in the part's frame
    double swing = 0.0;                               ///< angle to each side [rad]
    double period = 1.0;                              ///< period of the motion [s]
    /// How far it moves to each side, in the arena's frame [m].
    Eigen::Vector3d sway = Eigen::Vector3d::Zero();

    [[nodiscard]] Pose at(double seconds) const;  ///< pose of the part's frame in the arena
};

/// Meshes of everything in an arena.
struct ArenaMesh {
    Mesh still;  ///< arena's frame
    std::vector<MovingPart> moving;
};

[[nodiscard]] ArenaMesh meshOf(const Arena& arena);

}  // namespace leitstand::simulation
