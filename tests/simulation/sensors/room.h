#pragma once

#include <memory>
#include <string>
#include <vector>

#include "robots/simulation/world/world.h"

namespace leitstand::simulation::test {

/// A room made of boxes, for sensors.
class RoomBuilder {
public:
    RoomBuilder();

    /// A surface of its own. Returns its number.
    int surface(Material material, Label label = Label::Wall, double celsius = 20.0);
    void setColour(int surface, float red, float green, float blue);
    /// A box from corner @p from to corner @p to [m].
    void box(int surface, const Eigen::Vector3d& from, const Eigen::Vector3d& to);
    /// Floor (top at z = 0) and four walls of plaster with their inner faces at +-x, +-y, @p height high.
    void walls(double x, double y, double height);
    void victim(const Eigen::Vector3d& mouthOfIt, double co2);

    [[nodiscard]] std::unique_ptr<World> world(std::uint64_t seed = 1) const;
    [[nodiscard]] Arena& arena() { return m_arena; }

private:
    Arena m_arena;
    ArenaMesh m_mesh;
};

/// Kurt3D's body without a shape, at @p x, @p y with its front to @p yaw: what it carries sees only the room.
int addBareRobot(World& world, double x = 0.0, double y = 0.0, double yaw = 0.0);

/// Where the lens of a camera that looks along base_link's x is: no more than a point.
[[nodiscard]] Pose opticalAt(double x, double y, double z);

}  // namespace leitstand::simulation::test
