#pragma once

#include <chrono>
#include <cmath>
#include <cstdint>
#include <string>

#include "core/base/pose.h"
#include "robots/control/speed_controller.h"
#include "robots/simulation/world/shapes.h"
#include "robots/simulation/world/world.h"

namespace leitstand::simulation {

/// An arena put together from shapes, with a floor from -20 to 20 m.
struct TestArena {
    Arena arena;
    ArenaMesh mesh;

    TestArena() {
        addBox(mesh.still, surface(ElementKind::Floor, "floor", Material::Concrete), {-20, -20, -0.1},
               {20, 20, 0});
    }

    int surface(ElementKind kind, const std::string& name, Material material = Material::Plywood) {
        Element element;
        element.kind = kind;
        element.name = name;
        arena.elements.push_back(element);
        Surface surface;
        surface.material = material;
        surface.element = static_cast<int>(arena.elements.size()) - 1;
        return addSurface(mesh.still, surface);
    }
    void box(const Eigen::Vector3d& from, const Eigen::Vector3d& to, ElementKind kind = ElementKind::Wall,
             const std::string& name = "wall", Material material = Material::Plywood) {
        addBox(mesh.still, surface(kind, name, material), from, to);
    }
    /// Rises along x from @p at by @p angle [rad] for @p length, with a platform behind.
    void ramp(const Eigen::Vector3d& at, double angle, double length, double width = 2.0) {
        const int wood = surface(ElementKind::Ramp, "ramp");
        const double height = length * std::tan(angle);
        addWedge(mesh.still, wood, poseFrom(at, 0, 0, 0), {length, width, height});
        addBox(mesh.still, wood, at + Eigen::Vector3d(length, -width / 2, 0),
               at + Eigen::Vector3d(length + 3.0, width / 2, height));
    }
    void stairs(double x, double riser, double tread, int count) {
        const int wood = surface(ElementKind::Stairs, "stairs");
        for (int i = 0; i < count; ++i) {
            addBox(mesh.still, wood, {x + i * tread, -1, 0}, {x + count * tread + 3.0, 1, (i + 1) * riser});
        }
    }
    [[nodiscard]] World world(std::uint64_t seed = 1) const { return {arena, mesh, seed}; }
};

inline constexpr std::chrono::milliseconds Tick{5};

/// Drives with a speed controller for each side, as agents do.
class Driver {
public:
    explicit Driver(World& world, int robot, double fullSpeed = 0.7)
        : m_world(world), m_robot(robot), m_left({fullSpeed}), m_right({fullSpeed}) {}

    /// One tick with wheels at @p left and @p right [m/s].
    void tick(double left, double right) {
        const BodyState& state = m_world.state(m_robot);
        const double seconds = std::chrono::duration<double>(Tick).count();
        m_world.setMotors(m_robot, m_left.step(left, state.left, seconds),
                          m_right.step(right, state.right, seconds));
    }
    void drive(double left, double right, double seconds) {
        for (int i = 0; i < static_cast<int>(seconds * 200.0); ++i) {
            tick(left, right);
            m_world.advance(Tick);
        }
    }

private:
    World& m_world;
    int m_robot;
    SpeedController m_left, m_right;
};

inline double rollOf(const BodyState& state) {
    return std::atan2(state.baseInArena.linear()(2, 1), state.baseInArena.linear()(2, 2));
}
/// Nose up is negative (REP 103).
inline double pitchOf(const BodyState& state) {
    const Eigen::Matrix3d turn = state.baseInArena.linear();
    return -std::atan2(turn(2, 0), std::hypot(turn(0, 0), turn(1, 0)));
}
inline double yawOf(const BodyState& state) {
    return std::atan2(state.baseInArena.linear()(1, 0), state.baseInArena.linear()(0, 0));
}

}  // namespace leitstand::simulation
