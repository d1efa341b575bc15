#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <vector>

#include "robots/simulation/arena/mesh.h"
#include "robots/simulation/scene/embree.h"
#include "robots/simulation/scene/scene.h"

namespace leitstand::simulation {

/// Bits of Embree's masks. A triangle bears Solid or Soft, an instance the bit of its body; a ray enters what
/// it shares a bit with, at both levels.
namespace mask {
inline constexpr unsigned Solid = 1U << 0, Soft = 1U << 1;
inline constexpr unsigned Still = 1U << 2, Moving = 1U << 3;
inline constexpr unsigned bodyBit(int body) {
    return 1U << (4 + body);
}
inline constexpr unsigned AllBodies = ~0U << 4;
/// What a ray is let meet.
[[nodiscard]] inline constexpr unsigned of(RayKind kind, int without) {
    const unsigned kinds = kind == RayKind::Contact ? Solid : Solid | Soft;
    if (without == Scene::StillOnly) return kinds | Still;
    const unsigned all = Still | Moving | AllBodies;
    const bool names = without >= 0 && without < Scene::MaxBodies;
    return kinds | (names ? all & ~bodyBit(without) : all);
}
}  // namespace mask

/// Triangles in Embree's index, instanced at a place of their own. Solid and soft ones are geometries of
/// their own, so that masks can tell them apart.
class EmbreeMesh {
public:
    /// Whether a surface stops robots.
    using IsSolid = std::function<bool(const Surface&)>;

    /// Throws std::invalid_argument where @p mesh names a corner, surface or texture that it has not.
    EmbreeMesh(RTCDevice device, Mesh mesh, unsigned maskOfInstance, const IsSolid& isSolid);
    ~EmbreeMesh();
    EmbreeMesh(const EmbreeMesh&) = delete;
    EmbreeMesh& operator=(const EmbreeMesh&) = delete;

    void attachTo(RTCScene scene, unsigned id);
    void place(const Pose& meshInArena);
    void hide();

    /// What was met, from Embree's numbers; the normal towards where @p direction comes from.
    [[nodiscard]] Hit hitOf(unsigned geometry, unsigned triangle, float u, float v,
                            const Eigen::Vector3f& normal, const Eigen::Vector3f& direction,
                            float distance) const;

private:
    void addGeometry(RTCDevice device, unsigned id, unsigned maskOfTriangles);

    Mesh m_mesh;
    std::array<std::vector<std::uint32_t>, 2> m_triangles;  ///< of each geometry: solid, soft
    Eigen::Matrix3f m_turn = Eigen::Matrix3f::Identity();
    RTCScene m_scene = nullptr;
    RTCGeometry m_instance = nullptr;
};

}  // namespace leitstand::simulation
