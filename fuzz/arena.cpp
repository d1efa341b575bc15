#include <algorithm>
#include <chrono>
#include <cmath>
#include <string>
#include <vector>

#include "fuzz/input_file.h"
#include "robots/simulation/arena/arena_file.h"
#include "robots/simulation/arena/reachable_floor.h"
#include "robots/simulation/world/world.h"

namespace {

using namespace leitstand;
using namespace leitstand::simulation;

constexpr std::size_t FewElements = 30;
constexpr double SmallGround = 12.0;  ///< [m]

/// What the rest of the simulation relies on.
void check(const Arena& arena) {
    fuzz::require((arena.to - arena.from).minCoeff() > 0.0, "a ground");
    fuzz::require(arena.starts.size() <= 20 && arena.elements.size() <= 2'000, "not too much");
    for (const auto& [robot, start] : arena.starts) {
        fuzz::require(start.matrix().allFinite(), "starts that are places");
    }
    for (const Element& element : arena.elements) {
        fuzz::require(!element.name.empty(), "names");
        fuzz::require(element.pose.matrix().allFinite(), "elements that are somewhere");
        fuzz::require(element.size.minCoeff() > 0.0 && element.size.maxCoeff() <= 100.0, "sizes");
        fuzz::require(std::isfinite(element.temperature), "temperatures");
        fuzz::require(element.kind == ElementKind::Victim || !element.victim, "victims that are victims");
    }
}

bool isSame(const Arena& a, const Arena& b) {
    if (a.name != b.name || a.seed != b.seed || a.from != b.from || a.to != b.to) return false;
    if (a.starts.size() != b.starts.size()) return false;
    return std::equal(a.elements.begin(), a.elements.end(), b.elements.begin(), b.elements.end(),
                      [](const Element& one, const Element& other) {
                          return one.kind == other.kind && one.name == other.name && one.size == other.size &&
                                 one.text == other.text && one.heights == other.heights &&
                                 one.seed == other.seed &&
                                 (one.pose.matrix() - other.pose.matrix()).cwiseAbs().maxCoeff() < 1e-9;
                      });
}

/// Triangles that hold together.
void check(const Mesh& mesh) {
    fuzz::require(mesh.uv.size() == mesh.corners.size(), "a uv for each corner");
    fuzz::require(mesh.surfaceOf.size() == mesh.triangles.size(), "a surface for each triangle");
    fuzz::require(mesh.triangles.size() < 3'000'000, "no more triangles than fit");
    for (const auto& corner : mesh.corners) fuzz::require(corner.allFinite(), "corners that are somewhere");
    for (const auto& triangle : mesh.triangles) {
        for (const auto corner : triangle) fuzz::require(corner < mesh.corners.size(), "corners that exist");
    }
    for (const auto surface : mesh.surfaceOf)
        fuzz::require(surface < mesh.surfaces.size(), "surfaces that exist");
}

/// Robots that live in it for a moment.
void live(const Arena& arena, ArenaMesh mesh) {
    World world(arena, std::move(mesh), /*seed=*/1);
    int count = 0;
    for (const auto& [name, start] : arena.starts) {
        if (++count > 3) break;
        const int robot = world.addRobot(count % 2 == 0 ? crawlerBody() : kurt3dBody(), start);
        world.setMotors(robot, 0.6, 0.4);
    }
    world.advance(std::chrono::milliseconds(50));
    for (int robot = 0; robot < world.robotCount(); ++robot) {
        fuzz::require(world.state(robot).baseInArena.matrix().allFinite(), "robots that stay somewhere");
    }
    const Eigen::Vector2d middle = (arena.from + arena.to) / 2.0;
    for (int i = 0; i < 36; ++i) {
        const double angle = 0.1745 * i;
        Ray ray;
        ray.origin = Eigen::Vector3d(middle.x(), middle.y(), 0.5).cast<float>();
        ray.direction = Eigen::Vector3d(std::cos(angle), std::sin(angle), -0.1).normalized().cast<float>();
        for (const RayKind kind : {RayKind::Laser, RayKind::Camera, RayKind::Infrared, RayKind::Contact}) {
            const Hit hit = world.scene().cast(ray, kind);
            fuzz::require(!hit.there() || hit.distance >= 0.0F, "hits ahead");
        }
    }
}

}  // namespace

/// An arena's file. What was read can be written and read again, built and lived in.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const auto arena = parseArena({reinterpret_cast<const char*>(data), size}, "arena.yaml");
    if (!arena) {
        fuzz::require(arena.error().text.starts_with("arena.yaml:"), "an error that names its file");
        fuzz::require(arena.error().text.size() < 100'000, "errors that can be read");
        return 0;
    }
    check(*arena);
    const std::string written = writeArena(*arena);
    const auto again = parseArena(written, "again");
    fuzz::require(again.ok(), "a file that can be read again");
    fuzz::require(isSame(*arena, *again), "the same arena");
    if (arena->elements.size() > FewElements) return 0;
    ArenaMesh mesh = meshOf(*arena);
    check(mesh.still);
    for (const MovingPart& part : mesh.moving) {
        check(part.mesh);
        fuzz::require(part.at(1.3).matrix().allFinite(), "parts that move somewhere");
    }
    live(*arena, std::move(mesh));
    if ((arena->to - arena->from).maxCoeff() > SmallGround) return 0;
    const ReachableFloor floor = reachableFloor(*arena, 0.25);
    fuzz::require(std::isfinite(floor.area()), "a floor of some size");
    return 0;
}
