#include "tests/simulation/sensors/room.h"

#include "robots/simulation/sensors/sensor_place.h"

namespace leitstand::simulation::test {

RoomBuilder::RoomBuilder() {
    m_arena.name = "room";
    m_arena.from = {-3, -3};
    m_arena.to = {3, 3};
}

int RoomBuilder::surface(Material material, Label label, double celsius) {
    Surface surface;
    surface.material = material;
    surface.label = label;
    surface.colour = propertiesOf(material).albedo;
    surface.temperature = static_cast<float>(celsius + 273.15);
    m_mesh.still.surfaces.push_back(surface);
    return static_cast<int>(m_mesh.still.surfaces.size()) - 1;
}

void RoomBuilder::setColour(int surface, float red, float green, float blue) {
    m_mesh.still.surfaces[static_cast<std::size_t>(surface)].colour = {red, green, blue};
}

void RoomBuilder::box(int surface, const Eigen::Vector3d& from, const Eigen::Vector3d& to) {
    Mesh& mesh = m_mesh.still;
    const auto first = static_cast<std::uint32_t>(mesh.corners.size());
    for (int i = 0; i < 8; ++i) {
        mesh.corners.emplace_back(Eigen::Vector3d((i & 1) != 0 ? to.x() : from.x(),
                                                  (i & 2) != 0 ? to.y() : from.y(),
                                                  (i & 4) != 0 ? to.z() : from.z())
                                      .cast<float>());
        mesh.uv.emplace_back(0.0F, 0.0F);
    }
    const std::uint32_t faces[6][4] = {{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4},
                                       {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}};
    for (const auto& face : faces) {
        mesh.triangles.push_back({first + face[0], first + face[1], first + face[2]});
        mesh.triangles.push_back({first + face[0], first + face[2], first + face[3]});
        mesh.surfaceOf.insert(mesh.surfaceOf.end(), 2, static_cast<std::uint16_t>(surface));
    }
}

void RoomBuilder::walls(double x, double y, double height) {
    m_arena.from = {-x, -y};
    m_arena.to = {x, y};
    const int floor = surface(Material::Concrete, Label::Floor);
    const int wall = surface(Material::Plaster);
    box(floor, {-x, -y, -0.1}, {x, y, 0.0});
    box(wall, {-x - 0.1, -y, 0}, {-x, y, height});
    box(wall, {x, -y, 0}, {x + 0.1, y, height});
    box(wall, {-x, -y - 0.1, 0}, {x, -y, height});
    box(wall, {-x, y, 0}, {x, y + 0.1, height});
}

void RoomBuilder::victim(const Eigen::Vector3d& mouth, double co2) {
    Element element;
    element.kind = ElementKind::Victim;
    element.name = "victim";
    element.size = {1.7, 0.5, 0.3};
    element.victim = VictimTraits{};
    element.victim->co2 = co2;
    element.pose.translation() = mouth - mouthOf(element);
    m_arena.elements.push_back(element);
}

std::unique_ptr<World> RoomBuilder::world(std::uint64_t seed) const {
    return std::make_unique<World>(m_arena, m_mesh, seed);
}

int addBareRobot(World& world, double x, double y, double yaw) {
    BodySpec spec = kurt3dBody();
    spec.shape = {};
    return world.addRobot(spec, poseFrom({x, y, 0.0}, 0.0, 0.0, yaw));
}

Pose opticalAt(double x, double y, double z) {
    Pose pose = Pose::Identity();
    pose.translation() << x, y, z;
    pose.linear() = opticalAxes();
    return pose;
}

}  // namespace leitstand::simulation::test
