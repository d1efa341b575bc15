#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <vector>

#include "robots/simulation/arena/mesh.h"
#include "robots/simulation/scene/embree.h"
#include "robots/simulation/scene/scene.h"

namespace leitstand::simulation {

/// Bits of Embree's masks. A triangle has the bit Solid or Soft; an instance has Still, Moving or the bit of
/// its body. A ray hits a triangle if it shares a bit with the triangle and a bit with the instance.
namespace mask {
inline constexpr unsigned Solid = 1U << 0, Soft = 1U << 1;
inline constexpr unsigned Still = 1U << 2, Moving = 1U << 3;
inline constexpr unsigned bodyBit(int body) {
    return 1U << (4 + body);
}
inline constexpr unsigned AllBodies = ~0U << 4;
/// Returns the mask of what a ray can hit. @p without: as in Scene::cast().
[[nodiscard]] inline constexpr unsigned of(RayKind kind, int without) {
    const unsigned kinds = kind == RayKind::Contact ? Solid : Solid | Soft;
    if (without == Scene::StillOnly) return kinds | Still;
    const unsigned all = Still | Moving | AllBodies;
    const bool names = without >= 0 && without < Scene::MaxBodies;
    return kinds | (names ? all & ~bodyBit(without) : all);
}
}  // namespace mask

/// A mesh in Embree's index, with its own pose. Solid and soft triangles are separate geometries, so that
/// masks can distinguish them.
class EmbreeMesh {
public:
    /// Returns whether a surface stops robots.
    using IsSolid = std::function<bool(const Surface&)>;

    /// Throws std::invalid_argument when @p mesh refers to a corner, surface or texture that it does not
    /// have.
    EmbreeMesh(RTCDevice device, Mesh mesh, unsigned maskOfInstance, const IsSolid& isSolid);
    ~EmbreeMesh();
    EmbreeMesh(const EmbreeMesh&) = delete;
    EmbreeMesh& operator=(const EmbreeMesh&) = delete;

    void attachTo(RTCScene scene, unsigned id);
    void place(const Pose& meshInArena);
    void hide();

    /// Returns the hit for the numbers that Embree reports. Its normal points against @p direction.
    [[nodiscard]] Hit hitOf(unsigned geometry, unsigned triangle, float u, float v,
                            const Eigen::Vector3f& normal, const Eigen::Vector3f& direction,
                            float distance) const;

private:
    void addGeometry(RTCDevice device, unsigned id, unsigned maskOfTriangles);

    Mesh m_mesh;
    std::array<std::vector<std::uint32_t>, 2> m_triangles;  ///< triangles of each geometry: solid, soft
    Eigen::Matrix3f m_turn = Eigen::Matrix3f::Identity();
    RTCScene m_scene = nullptr;
    RTCGeometry m_instance = nullptr;
};

}  // namespace leitstand::simulation
