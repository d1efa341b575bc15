#include "robots/simulation/scene/scene.h"

#include <array>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <limits>
#include <random>
#include <stdexcept>
#include <thread>
#include <vector>

#include <gtest/gtest.h>

#include "robots/simulation/world/shapes.h"

namespace leitstand::simulation {
namespace {

constexpr float Infinity = std::numeric_limits<float>::infinity();

Surface of(Material material, int element = -1) {
    Surface surface;
    surface.material = material;
    surface.element = element;
    return surface;
}

/// A floor of 20 m, a box of 1 m at (2, 0), a ramp of 15 degrees behind it.
ArenaMesh simpleArena() {
    ArenaMesh mesh;
    const int floor = addSurface(mesh.still, of(Material::Concrete));
    const int wood = addSurface(mesh.still, of(Material::Plywood));
    addBox(mesh.still, floor, {-10, -10, -0.1}, {10, 10, 0});
    addBox(mesh.still, wood, {2, -0.5, 0}, {3, 0.5, 1});
    addWedge(mesh.still, wood, poseFrom({-6, 0, 0}, 0, 0, 0), {2, 1, 2 * std::tan(degrees(15))});
    return mesh;
}

/// Boxes and cylinders at random places and attitudes.
ArenaMesh clutter(std::uint64_t seed, int things) {
    ArenaMesh mesh;
    std::mt19937_64 random(seed);
    std::uniform_real_distribution<double> place(-5, 5), angle(-3, 3), length(0.05, 0.8);
    const int solid = addSurface(mesh.still, of(Material::Plywood));
    const int soft = addSurface(mesh.still, of(Material::Cloth));
    for (int i = 0; i < things; ++i) {
        const int surface = i % 3 == 0 ? soft : solid;
        const Eigen::Vector3d at(place(random), place(random), place(random));
        if (i % 2 == 0) {
            addBox(mesh.still, surface, poseFrom(at, angle(random), angle(random), angle(random)),
                   Eigen::Vector3d::Zero(), {length(random), length(random), length(random)});
        } else {
            addCylinder(mesh.still, surface, at, at + Eigen::Vector3d(length(random), 0.3, length(random)),
                        0.5 * length(random), 8);
        }
    }
    return mesh;
}

/// Moeller and Trumbore 1997, in double; infinite: passes.
double distanceTo(const Mesh& mesh, std::size_t triangle, const Ray& ray) {
    const auto corner = [&](int i) -> Eigen::Vector3d {
        return mesh.corners[mesh.triangles[triangle][static_cast<std::size_t>(i)]].cast<double>();
    };
    const Eigen::Vector3d a = corner(1) - corner(0), b = corner(2) - corner(0);
    const Eigen::Vector3d direction = ray.direction.cast<double>(), p = direction.cross(b);
    const double determinant = a.dot(p);
    if (std::abs(determinant) < 1e-12) return Infinity;
    const Eigen::Vector3d t = ray.origin.cast<double>() - corner(0), q = t.cross(a);
    const double u = t.dot(p) / determinant, v = direction.dot(q) / determinant;
    const double distance = b.dot(q) / determinant;
    return u < 0 || v < 0 || u + v > 1 || distance < 0 ? Infinity : distance;
}

std::vector<Ray> randomRays(std::uint64_t seed, std::size_t count) {
    std::mt19937_64 random(seed);
    std::uniform_real_distribution<float> place(-5, 5);
    std::normal_distribution<float> normal;
    std::vector<Ray> rays(count);
    for (Ray& ray : rays) {
        ray.origin = {place(random), place(random), place(random)};
        ray.direction = Eigen::Vector3f(normal(random), normal(random), normal(random)).normalized();
    }
    return rays;
}

TEST(Scene, MeetsBoxesAndRampsWhereTheyAre) {
    const Scene scene({}, simpleArena());
    const Hit box = scene.cast({{0, 0, 0.5F}, {1, 0, 0}}, RayKind::Laser);
    ASSERT_TRUE(box.there());
    EXPECT_NEAR(box.distance, 2.0F, 1e-5F);
    EXPECT_TRUE(box.normal.isApprox(Eigen::Vector3f(-1, 0, 0), 1e-5F));
    EXPECT_EQ(box.surface->material, Material::Plywood);
    EXPECT_EQ(box.body, -1);

    const Hit floor = scene.cast({{0, 0, 0.5F}, {0, 0, -1}}, RayKind::Camera);
    EXPECT_NEAR(floor.distance, 0.5F, 1e-5F);
    EXPECT_EQ(floor.surface->material, Material::Concrete);

    const float slope = std::tan(static_cast<float>(degrees(15)));
    const Hit ramp = scene.cast({{-5, 0.1F, 3}, {0, 0, -1}}, RayKind::Contact);
    EXPECT_NEAR(ramp.distance, 3 - slope, 1e-5F);
    EXPECT_NEAR(ramp.normal.z(), std::cos(degrees(15)), 1e-5);
    EXPECT_LT(ramp.normal.x(), 0.0F);

    EXPECT_FALSE(scene.cast({{0, 0, 0.5F}, {0, 0, 1}}, RayKind::Laser).there());
    EXPECT_FALSE(scene.cast({{0, 0, 0.5F}, {1, 0, 0}, 0.0F, 1.9F}, RayKind::Laser).there());
    EXPECT_NEAR(scene.cast({{0, 0, 0.5F}, {1, 0, 0}, 2.5F}, RayKind::Laser).distance, 3.0F, 1e-5F);
}

TEST(Scene, AgreesWithBruteForceOnRandomRays) {
    const ArenaMesh mesh = clutter(/*seed=*/11, /*things=*/60);
    const Scene scene({}, mesh);
    const std::vector<Ray> rays = randomRays(/*seed=*/12, 100'000);
    std::vector<Hit> hits(rays.size());
    scene.cast(rays, hits, RayKind::Laser);
    int met = 0, differ = 0;
    for (std::size_t i = 0; i < rays.size(); ++i) {
        double nearest = Infinity;
        for (std::size_t t = 0; t < mesh.still.triangles.size(); ++t) {
            nearest = std::min(nearest, distanceTo(mesh.still, t, rays[i]));
        }
        met += std::isfinite(nearest) ? 1 : 0;
        const bool same = std::isfinite(nearest) == hits[i].there() &&
                          (!hits[i].there() || std::abs(hits[i].distance - nearest) < 1e-4);
        differ += same ? 0 : 1;
        const Hit one = scene.cast(rays[i], RayKind::Laser);
        ASSERT_EQ(one.there(), hits[i].there());
        if (one.there()) {
            ASSERT_NEAR(one.distance, hits[i].distance, 1e-4F);
            ASSERT_LE(one.normal.dot(rays[i].direction), 0.0F);
            ASSERT_NEAR(one.normal.norm(), 1.0F, 1e-5F);
        }
    }
    EXPECT_GT(met, 5'000);
    EXPECT_LE(differ, 10) << "of 100,000: rays that graze an edge in float";
}

TEST(Scene, LetsEachKindOfRayThroughWhatItPasses) {
    ArenaMesh mesh;
    Arena arena;
    arena.elements.resize(2);
    arena.elements[1].kind = ElementKind::Victim;
    const auto sheet = [&](double x, Material material, int element) {
        addBox(mesh.still, addSurface(mesh.still, of(material, element)), {x, -1, -1}, {x + 0.01, 1, 1});
    };
    sheet(1, Material::Foil, 0);
    sheet(2, Material::Paper, 0);
    sheet(3, Material::Cloth, 1);
    const Scene scene(arena, mesh);
    const Ray ray{{0, 0, 0}, {1, 0, 0}};
    for (const RayKind kind : {RayKind::Laser, RayKind::Camera, RayKind::Infrared}) {
        EXPECT_NEAR(scene.cast(ray, kind).distance, 1.0F, 1e-5F);
    }
    const Hit stop = scene.cast(ray, RayKind::Contact);
    ASSERT_TRUE(stop.there()) << "a victim stops robots, by its clothes too";
    EXPECT_NEAR(stop.distance, 3.0F, 1e-5F);
    EXPECT_EQ(stop.surface->element, 1);
}

TEST(Scene, MovesBodiesAndLeavesThemOut) {
    Scene scene({}, simpleArena());
    Mesh cube;
    addBox(cube, addSurface(cube, of(Material::Metal)), {-0.1, -0.1, 0}, {0.1, 0.1, 0.4});
    const int a = scene.addBody(cube), b = scene.addBody(cube);
    scene.commit();
    const Ray ray{{0, 0, 0.2F}, {1, 0, 0}};
    EXPECT_NEAR(scene.cast(ray, RayKind::Laser).distance, 2.0F, 1e-5F) << "not placed yet";

    scene.place(a, poseFrom({1, 0, 0}, 0, 0, 0));
    scene.place(b, poseFrom({1.5, 0, 0}, 0, 0, degrees(45)));
    scene.commit();
    const Hit first = scene.cast(ray, RayKind::Laser);
    EXPECT_NEAR(first.distance, 0.9F, 1e-5F);
    EXPECT_EQ(first.body, a);
    const Hit second = scene.cast(ray, RayKind::Contact, a);
    EXPECT_NEAR(second.distance, 1.5 - 0.1 * std::sqrt(2.0), 1e-5);
    EXPECT_EQ(second.body, b);
    EXPECT_NEAR(scene.cast(ray, RayKind::Laser, Scene::StillOnly).distance, 2.0F, 1e-5F);

    scene.place(a, poseFrom({0.5, 0, 0}, 0, 0, degrees(90)));
    scene.hide(b);
    scene.commit();
    const Hit moved = scene.cast({{0, 0.05F, 0.2F}, {1, 0, 0}}, RayKind::Laser);
    EXPECT_NEAR(moved.distance, 0.4F, 1e-5F);
    EXPECT_TRUE(moved.normal.isApprox(Eigen::Vector3f(-1, 0, 0), 1e-5F)) << "turned with its body";
    EXPECT_NEAR(scene.cast(ray, RayKind::Laser, a).distance, 2.0F, 1e-5F);
    EXPECT_THROW(for (int i = 0; i < Scene::MaxBodies; ++i)(void) scene.addBody(cube), std::length_error);
}

TEST(Scene, SwingsWhatMovesByItself) {
    ArenaMesh mesh = simpleArena();
    MovingPart arm;
    addBox(arm.mesh, addSurface(arm.mesh, of(Material::Skin)), {-0.05, -0.05, 0}, {0.05, 0.05, 0.6});
    arm.hinge = poseFrom({0, 3, 0.5}, 0, 0, 0);
    arm.swing = degrees(90);
    arm.period = 2.0;
    mesh.moving.push_back(arm);
    Scene scene({}, mesh);
    const Ray across{{-2, 3, 1.0F}, {1, 0, 0}};
    EXPECT_NEAR(scene.cast(across, RayKind::Laser).distance, 1.95F, 1e-5F);
    scene.setTime(0.5);  // a quarter of its period: lies flat
    scene.commit();
    EXPECT_FALSE(scene.cast(across, RayKind::Laser).there());
    EXPECT_TRUE(scene.cast({{-2, 2.6F, 0.5F}, {1, 0, 0}}, RayKind::Laser).there());
}

TEST(Scene, GivesThePlaceOnTheTexture) {
    ArenaMesh mesh;
    Surface sign = of(Material::Paper);
    sign.texture = 0;
    mesh.still.textures.push_back({1, 1, {255, 0, 0}});
    mesh.still.surfaces = {sign};
    mesh.still.corners = {{0, 0, 0}, {2, 0, 0}, {2, 0, 1}, {0, 0, 1}};
    mesh.still.uv = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
    mesh.still.triangles = {{0, 1, 2}, {0, 2, 3}};
    mesh.still.surfaceOf = {0, 0};
    const Scene scene({}, mesh);
    for (const float x : {0.2F, 0.9F, 1.7F}) {
        for (const float z : {0.1F, 0.5F, 0.8F}) {
            const Hit hit = scene.cast({{x, -1, z}, {0, 1, 0}}, RayKind::Camera);
            ASSERT_TRUE(hit.there());
            EXPECT_NEAR(hit.uv.x(), x / 2, 1e-5F);
            EXPECT_NEAR(hit.uv.y(), z, 1e-5F);
            EXPECT_EQ(hit.texture->pixels[0], 255);
        }
    }
}

TEST(Scene, EndsNowhereForRaysThatAreNone) {
    const Scene scene({}, simpleArena());
    const float nan = std::numeric_limits<float>::quiet_NaN();
    const std::array<Ray, 4> rays = {Ray{{nan, 0, 0}, {1, 0, 0}}, Ray{{0, 0, 0.5F}, {nan, 0, 0}},
                                     Ray{{0, 0, 0.5F}, {0, 0, 0}}, Ray{{0, 0, 0.5F}, {1, 0, 0}, 3.0F, 2.0F}};
    std::array<Hit, 4> hits;
    scene.cast(rays, hits, RayKind::Laser);
    for (std::size_t i = 0; i < rays.size(); ++i) {
        EXPECT_FALSE(hits[i].there());
        EXPECT_FALSE(scene.cast(rays[i], RayKind::Laser).there());
    }
    scene.cast(std::span(rays).first(0), hits, RayKind::Laser);
}

TEST(Scene, RefusesMeshesThatNameWhatTheyHaveNot) {
    ArenaMesh mesh = simpleArena();
    mesh.still.triangles[3][1] = 10'000;
    EXPECT_THROW(Scene({}, mesh), std::invalid_argument);
    mesh = simpleArena();
    mesh.still.surfaceOf[2] = 7;
    EXPECT_THROW(Scene({}, mesh), std::invalid_argument);
    mesh = simpleArena();
    mesh.still.surfaces[0].texture = 0;
    EXPECT_THROW(Scene({}, mesh), std::invalid_argument);
}

TEST(Scene, IsCastBySeveralThreadsAtOnce) {
    const Scene scene({}, clutter(/*seed=*/21, /*things=*/200));
    const std::vector<Ray> rays = randomRays(/*seed=*/22, 20'000);
    std::vector<Hit> expected(rays.size());
    scene.cast(rays, expected, RayKind::Laser);
    std::array<int, 4> differ = {};
    {
        std::vector<std::jthread> threads;
        for (int& count : differ) {
            threads.emplace_back([&] {
                std::vector<Hit> hits(rays.size());
                scene.cast(rays, hits, RayKind::Laser);
                for (std::size_t i = 0; i < hits.size(); ++i)
                    count += hits[i].distance != expected[i].distance;
            });
        }
    }
    EXPECT_EQ(differ, (std::array<int, 4>{}));
}

/// Printed, with bounds that hold on a slow and busy machine.
TEST(SceneLatency, CastsMillionsOfRaysASecond) {
    Scene scene({}, clutter(/*seed=*/31, /*things=*/1'000));
    Mesh cube;
    addBox(cube, addSurface(cube, of(Material::Metal)), {-0.1, -0.1, 0}, {0.1, 0.1, 0.4});
    std::vector<int> bodies;
    for (int i = 0; i < 8; ++i) bodies.push_back(scene.addBody(cube));
    std::vector<Ray> coherent;
    for (int row = 0; row < 400; ++row) {
        for (int column = 0; column < 400; ++column) {
            const Eigen::Vector3f direction(1.0F, 0.005F * static_cast<float>(column - 200),
                                            0.005F * static_cast<float>(row - 200));
            coherent.push_back({{-6, 0, 0}, direction.normalized()});
        }
    }
    const auto secondsOf = [](const auto& work) {
        const auto start = std::chrono::steady_clock::now();
        work();
        return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    };
    const std::vector<Ray> random = randomRays(/*seed=*/32, coherent.size());
    std::vector<Hit> hits(coherent.size());
    const double many = secondsOf([&] { scene.cast(coherent, hits, RayKind::Camera); });
    const double scattered = secondsOf([&] { scene.cast(random, hits, RayKind::Camera); });
    const double single = secondsOf([&] {
        for (std::size_t i = 0; i < random.size(); ++i) hits[i] = scene.cast(random[i], RayKind::Camera);
    });
    const double commits = secondsOf([&] {
        for (int i = 0; i < 1'000; ++i) {
            for (const int body : bodies) scene.place(body, poseFrom({0.001 * i, body * 0.5, 0}, 0, 0, 0));
            scene.commit();
        }
    });
    const double count = static_cast<double>(coherent.size());
    std::printf(
        "millions of rays a second: coherent %.2f, scattered %.2f, one by one %.2f; commit of 8 bodies %.1f "
        "us\n",
        count / many / 1e6, count / scattered / 1e6, count / single / 1e6, commits * 1e3);
    EXPECT_GT(count / many, 0.3e6);
    EXPECT_GT(count / single, 0.1e6);
    EXPECT_LT(commits / 1'000, 0.001);
}

TEST(Scene, SmokeSwallowsWhatLasersSeeThroughTooMuchOfIt) {
    Arena arena;
    Element smoke = elementOf(ElementKind::Smoke);
    smoke.size = {4.0, 2.0, 2.0};
    smoke.reach = 1.5;
    smoke.pose = poseFrom({2.0, 0.0, 0.0}, 0.0, 0.0, degrees(90));  // 1 to 3 along x, -2 to 2 along y
    arena.elements = {smoke};
    ArenaMesh mesh;
    const int wall = addSurface(mesh.still, of(Material::Plaster));
    addBox(mesh.still, wall, {2.0, -5.0, 0.0}, {2.1, 5.0, 3.0});
    addBox(mesh.still, wall, {5.0, -5.0, 0.0}, {5.1, 5.0, 3.0});
    const Scene scene(arena, mesh);
    const auto seen = [&](const Eigen::Vector3f& from, const Eigen::Vector3f& along, RayKind kind) {
        const Ray ray{from, along.normalized()};
        const Hit one = scene.cast(ray, kind);
        std::array<Ray, 3> rays = {ray, ray, ray};
        std::array<Hit, 3> hits;
        scene.cast(rays, hits, kind);
        for (const Hit& hit : hits) EXPECT_EQ(hit.there(), one.there());
        return one.there() ? one.distance : Infinity;
    };
    const Eigen::Vector3f x = Eigen::Vector3f::UnitX();
    EXPECT_NEAR(seen({0.0F, 0.0F, 1.0F}, x, RayKind::Laser), 2.0F, 1e-4F) << "1 m of smoke";
    EXPECT_NEAR(seen({0.0F, 3.0F, 1.0F}, x, RayKind::Laser), 2.0F, 1e-4F) << "beside it";
    EXPECT_EQ(seen({0.0F, -2.0F, 1.0F}, Eigen::Vector3f(1.0F, 1.2F, 0.0F), RayKind::Laser), Infinity);
    EXPECT_NEAR(seen({0.0F, -2.0F, 1.0F}, Eigen::Vector3f(1.0F, 1.2F, 0.0F), RayKind::Camera),
                2.0F * std::hypot(1.0F, 1.2F), 1e-4F);
    EXPECT_NEAR(seen({2.5F, 0.0F, 1.0F}, x, RayKind::Laser), 2.5F, 1e-4F) << "from within, 0.5 m of it";
    EXPECT_EQ(seen({4.0F, 0.0F, 1.0F}, Eigen::Vector3f::UnitZ(), RayKind::Laser), Infinity);
}

}  // namespace
}  // namespace leitstand::simulation
