#pragma once

#include <cstdint>
#include <limits>
#include <memory>
#include <span>

#include <Eigen/Core>

#include "core/base/pose.h"
#include "robots/simulation/arena/mesh.h"

namespace leitstand::simulation {

/// Purpose of a ray. Every kind but Contact ends at the first surface, also at foil. Foil hides what is
/// behind it from cameras and the laser. The infrared camera casts a second ray behind foil
/// (infraredTransmission of the material).
enum class RayKind : std::uint8_t {
    Laser,
    Camera,
    Infrared,
    Contact,  ///< meets only what stops robots: solid materials, victims, spectators, their clothes too
};

struct Ray {
    Eigen::Vector3f origin = Eigen::Vector3f::Zero();      ///< arena's frame [m]
    Eigen::Vector3f direction = Eigen::Vector3f::UnitX();  ///< unit length
    float near = 0.0F;                                     ///< [m]
    float far = std::numeric_limits<float>::infinity();    ///< [m]
};

/// Where a ray ends.
struct Hit {
    float distance = std::numeric_limits<float>::infinity();  ///< [m]; infinite: nowhere
    Eigen::Vector3f normal = Eigen::Vector3f::Zero();         ///< unit length, towards the ray's origin
    Eigen::Vector2f uv = Eigen::Vector2f::Zero();             ///< on the surface's texture
    const Surface* surface = nullptr;
    const Texture* texture = nullptr;  ///< of the surface; null: none
    int body = -1;                     ///< body that was met; -1: the arena itself
    [[nodiscard]] bool there() const { return surface != nullptr; }
};

/// An arena with bodies in it, for ray casting (Embree). Several threads may cast rays at once while nobody
/// changes the scene.
class Scene {
public:
    /// For @p without of cast(): rays meet everything (Everything), or pass through all bodies and moving
    /// parts (StillOnly).
    static constexpr int Everything = -1, StillOnly = -2;
    static constexpr int MaxBodies = 28;

    explicit Scene(const Arena& arena);
    /// Takes triangles made elsewhere: @p mesh need not be meshOf(@p arena). Throws std::invalid_argument
    /// when a mesh names a corner, surface or texture that it does not have.
    Scene(Arena arena, ArenaMesh mesh);
    ~Scene();
    Scene(const Scene&) = delete;
    Scene& operator=(const Scene&) = delete;

    /// Adds a body that moves, at the arena's origin, hidden until place(). Returns its number. Throws
    /// std::length_error after MaxBodies.
    [[nodiscard]] int addBody(const Mesh& mesh);
    void place(int body, const Pose& bodyInArena);
    void hide(int body);
    /// Moves the moving parts to where they are @p seconds after the beginning. This, place() and hide() take
    /// effect with commit().
    void setTime(double seconds);
    void commit();  ///< takes some microseconds: only places are indexed again, not triangles

    /// Casts one ray. @p without: a body that is passed through, Everything, or StillOnly. A ray that is not
    /// finite or has no direction hits nothing; nor does a Laser ray that smoke swallows.
    [[nodiscard]] Hit cast(const Ray& ray, RayKind kind, int without = Everything) const;
    /// Casts many rays (hits.size() >= rays.size()); fast when neighbours have similar directions.
    void cast(std::span<const Ray> rays, std::span<Hit> hits, RayKind kind, int without = Everything) const;

    [[nodiscard]] const Arena& arena() const;

private:
    struct State;
    std::unique_ptr<State> m_state;
};

}  // namespace leitstand::simulation
