#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "robots/simulation/sensors/laser/laser_head.h"

namespace leitstand::simulation {
namespace {

/// A wall across x at a distance that depends on the ray.
CastRays wall(const Surface& surface, const std::function<float(const Ray&)>& distance) {
    return [&surface, distance](std::span<const Ray> rays, std::span<Hit> hits) {
        for (std::size_t i = 0; i < rays.size(); ++i) {
            hits[i] = {};
            const float range = distance(rays[i]);
            if (!std::isfinite(range) || range > rays[i].far || range < rays[i].near) continue;
            hits[i].distance = range;
            hits[i].normal = -Eigen::Vector3f::UnitX();
            hits[i].surface = &surface;
        }
    };
}

std::vector<Ray> fan(int count, double step) {
    std::vector<Ray> rays(static_cast<std::size_t>(count));
    for (int i = 0; i < count; ++i) {
        const double angle = (i - count / 2) * step;
        rays[static_cast<std::size_t>(i)].direction =
            Eigen::Vector3d(std::cos(angle), std::sin(angle), 0.0).cast<float>();
    }
    return rays;
}

Surface of(Material material) {
    Surface surface;
    surface.material = material;
    return surface;
}

TEST(LaserHead, ErrsAsItsSettingsSay) {
    const Surface plaster = of(Material::Plaster);
    for (const float range : {0.5F, 2.0F, 10.0F, 25.0F}) {
        LaserHead head({}, Noise(3, "head"));
        auto rays = fan(50'000, 0.0);
        double sum = 0, squares = 0;
        const auto echoes = head.measure(rays, wall(plaster, [&](const Ray&) { return range; }));
        for (const LaserEcho& echo : echoes) {
            ASSERT_TRUE(std::isfinite(echo.range));
            EXPECT_FALSE(echo.mixed);
            const double error = double{echo.range} - double{range};
            sum += error;
            squares += error * error;
        }
        const double count = double(echoes.size()), deviation = 0.01 + 0.002 * double{range};
        EXPECT_NEAR(sum / count, 0.0, 5 * deviation / std::sqrt(count));
        EXPECT_NEAR(std::sqrt(squares / count), deviation, 0.02 * deviation) << range;
    }
}

TEST(LaserHead, HasNoEchoFarAwayOnBlackAndOnWhatIsTooWeak) {
    const Surface plaster = of(Material::Plaster), black = of(Material::Black), rubber = of(Material::Rubber);
    LaserHead head({}, Noise(3, "head"));
    auto rays = fan(200, 0.0);
    const auto echoes = [&](const Surface& surface, float range) {
        const auto found = head.measure(rays, wall(surface, [&](const Ray&) { return range; }));
        return std::count_if(found.begin(), found.end(),
                             [](const LaserEcho& echo) { return std::isfinite(echo.range); });
    };
    EXPECT_EQ(echoes(plaster, 29.5F), 200);
    EXPECT_EQ(echoes(plaster, 30.5F), 0);
    EXPECT_EQ(echoes(black, 1.0F), 0);
    EXPECT_EQ(echoes(rubber, 10.0F), 200);
    EXPECT_EQ(echoes(rubber, 20.0F), 0);
    EXPECT_EQ(echoes(plaster, 0.01F), 0) << "nearer than it can";
}

TEST(LaserHead, MixesPixelsOnlyAtEdges) {
    const Surface plaster = of(Material::Plaster);
    LaserHead head({}, Noise(5, "head"));
    // A post at 2 m before a wall at 2.6 m; its edges lie within the beams of some shots.
    const auto post = [](const Ray& ray) {
        return std::abs(std::atan2(ray.direction.y(), ray.direction.x())) < 0.0385F ? 2.0F : 2.6F;
    };
    int mixed = 0, between = 0;
    for (int turn = 0; turn < 200; ++turn) {
        auto rays = fan(41, degrees(0.5));
        const auto echoes = head.measure(rays, wall(plaster, post));
        for (std::size_t i = 0; i < echoes.size(); ++i) {
            const double angle = std::abs((double(i) - 20.0) * degrees(0.5));
            if (std::abs(angle - 0.0385) > 0.0044) {
                EXPECT_FALSE(echoes[i].mixed) << angle;
                EXPECT_NEAR(echoes[i].range, angle < 0.0385 ? 2.0 : 2.6, 0.08) << angle;
                continue;
            }
            mixed += echoes[i].mixed ? 1 : 0;
            between += echoes[i].range > 2.1F && echoes[i].range < 2.5F ? 1 : 0;
        }
    }
    EXPECT_GT(mixed, 300) << "both edges of 200 turns";
    EXPECT_GT(between, 200);
}

TEST(LaserHead, TakesTheOneOrTheOtherWhereSurfacesAreFarApart) {
    const Surface plaster = of(Material::Plaster);
    LaserHead head({}, Noise(5, "head"));
    const auto edge = [](const Ray& ray) { return ray.direction.y() > 0.002F ? 3.0F : 8.0F; };
    for (int turn = 0; turn < 100; ++turn) {
        auto rays = fan(21, degrees(1));
        for (const LaserEcho& echo : head.measure(rays, wall(plaster, edge))) {
            EXPECT_TRUE(std::abs(echo.range - 3.0F) < 0.09F || std::abs(echo.range - 8.0F) < 0.15F)
                << echo.range;
        }
    }
}

TEST(LaserHead, TellsReflectivityAndIncidence) {
    const Surface plaster = of(Material::Plaster), wood = of(Material::Plywood);
    LaserHead head({}, Noise(5, "head"));
    const auto mean = [&](const Surface& surface, double angle) {
        std::vector<Ray> rays(2000);
        for (Ray& ray : rays) {
            ray.direction = Eigen::Vector3d(std::cos(angle), std::sin(angle), 0.0).cast<float>();
        }
        double sum = 0;
        for (const LaserEcho& echo : head.measure(rays, wall(surface, [](const Ray&) { return 2.0F; }))) {
            sum += double{echo.intensity};
        }
        return sum / double(rays.size());
    };
    EXPECT_NEAR(mean(plaster, 0.0), 255 * 0.75, 1.0);
    EXPECT_NEAR(mean(wood, 0.0), 255 * 0.60, 1.0);
    EXPECT_NEAR(mean(plaster, degrees(60)), 255 * 0.375, 1.0);
}

}  // namespace
}  // namespace leitstand::simulation
