#include "robots/simulation/sensors/camera/light_field.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace leitstand::simulation {
namespace {

constexpr float LeastCell = 0.4F;    ///< [m]
constexpr float Margin = 1.0F;       ///< around the arena's ground [m]
constexpr float Height = 2.8F;       ///< [m]
constexpr float MostCells = 40.0F;   ///< along x and y: wider arenas have wider cells
constexpr float LampPower = 0.9F;    ///< light at 1 m from a lamp
constexpr float LampReach = 8.0F;    ///< [m]
constexpr float LampSize2 = 0.15F;   ///< keeps what is very near a lamp from turning all white [m2]
constexpr float DirectShare = 0.4F;  ///< share of the hall's light that comes from one side
constexpr float Bounce = 0.30F;      ///< share of the hall's light that a wall reflects
constexpr float NearBounce = 0.8F;   ///< walls nearer than this are darker [m]

/// Returns the directions in which the light of the hall is looked for: faces, corners and edges of a cube.
const std::vector<Eigen::Vector3f>& lookouts() {
    static const std::vector<Eigen::Vector3f> all = [] {
        std::vector<Eigen::Vector3f> directions;
        for (int x = -1; x <= 1; ++x) {
            for (int y = -1; y <= 1; ++y) {
                for (int z = -1; z <= 1; ++z) {
                    if (x == 0 && y == 0 && z == 0) continue;
                    directions.push_back(Eigen::Vector3i(x, y, z).cast<float>().normalized());
                }
            }
        }
        return directions;
    }();
    return all;
}

/// Adds @p light from @p direction to the faces of a cube on which it falls.
template <class Cube>
void addLight(Cube& cube, const Eigen::Vector3f& direction, float light) {
    for (int axis = 0; axis < 3; ++axis) {
        const std::size_t face = 2 * static_cast<std::size_t>(axis) + (direction[axis] < 0.0F ? 1 : 0);
        cube[face] += light * std::abs(direction[axis]);
    }
}

}  // namespace

LightField::LightField(const Scene& scene) : m_hall(static_cast<float>(scene.arena().light)) {
    const Arena& arena = scene.arena();
    const Eigen::Vector2f size =
        (arena.to - arena.from).cast<float>().cwiseMax(0.0F) + Eigen::Vector2f::Constant(2.0F * Margin);
    m_cell = std::max(LeastCell, size.maxCoeff() / MostCells);
    m_from << arena.from.cast<float>() - Eigen::Vector2f::Constant(Margin), m_cell / 2.0F;
    for (int axis = 0; axis < 2; ++axis) m_cells[axis] = static_cast<int>(std::ceil(size[axis] / m_cell)) + 1;
    m_cells.z() = std::max(2, static_cast<int>(Height / m_cell));
    std::vector<Lamp> lamps;
    for (std::size_t i = 0; i < arena.elements.size(); ++i) {
        const Element& element = arena.elements[i];
        if (element.kind != ElementKind::Lamp) continue;
        const Eigen::Vector3d middle = element.pose * Eigen::Vector3d(0.0, 0.0, element.size.z() / 2.0);
        lamps.push_back({middle.cast<float>(), static_cast<int>(i)});
    }
    m_cubes.reserve(static_cast<std::size_t>(m_cells.prod()));
    for (int z = 0; z < m_cells.z(); ++z) {
        for (int y = 0; y < m_cells.y(); ++y) {
            for (int x = 0; x < m_cells.x(); ++x) {
                m_cubes.push_back(measure(scene, positionOf({x, y, z}), lamps));
            }
        }
    }
}

Eigen::Vector3f LightField::positionOf(const Eigen::Vector3i& cell) const {
    return m_from + m_cell * cell.cast<float>();
}

const LightField::Cube& LightField::cubeAt(const Eigen::Vector3i& cell) const {
    return m_cubes[static_cast<std::size_t>((cell.z() * m_cells.y() + cell.y()) * m_cells.x() + cell.x())];
}

LightField::Cube LightField::measure(const Scene& scene, const Eigen::Vector3f& position,
                                     const std::vector<Lamp>& lamps) const {
    Cube cube{}, whole{};
    const auto& directions = lookouts();
    std::vector<Ray> rays;
    for (const Eigen::Vector3f& direction : directions) rays.push_back({position, direction, 0.0F, 6.0F});
    std::vector<Hit> hits(rays.size());
    scene.cast(rays, hits, RayKind::Camera);
    for (std::size_t i = 0; i < directions.size(); ++i) {
        const float up = directions[i].z();
        const float sky = up > -0.1F ? 0.45F + 0.75F * std::max(0.0F, up) : Bounce;
        const float light =
            hits[i].there() ? Bounce * std::min(1.0F, 0.4F + hits[i].distance / NearBounce) : sky;
        addLight(cube, directions[i], (1.0F - DirectShare) * light * m_hall);
        addLight(whole, directions[i], 1.0F);
    }
    for (std::size_t face = 0; face < cube.size(); ++face) cube[face] /= whole[face];
    for (const Lamp& lamp : lamps) {
        const Eigen::Vector3f towards = lamp.position - position;
        const float distance = towards.norm();
        if (distance > LampReach || !(distance > 0.0F)) continue;
        const Hit hit = scene.cast({position, towards / distance, 0.0F, distance}, RayKind::Camera);
        if (hit.there() && hit.surface->element != lamp.element) continue;
        addLight(cube, towards / distance, LampPower / (distance * distance + LampSize2));
    }
    return cube;
}

const Eigen::Vector3f& LightField::towardsHall() {
    static const Eigen::Vector3f direction = Eigen::Vector3f(0.45F, 0.30F, 0.84F).normalized();
    return direction;
}

float LightField::direct(const Eigen::Vector3f& normal) const {
    return DirectShare * 1.3F * m_hall * std::max(0.0F, normal.dot(towardsHall()));
}

float LightField::at(const Eigen::Vector3f& point, const Eigen::Vector3f& normal) const {
    // Cells behind the surface do not count, so that no light leaks through walls.
    const Eigen::Vector3f place = (point + 0.15F * normal - m_from) / m_cell;
    Eigen::Vector3i low;
    Eigen::Vector3f share;
    for (int axis = 0; axis < 3; ++axis) {
        const float most = static_cast<float>(m_cells[axis] - 1);
        const float inside = place[axis] > 0.0F ? std::min(place[axis], most) : 0.0F;
        low[axis] = std::min(static_cast<int>(inside), m_cells[axis] - 2);
        share[axis] = inside - static_cast<float>(low[axis]);
    }
    const Eigen::Vector3f onFaces = normal.cwiseAbs2();
    const std::array<std::size_t, 3> faces = {normal.x() < 0.0F ? 1U : 0U, normal.y() < 0.0F ? 3U : 2U,
                                              normal.z() < 0.0F ? 5U : 4U};
    float sum = 0.0F, weights = 1e-6F;
    for (int corner = 0; corner < 8; ++corner) {
        const Eigen::Vector3i step(corner & 1, (corner >> 1) & 1, corner >> 2);
        const Eigen::Vector3i cell = low + step;
        float weight = 1.0F;
        for (int axis = 0; axis < 3; ++axis) weight *= step[axis] == 1 ? share[axis] : 1.0F - share[axis];
        const float before = (positionOf(cell) - point).dot(normal);
        weight *= std::clamp(before / 0.1F, 0.002F, 1.0F);
        const Cube& cube = cubeAt(cell);
        sum += weight *
               (onFaces.x() * cube[faces[0]] + onFaces.y() * cube[faces[1]] + onFaces.z() * cube[faces[2]]);
        weights += weight;
    }
    return sum / weights;
}

Eigen::Vector3f LightField::outside(const Eigen::Vector3f& direction) const {
    const float up = direction.z();
    const Eigen::Vector3f wall(0.50F, 0.50F, 0.47F), roof(0.62F, 0.65F, 0.68F), ground(0.18F, 0.18F, 0.17F);
    const float height = std::clamp(up / 0.5F, 0.0F, 1.0F);
    const Eigen::Vector3f colour = up < -0.02F ? ground : Eigen::Vector3f(wall + height * (roof - wall));
    return (0.05F + 0.6F * m_hall) * colour;
}

}  // namespace leitstand::simulation
