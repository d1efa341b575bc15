#include <cmath>
#include <numbers>
#include <vector>

#include "robots/simulation/arena/mesh/element_meshes.h"
#include "robots/simulation/arena/random.h"

namespace leitstand::simulation {

void addCurtain(MeshBuilder& builder, const Element& element) {
    const Eigen::Vector3d& size = element.size;
    Random random(element.seed);
    const double shift = random.between(0.0, 2.0 * std::numbers::pi);
    const int folds = std::max(2, static_cast<int>(std::lround(size.x() / 0.16)));
    builder.sheet(8 * folds, 3, [&](double u, double v) -> Eigen::Vector3d {
        // The folds open towards the hem.
        const double deep = size.y() / 2 * (1.0 - 0.4 * v);
        return {(u - 0.5) * size.x(), deep * std::sin(2.0 * std::numbers::pi * folds * u + shift),
                v * size.z()};
    });
}

void addFoil(MeshBuilder& builder, const Element& element) {
    const Eigen::Vector3d& size = element.size;
    Random random(element.seed);
    const double a = random.between(0.0, 6.28);
    const double b = random.between(0.0, 6.28);
    builder.sheet(16, 8, [&](double u, double v) -> Eigen::Vector3d {
        const double wave = 0.5 * std::sin(9.0 * u + 4.0 * v + a) + 0.5 * std::sin(5.0 * v - 7.0 * u + b);
        return {(u - 0.5) * size.x(), size.y() / 2 * wave, v * size.z()};
    });
}

void addLoosePaper(MeshBuilder& builder, const Element& element) {
    constexpr int Cells = 7;
    const Eigen::Vector3d& size = element.size;
    Random random(element.seed);
    // Two crumpled sheets, one on the other.
    for (const double part : {1.0, 0.7}) {
        std::vector<Eigen::Vector3d> points;
        for (int i = 0; i < (Cells + 1) * (Cells + 1); ++i) {
            points.emplace_back(random.between(-0.05, 0.05), random.between(-0.05, 0.05), random.uniform());
        }
        const double turn = random.between(-0.5, 0.5);
        builder.sheet(Cells, Cells, [&](double u, double v) -> Eigen::Vector3d {
            const auto place =
                static_cast<std::size_t>(std::lround(v * Cells) * (Cells + 1) + std::lround(u * Cells));
            const Eigen::Vector3d& bump = points[place];
            // Higher in the middle, never below the floor, within the element's size.
            const double rise = 4.0 * u * (1.0 - u) * 4.0 * v * (1.0 - v);
            const double z = size.z() * (0.02 + (0.25 + 0.7 * rise) * bump.z() * (1.4 - 0.4 / part) * 0.95);
            const Eigen::Vector2d flat(0.85 * part * (u - 0.5 + bump.x()) * size.x(),
                                       0.85 * part * (v - 0.5 + bump.y()) * size.y());
            const Eigen::Vector2d turned = part < 1.0 ? Eigen::Rotation2Dd(turn) * flat : flat;
            return {turned.x(), turned.y(), z};
        });
    }
}

}  // namespace leitstand::simulation
