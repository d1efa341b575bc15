#pragma once

#include <cstdint>
#include <limits>
#include <memory>
#include <span>

#include <Eigen/Core>

#include "core/base/pose.h"
#include "robots/simulation/arena/mesh.h"

namespace leitstand::simulation {

/// What a ray is to. Every kind but Contact ends at the first surface, foil too: it hides from cameras and
/// the laser; what is behind it the infrared camera sees by casting on (material's infraredTransmission).
enum class RayKind : std::uint8_t {
    Laser,
    Camera,
    Infrared,
    Contact,  ///< meets only what stops robots: solid materials, and victims and spectators, clothes too
};

struct Ray {
    Eigen::Vector3f origin = Eigen::Vector3f::Zero();      ///< arena's frame [m]
    Eigen::Vector3f direction = Eigen::Vector3f::UnitX();  ///< unit length
    float near = 0.0F;                                     ///< [m]
    float far = std::numeric_limits<float>::infinity();    ///< [m]
};

/// Where a ray ended.
struct Hit {
    float distance = std::numeric_limits<float>::infinity();  ///< [m]; infinite: nowhere
    Eigen::Vector3f normal = Eigen::Vector3f::Zero();         ///< unit length, towards the ray's origin
    Eigen::Vector2f uv = Eigen::Vector2f::Zero();             ///< on the surface's texture
    const Surface* surface = nullptr;
    const Texture* texture = nullptr;  ///< of the surface; null: none
    int body = -1;                     ///< that was met; -1: the arena itself
    [[nodiscard]] bool there() const { return surface != nullptr; }
};

/// An arena with bodies in it, for rays (Embree). Rays may be cast by several threads at once, while nobody
/// changes the scene.
class Scene {
public:
    /// For cast(): passes through no body; through all of them and through what moves by itself.
    static constexpr int Everything = -1, StillOnly = -2;
    static constexpr int MaxBodies = 28;

    explicit Scene(const Arena& arena);
    /// The same from triangles made elsewhere: @p mesh need not be meshOf(@p arena). Throws
    /// std::invalid_argument where a mesh names a corner, surface or texture that it has not.
    Scene(Arena arena, ArenaMesh mesh);
    ~Scene();
    Scene(const Scene&) = delete;
    Scene& operator=(const Scene&) = delete;

    /// A body that moves; placed at the arena's origin, not seen before place(). Throws std::length_error
    /// after MaxBodies.
    [[nodiscard]] int addBody(const Mesh& mesh);
    void place(int body, const Pose& bodyInArena);
    void hide(int body);
    /// Moves what moves by itself to where it is @p seconds after the beginning. Changes count after
    /// commit().
    void setTime(double seconds);
    void commit();  ///< some microseconds: triangles are indexed once, only their places anew

    /// @p without: a body that is passed through, Everything, or StillOnly. A ray that is not finite or has
    /// no direction ends nowhere; so does a Laser's that smoke
    /// swallows.
    [[nodiscard]] Hit cast(const Ray& ray, RayKind kind, int without = Everything) const;
    /// The same for many (hits.size() >= rays.size()); quick where neighbours go the same way.
    void cast(std::span<const Ray> rays, std::span<Hit> hits, RayKind kind, int without = Everything) const;

    [[nodiscard]] const Arena& arena() const;

private:
    struct State;
    std::unique_ptr<State> m_state;
};

}  // namespace leitstand::simulation
