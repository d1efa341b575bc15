#pragma once

#include <cstdint>
#include <limits>
#include <memory>
#include <span>

#include <Eigen/Core>

#include "core/base/pose.h"
#include "robots/simulation/arena/mesh.h"

namespace leitstand::simulation {

/// Purpose of a ray. All except Contact end at the first surface, even at foil, which hides what is behind it
/// from cameras and the laser. The infrared camera casts a second ray behind foil (infraredTransmission of
/// the material).
enum class RayKind : std::uint8_t {
    Laser,
    Camera,
    Infrared,
    Contact,  ///< only hits what stops robots: solid materials, victims, spectators and their clothes
};

struct Ray {
    Eigen::Vector3f origin = Eigen::Vector3f::Zero();      ///< origin in the arena's frame [m]
    Eigen::Vector3f direction = Eigen::Vector3f::UnitX();  ///< unit length
    float near = 0.0F;                                     ///< surfaces nearer than this are not hit [m]
    float far = std::numeric_limits<float>::infinity();    ///< surfaces farther than this are not hit [m]
};

/// Where a ray ends.
struct Hit {
    float distance = std::numeric_limits<float>::infinity();  ///< [m]; infinite: it hits nothing
    Eigen::Vector3f normal = Eigen::Vector3f::Zero();         ///< unit length, towards the ray's origin
    Eigen::Vector2f uv = Eigen::Vector2f::Zero();             ///< position on the surface's texture
    const Surface* surface = nullptr;
    const Texture* texture = nullptr;  ///< texture of the surface; null: none
    int body = -1;                     ///< body that was hit; -1: the arena itself
    [[nodiscard]] bool there() const { return surface != nullptr; }
};

/// An arena with bodies in it, for ray casting (Embree). Several threads may cast rays at the same time while
/// nobody changes the scene.
class Scene {
public:
    /// Values for @p without of cast(): rays hit everything (Everything), or pass through all bodies and
    /// moving parts (StillOnly).
    static constexpr int Everything = -1, StillOnly = -2;
    static constexpr int MaxBodies = 28;

    explicit Scene(const Arena& arena);
    /// Uses triangles that were made elsewhere: @p mesh need not be meshOf(@p arena). Throws
    /// std::invalid_argument when a mesh refers to a corner, surface or texture that it does not have.
    Scene(Arena arena, ArenaMesh mesh);
    ~Scene();
    Scene(const Scene&) = delete;
    Scene& operator=(const Scene&) = delete;

    /// Adds a body that can move. It is at the arena's origin and hidden until place(). Returns its number.
    /// Throws std::length_error when there are MaxBodies already.
    [[nodiscard]] int addBody(const Mesh& mesh);
    void place(int body, const Pose& bodyInArena);
    void hide(int body);
    /// Moves the moving parts to where they are after @p seconds. setTime(), place() and hide() take effect
    /// with commit().
    void setTime(double seconds);
    void commit();  ///< takes some microseconds: only poses are indexed again, not triangles

    /// Casts one ray. @p without: number of a body that rays pass through, or Everything, or StillOnly. A ray
    /// that is not finite or has no direction hits nothing; neither does a Laser ray that smoke absorbs.
    [[nodiscard]] Hit cast(const Ray& ray, RayKind kind, int without = Everything) const;
    /// Casts many rays (hits.size() >= rays.size()). This is fast when neighbours have similar directions.
    void cast(std::span<const Ray> rays, std::span<Hit> hits, RayKind kind, int without = Everything) const;

    [[nodiscard]] const Arena& arena() const;

private:
    struct State;
    std::unique_ptr<State> m_state;
};

}  // namespace leitstand::simulation
