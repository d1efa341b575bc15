#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <numbers>
#include <vector>

#include <gtest/gtest.h>

#include "core/cloud/labels.h"
#include "core/mapping/motion/turn_assembler.h"
#include "core/perception/pictures/coding/picture_decoding.h"
#include "robots/simulation/arena/arena_generator.h"
#include "robots/simulation/arena/reachable_floor.h"
#include "robots/simulation/sensors/camera/infrared_camera.h"
#include "robots/simulation/sensors/laser/plane_laser.h"
#include "robots/simulation/sensors/laser/turning_scanner.h"
#include "tests/simulation/sensors/room.h"

namespace leitstand::simulation::test {
namespace {

using namespace std::chrono_literals;

/// Errors of ranges, each in deviations that the sensor has at this range.
struct RangeErrors {
    std::vector<double> inDeviations;

    /// Distance of Kolmogorov and Smirnov to the normal distribution.
    [[nodiscard]] double distanceToNormal() {
        std::sort(inDeviations.begin(), inDeviations.end());
        const double count = double(inDeviations.size());
        double worst = 0.0;
        for (std::size_t i = 0; i < inDeviations.size(); ++i) {
            const double normal = 0.5 * std::erfc(-inDeviations[i] / std::numbers::sqrt2);
            worst = std::max({worst, normal - double(i) / count, double(i + 1) / count - normal});
        }
        return worst;
    }
    [[nodiscard]] double mean() const {
        double sum = 0.0;
        for (const double error : inDeviations) sum += error;
        return sum / double(inDeviations.size());
    }
    [[nodiscard]] double deviation() const {
        double squares = 0.0;
        for (const double error : inDeviations) squares += error * error;
        return std::sqrt(squares / double(inDeviations.size()));
    }
};

/// Whether rays around @p ray meet the same plane: no beam is cut by an edge there.
bool isAmidAPlane(const Scene& scene, const Ray& ray, const Hit& hit) {
    const Eigen::Vector3f side = ray.direction.unitOrthogonal();
    for (const Eigen::Vector3f& off : {side, Eigen::Vector3f(ray.direction.cross(side))}) {
        for (const float sign : {1.0F, -1.0F}) {
            Ray beside = ray;
            beside.direction = (ray.direction + 0.02F * sign * off).normalized();
            const Hit other = scene.cast(beside, RayKind::Laser);
            if (!other.there() || other.normal.dot(hit.normal) < 0.999F) return false;
            const Eigen::Vector3f between =
                beside.origin + other.distance * beside.direction - ray.origin - hit.distance * ray.direction;
            if (std::abs(between.dot(hit.normal)) > 0.01F) return false;
        }
    }
    return true;
}

/// Ranges and labels of a turn of the scanner that stands at @p start of the arena of @p grade.
struct TrueTurn {
    RangeErrors errors;
    int labelled = 0, right = 0;  ///< points of structures; what the station's labels say of them
    int points = 0, lost = 0;     ///< shots that should have had an echo and had none
};

TrueTurn trueTurn(Grade grade, std::uint64_t seed) {
    TrueTurn result;
    World world(generateArena(grade, seed), seed);
    const Pose start = world.arena().starts.at("kurt3d");
    const int robot = addBareRobot(world, start.translation().x(), start.translation().y(),
                                   std::atan2(start.linear()(1, 0), start.linear()(0, 0)));
    TurningScannerSettings settings = scanDrive();
    settings.sensor = "scanner";
    settings.frame = "laser";
    settings.mountInBase.translation().z() = 0.48;
    TurningScanner scanner(settings, Noise(seed, "scanner"), world.now());
    TurnAssembler assembler;
    std::optional<Scan> scan;
    std::vector<HardwareSample> samples;
    while (!scan && world.seconds() < 3.0) {
        world.advance(20ms);
        samples.clear();
        scanner.run(world, robot, samples);
        for (const HardwareSample& sample : samples) {
            auto turn = assembler.add(sample.sample.get<CloudSample>(), std::nullopt);
            if (turn) scan = std::move(turn);
        }
    }
    if (!scan) return result;
    const std::vector<Label> labels = labelScan(*scan);
    const Pose mount = world.state(robot).baseInArena * settings.mountInBase;
    for (std::size_t i = 0; i < scan->points.size(); ++i) {
        const auto row = static_cast<std::int64_t>(i / 161);
        const int column = static_cast<int>(i % 161);
        Ray ray;
        ray.origin = mount.translation().cast<float>();
        ray.direction = (mount.linear() * settings.pattern.direction(row, column)).cast<float>();
        ray.near = static_cast<float>(settings.laser.nearest);
        const Hit hit = world.scene().cast(ray, RayKind::Laser);
        if (!hit.there() || hit.surface->element < 0) continue;
        const auto& element = world.arena().elements[std::size_t(hit.surface->element)];
        if (element.kind == ElementKind::Spectator || element.kind == ElementKind::Victim) continue;  // move
        ++result.points;
        const bool reflects = propertiesOf(hit.surface->material).reflectivity > 0.3F;
        if (!scan->points[i].allFinite()) {
            result.lost += reflects && hit.distance < 3.0F ? 1 : 0;
            continue;
        }
        if (!isAmidAPlane(world.scene(), ray, hit)) continue;
        const double range = double{hit.distance};
        result.errors.inDeviations.push_back((double{scan->points[i].norm()} - range) /
                                             (0.01 + 0.002 * range));
        if (hit.surface->label == Label::Unlabelled || labels[i] == Label::Unlabelled) continue;
        ++result.labelled;
        result.right += labels[i] == hit.surface->label ? 1 : 0;
    }
    return result;
}

TEST(Truth, RangesErrByANormalDistributionAndLabelsAreThoseOfTheArena) {
    for (const Grade grade : {Grade::Yellow, Grade::Orange, Grade::Red}) {
        TrueTurn turn = trueTurn(grade, 7);
        const double count = double(turn.errors.inDeviations.size());
        ASSERT_GT(count, 5'000) << toString(grade);
        const double normal = turn.errors.distanceToNormal();
        std::printf(
            "%s: %.0f ranges, errors of mean %.3f and deviation %.3f of what is stated, %.4f off normal; "
            "%.1f %% of %d labels right\n",
            toString(grade).c_str(), count, turn.errors.mean(), turn.errors.deviation(), normal,
            100.0 * turn.right / turn.labelled, turn.labelled);
        EXPECT_NEAR(turn.errors.mean(), 0.0, 5.0 / std::sqrt(count));
        EXPECT_NEAR(turn.errors.deviation(), 1.0, 0.04);
        EXPECT_LT(normal, 2.2 / std::sqrt(count)) << "one in ten thousand turns";
        EXPECT_LT(turn.lost, turn.points / 200);
        EXPECT_GT(turn.right, turn.labelled * 98 / 100) << toString(grade);
    }
}

TEST(Truth, TheUrgErrsAsItsDataSheetSays) {
    World world(generateArena(Grade::Yellow, 7), 7);
    const Pose start = world.arena().starts.at("crawler");
    const int robot = addBareRobot(world, start.translation().x(), start.translation().y(),
                                   std::atan2(start.linear()(1, 0), start.linear()(0, 0)));
    PlaneLaserSettings settings = hokuyoUrg();
    settings.laserInBase.translation() << 0.14, 0.0, 0.20;
    PlaneLaser laser(settings, Noise(7, "laser"), world.now());
    std::vector<HardwareSample> samples;
    for (int i = 0; i < 200; ++i) {
        world.advance(20ms);
        laser.run(world, robot, samples);
    }
    RangeErrors errors;
    const Pose place = world.state(robot).baseInArena * settings.laserInBase;
    for (const HardwareSample& sample : samples) {
        const auto& scan = sample.sample.get<RangesSample>();
        for (std::size_t i = 0; i < scan.ranges.size(); ++i) {
            const double angle = scan.angleMin + scan.angleStep * double(i);
            Ray ray;
            ray.origin = place.translation().cast<float>();
            ray.direction =
                (place.linear() * Eigen::Vector3d(std::cos(angle), std::sin(angle), 0.0)).cast<float>();
            const Hit hit = world.scene().cast(ray, RayKind::Laser);
            if (!hit.there() || !std::isfinite(scan.ranges[i]) || !isAmidAPlane(world.scene(), ray, hit))
                continue;
            const double range = double{hit.distance};
            EXPECT_LT(range, 4.0);
            errors.inDeviations.push_back((double{scan.ranges[i]} - range) / (0.005 + 0.01 * range));
        }
    }
    const double count = double(errors.inDeviations.size());
    ASSERT_GT(count, 5'000);
    EXPECT_NEAR(errors.mean(), 0.0, 5.0 / std::sqrt(count));
    EXPECT_NEAR(errors.deviation(), 1.0, 0.04);
    EXPECT_LT(errors.distanceToNormal(), 2.2 / std::sqrt(count));
}

/// In front of every victim that can be got at: each pixel against what it truly sees.
TEST(Truth, InfraredPixelsTellTheTemperatureOfWhatTheySee) {
    int victims = 0;
    for (const Grade grade : {Grade::Yellow, Grade::Red}) {
        const Arena arena = generateArena(grade, 7);
        World world(arena, 7);
        for (const Element& victim : arena.elements) {
            if (!victim.victim || victim.victim->situation != Situation::Surface) continue;
            const Eigen::Vector2d place = placeBefore(victim, 0.9);
            const Eigen::Vector2d towards = victim.pose.translation().head<2>() - place;
            const int robot = addBareRobot(world, place.x(), place.y(), std::atan2(towards.y(), towards.x()));
            const Pose camera = world.state(robot).baseInArena * poseFrom({0.2, 0, 0.36}, 0, degrees(15), 0) *
                                opticalAt(0, 0, 0);
            InfraredSettings settings;
            settings.model = infraredOptics();
            settings.cameraInBase = [](Time) {
                return poseFrom({0.2, 0, 0.36}, 0, degrees(15), 0) * opticalAt(0, 0, 0);
            };
            InfraredCamera infrared(settings, Noise(7, "ir"), world.now());
            std::vector<HardwareSample> samples;
            infrared.run(world, robot, samples);
            const auto decoded = decodePicture(samples.at(0).sample.get<PictureSample>());
            ASSERT_TRUE(decoded);
            const auto picture = temperatures(*decoded, {});
            ASSERT_TRUE(picture);
            double squares = 0.0, sum = 0.0, warmest = 0.0;
            int skin = 0;
            for (int y = 0; y < 120; ++y) {
                for (int x = 0; x < 160; ++x) {
                    Ray ray;
                    ray.origin = camera.translation().cast<float>();
                    ray.direction = (camera.linear() * *settings.model.direction({x, y})).cast<float>();
                    const Hit hit = world.scene().cast(ray, RayKind::Infrared, robot);
                    Hit behind;
                    if (hit.there() && hit.surface->material == Material::Foil) {
                        Ray on = ray;
                        on.near = hit.distance + 0.002F;
                        behind = world.scene().cast(on, RayKind::Infrared, robot);
                    }
                    const double ambient = arena.ambient + 273.15;
                    const double shown =
                        apparentTemperature(hit, behind.there() ? &behind : nullptr, ambient) - 273.15;
                    const double read = double{picture->celsius[std::size_t(160 * y + x)]};
                    sum += (read - shown) / 19'200;
                    squares += (read - shown) * (read - shown) / 19'200;
                    if (hit.there() && hit.surface->material == Material::Skin) {
                        ++skin;
                        warmest = std::max(warmest, read);
                    }
                }
            }
            EXPECT_NEAR(sum, 0.0, 0.02) << arena.name << " " << victim.name;
            EXPECT_LT(std::sqrt(squares), 0.15) << arena.name << " " << victim.name << ": but for edges";
            if (skin < 60) continue;
            ++victims;
            EXPECT_NEAR(warmest, victim.victim->temperature, 0.6) << arena.name << " " << victim.name;
        }
    }
    EXPECT_GE(victims, 3);
}

}  // namespace
}  // namespace leitstand::simulation::test
