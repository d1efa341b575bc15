#pragma once

#include <cstdint>
#include <limits>
#include <memory>
#include <span>

#include <Eigen/Core>

#include "core/base/pose.h"
#include "robots/simulation/arena/mesh.h"

namespace leitstand::simulation {

/// What a ray is to: some surfaces let some of them through.
enum class RayKind : std::uint8_t {
    Laser,
    Camera,
    Infrared,  ///< also meets foil: the sensor sees through by the material's transmission
    Contact,   ///< meets only what stops robots
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
    explicit Scene(const Arena& arena);
    ~Scene();
    Scene(const Scene&) = delete;
    Scene& operator=(const Scene&) = delete;

    /// A body that moves; placed at the arena's origin, not seen before place().
    [[nodiscard]] int addBody(const Mesh& mesh);
    void place(int body, const Pose& bodyInArena);
    void hide(int body);
    /// Moves what moves by itself to where it is @p seconds after the beginning. Changes count after
    /// commit().
    void setTime(double seconds);
    void commit();

    /// @p without: a body that is passed through; -1: none.
    [[nodiscard]] Hit cast(const Ray& ray, RayKind kind, int without = -1) const;
    /// The same for many; quick where neighbours go the same way.
    void cast(std::span<const Ray> rays, std::span<Hit> hits, RayKind kind, int without = -1) const;

    [[nodiscard]] const Arena& arena() const;

private:
    struct State;
    std::unique_ptr<State> m_state;
};

}  // namespace leitstand::simulation
