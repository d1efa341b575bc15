#include <cmath>
#include <map>
#include <set>

#include <gtest/gtest.h>

#include "core/event/motion_samples.h"
#include "core/event/stream_role.h"
#include "core/mapping/motion/turn_assembler.h"
#include "robots/simulation/sensors/laser/tilting_scanner.h"
#include "robots/simulation/sensors/laser/turning_scanner.h"
#include "tests/simulation/sensors/room.h"

namespace leitstand::simulation::test {
namespace {

using namespace std::chrono_literals;

TurningScannerSettings mountedScanDrive() {
    TurningScannerSettings settings = scanDrive();
    settings.sensor = "laser";
    settings.frame = "kurt3d/laser";
    settings.mountInBase.translation().z() = 0.48;
    return settings;
}

/// Slices that are sent.
std::vector<CloudSample> clouds(World& world, int robot, Sensor& sensor, std::chrono::nanoseconds time,
                                std::chrono::nanoseconds step) {
    std::vector<HardwareSample> samples;
    for (const Time end = world.now() + time; world.now() < end;) {
        world.advance(step);
        sensor.run(world, robot, samples);
    }
    std::vector<CloudSample> found;
    for (HardwareSample& sample : samples) {
        if (sample.role == StreamRole::Points && sample.reach != Reach::OnBoard)
            found.push_back(sample.sample.get<CloudSample>());
    }
    return found;
}

TEST(TurningPattern, IsThatOfThePaper) {
    const TurningPattern pattern;
    EXPECT_EQ(pattern.startOf(180), 2300ms);
    EXPECT_TRUE(pattern.direction(0, 70).isApprox(Eigen::Vector3d::UnitX(), 1e-9));
    EXPECT_TRUE(pattern.direction(45, 70).isApprox(Eigen::Vector3d::UnitY(), 1e-9)) << "to the left";
    EXPECT_NEAR(pattern.direction(3, 160).z(), 1.0, 1e-9);
    EXPECT_NEAR(std::asin(pattern.direction(3, 0).z()), degrees(-70), 1e-9);
    EXPECT_TRUE(pattern.direction(0, 20).isApprox(pattern.direction(180, 20))) << "the 181st closes the turn";
    EXPECT_EQ(pattern.firstFrom(pattern.startOf(77)), 77);
}

TEST(TurningScanner, LosesAndDoublesNoRawScanInTenTurns) {
    RoomBuilder room;
    room.walls(4, 3, 2);
    for (const auto step : {5ms, 20ms, 130ms}) {
        const auto world = room.world();
        const int robot = addBareRobot(*world);
        const Time start = world->now();
        TurningScanner scanner(mountedScanDrive(), Noise(1, "scanner"), start);
        const auto slices = clouds(*world, robot, scanner, 23s + 130ms, step);
        ASSERT_GE(slices.size(), 230U);
        std::int64_t next = 0;  // of raw scans, 181 a turn
        for (std::size_t i = 0; i < 230; ++i) {
            const CloudSample& slice = slices[i];
            ASSERT_EQ(slice.columns, 161);
            EXPECT_TRUE(slice.rows >= 7 && slice.rows <= 9) << slice.rows;
            ASSERT_EQ(slice.points.size(), std::size_t(slice.rows) * 161U);
            ASSERT_EQ(slice.times.size(), slice.points.size());
            ASSERT_EQ(slice.rings.size(), slice.points.size());
            EXPECT_EQ(slice.header.frame, "kurt3d/laser");
            EXPECT_EQ((slice.header.stamp - start).count() / 100'000'000, std::int64_t(i));
            for (int row = 0; row < slice.rows; ++row, ++next) {
                const std::size_t first = std::size_t(row) * 161U;
                const std::int64_t turn = next / 181, ring = next % 181;
                EXPECT_EQ(slice.rings[first], ring);
                const auto shot = slice.header.stamp + std::chrono::nanoseconds(slice.times[first]);
                EXPECT_EQ((shot - start).count(), (180 * turn + ring) * 2'300'000'000 / 180);
                const Eigen::Vector3f& level = slice.points[first + 70];
                const double heading = std::atan2(double{level.y()}, double{level.x()});
                EXPECT_NEAR(std::remainder(heading - degrees(2.0 * double(ring)), 2 * M_PI), 0.0, 1e-5);
            }
        }
        EXPECT_EQ(next, 1810);
        // The 181st of a turn and the first of the next are one measurement.
        const CloudSample &ends = slices[22], &begins = slices[23];
        ASSERT_EQ(ends.rings.back(), 180);
        ASSERT_EQ(begins.rings.front(), 0);
        EXPECT_EQ(ends.points[ends.points.size() - 161 + 70], begins.points[70]);
    }
}

TEST(TurningScanner, GivesATurnToTheAssembler) {
    RoomBuilder room;
    room.walls(4, 3, 2);
    const auto world = room.world();
    const int robot = addBareRobot(*world);
    TurningScanner scanner(mountedScanDrive(), Noise(1, "scanner"), world->now());
    TurnAssembler assembler;
    int scans = 0;
    for (const CloudSample& slice : clouds(*world, robot, scanner, 7s, 20ms)) {
        const auto scan = assembler.add(slice, std::nullopt);
        if (!scan) continue;
        ++scans;
        EXPECT_EQ(scan->sweep, Sweep::Yawing);
        EXPECT_EQ(scan->columns, 161);
        EXPECT_EQ(scan->rows, 181);
        EXPECT_EQ(scan->points.size(), 29'141U) << "paper, section 2";
        const Eigen::Vector3f &first = scan->points[70], &last = scan->points[180 * 161 + 70];
        EXPECT_NEAR(std::atan2(first.y(), first.x()), std::atan2(last.y(), last.x()), 1e-5F);
    }
    EXPECT_EQ(scans, 3);
}

TEST(TurningScanner, SeesFlatWallsOnceTheMotionIsUndone) {
    RoomBuilder room;
    room.walls(4, 3, 2);
    const auto world = room.world();
    const int robot = addBareRobot(*world, -1.5, -0.5, 0.2);
    TurningScannerSettings settings = mountedScanDrive();
    settings.laser.deviation = settings.laser.deviationOfRange = 0.0;
    TurningScanner scanner(settings, Noise(1, "scanner"), world->now());
    world->setMotors(robot, 0.55, 0.9);
    std::vector<HardwareSample> samples;
    double worst = 0.0, worstRaw = 0.0;
    int beside = 0, all = 0;
    const Pose first = world->state(robot).baseInArena;
    for (int step = 0; step < 120; ++step) {
        world->advance(20ms);
        samples.clear();
        scanner.run(*world, robot, samples);
        for (const HardwareSample& sample : samples) {
            const auto& slice = sample.sample.get<CloudSample>();
            for (std::size_t i = 0; i < slice.points.size(); ++i) {
                const Eigen::Vector3d point = slice.points[i].cast<double>();
                const auto offWalls = [&](const Pose& base) {
                    const Eigen::Vector3d p = base * settings.mountInBase * point;
                    return std::min(
                        {std::abs(std::abs(p.x()) - 4.0), std::abs(std::abs(p.y()) - 3.0), std::abs(p.z())});
                };
                if (!point.allFinite()) continue;
                const Time shot = slice.header.stamp + std::chrono::nanoseconds(slice.times[i]);
                const double off = offWalls(world->baseInArena(robot, shot));
                worst = std::max(worst, off);
                beside += off > 0.001 ? 1 : 0;
                ++all;
                worstRaw = std::max(worstRaw, offWalls(first));
            }
        }
    }
    EXPECT_LT(worst, 0.02) << "beams cut by a corner";
    EXPECT_LT(beside, all / 500);
    EXPECT_GT(worstRaw, 0.3) << "it moved";
}

TEST(TurningScanner, LabelsAndRangesAreThoseOfTheRoom) {
    RoomBuilder room;
    room.walls(4, 3, 2);
    room.box(room.surface(Material::Black), {1.9, -0.3, 0.0}, {2.1, 0.3, 1.5});
    const auto world = room.world();
    const int robot = addBareRobot(*world);
    TurningScanner scanner(mountedScanDrive(), Noise(2, "scanner"), world->now());
    double squares = 0.0;
    int walls = 0, black = 0, up = 0;
    for (const CloudSample& slice : clouds(*world, robot, scanner, 2400ms, 20ms)) {
        for (std::size_t i = 0; i < slice.points.size(); ++i) {
            const Eigen::Vector3f& p = slice.points[i];
            const int point = static_cast<int>(i % 161);
            const double heading = std::remainder(degrees(2.0) * slice.rings[i], 2 * M_PI);
            if (point > 140) up += std::isfinite(p.x()) ? 1 : 0;
            if (point == 70 && std::abs(heading) < degrees(7)) black += std::isfinite(p.x()) ? 1 : 0;
            if (point != 70 || std::abs(std::abs(heading) - degrees(90)) > degrees(20)) continue;
            const double error = double{p.head<2>().norm()} * std::abs(std::sin(heading)) - 3.0;
            squares += error * error;
            ++walls;
        }
    }
    EXPECT_EQ(up, 0) << "no ceiling, no echo";
    EXPECT_EQ(black, 0);
    EXPECT_GT(walls, 30);
    EXPECT_NEAR(std::sqrt(squares / walls), 0.016, 0.006);
}

TEST(TurningScanner, AtALowerRateTurnsStayWholeAndHaveFewerColumns) {
    RoomBuilder room;
    room.walls(4, 3, 2);
    for (const int rate : {5, 2, 1}) {
        const auto world = room.world();
        const int robot = addBareRobot(*world);
        TurningScanner scanner(mountedScanDrive(), Noise(1, "scanner"), world->now());
        EXPECT_TRUE(scanner.configure(StreamRole::Points, "laser", {.rate = static_cast<double>(rate)}));
        TurnAssembler assembler;
        int scans = 0;
        std::size_t points = 0;
        const auto slices = clouds(*world, robot, scanner, 7s, 20ms);
        for (const CloudSample& slice : slices) {
            points += slice.points.size();
            const auto scan = assembler.add(slice, std::nullopt);
            if (!scan) continue;
            ++scans;
            EXPECT_EQ(scan->rows, 180 * rate / 10 + 1) << rate << " Hz";
        }
        EXPECT_EQ(scans, 3) << rate << " Hz";
        EXPECT_LE(slices.size(), 7U * static_cast<unsigned>(rate) + 4U) << "one more ends each turn";
        EXPECT_LE(points, 29'141U * 7U / 2U * static_cast<unsigned>(rate) / 10U) << rate << " Hz";
    }
}

TEST(TurningScanner, CanBeSwitchedOffAndGoesOnWithItsTurn) {
    RoomBuilder room;
    room.walls(4, 3, 2);
    const auto world = room.world();
    const int robot = addBareRobot(*world);
    TurningScanner scanner(mountedScanDrive(), Noise(1, "scanner"), world->now());
    EXPECT_TRUE(scanner.configure(StreamRole::Points, "laser", {.enabled = false}));
    EXPECT_FALSE(scanner.configure(StreamRole::Ranges, "laser", {}));
    EXPECT_TRUE(clouds(*world, robot, scanner, 1s, 20ms).empty());
    EXPECT_TRUE(scanner.configure(StreamRole::Points, "laser", {}));
    auto slices = clouds(*world, robot, scanner, 1s, 20ms);
    ASSERT_FALSE(slices.empty());
    EXPECT_NEAR(slices[0].rings[0], 74, 5) << "the slice that was under way";
    // Off over the end of a turn: the next one begins with its first raw scan, and nothing closes it alone.
    EXPECT_TRUE(scanner.configure(StreamRole::Points, "laser", {.enabled = false}));
    slices = clouds(*world, robot, scanner, 400ms, 20ms);
    EXPECT_TRUE(slices.empty());
    EXPECT_TRUE(scanner.configure(StreamRole::Points, "laser", {}));
    slices = clouds(*world, robot, scanner, 200ms, 20ms);
    ASSERT_FALSE(slices.empty());
    EXPECT_EQ(slices[0].rings[0], slices[0].rings.back() + 1 - slices[0].rows);
    EXPECT_LT(slices[0].rings.back(), 20);
}

TEST(TurningScanner, OfTheCrawlerGivesPointsAndItsFan) {
    RoomBuilder room;
    room.walls(2, 2, 1);
    const auto world = room.world();
    const int robot = addBareRobot(*world);
    TurningScannerSettings settings = turningUrg();
    settings.sensor = "laser";
    settings.rangesSensor = "laser";
    settings.frame = "crawler/laser";
    settings.fanFrame = "crawler/laser_fan";
    settings.mountInBase.translation().z() = 0.2;
    TurningScanner scanner(settings, Noise(1, "urg"), world->now());
    std::vector<HardwareSample> samples;
    for (int i = 0; i < 700; ++i) {
        world->advance(10ms);
        scanner.run(*world, robot, samples);
    }
    TurnAssembler assembler;
    Pose fan = Pose::Identity();
    int turns = 0, ranges = 0;
    for (const HardwareSample& sample : samples) {
        if (const auto* cloud = sample.sample.as<CloudSample>()) {
            turns += assembler.add(*cloud, std::nullopt).has_value() ? 1 : 0;
        } else if (const auto* transforms = sample.sample.as<TransformsSample>()) {
            fan = transforms->transforms.at(0).childInParent;
        } else if (const auto* scan = sample.sample.as<RangesSample>()) {
            ++ranges;
            for (std::size_t i = 0; i < scan->ranges.size(); ++i) {
                if (!std::isfinite(scan->ranges[i])) continue;
                const double angle = scan->angleMin + scan->angleStep * double(i);
                const Eigen::Vector3d p =
                    settings.mountInBase * fan *
                    Eigen::Vector3d(double{scan->ranges[i]} *
                                    Eigen::Vector3d(std::cos(angle), std::sin(angle), 0));
                const double off =
                    std::min({std::abs(std::abs(p.x()) - 2), std::abs(std::abs(p.y()) - 2), std::abs(p.z())});
                EXPECT_LT(off, 0.15);
            }
        }
    }
    EXPECT_EQ(turns, 1);
    EXPECT_NEAR(ranges, 70, 1);
}

TEST(TiltingScanner, SweepsWhileItStandsAndNeverWhileItMoves) {
    RoomBuilder room;
    room.walls(4, 3, 2);
    const auto world = room.world();
    const int robot = addBareRobot(*world);
    TiltingScannerSettings settings;
    settings.sensor = "laser";
    settings.frame = "kurt3d/laser";
    settings.mountInBase.translation().z() = 0.4;
    TiltingScanner scanner(settings, Noise(1, "tilting"), world->now());
    auto sweeps = clouds(*world, robot, scanner, 4s, 20ms);
    ASSERT_EQ(sweeps.size(), 1U);
    EXPECT_EQ(sweeps[0].rows, 241);
    EXPECT_EQ(sweeps[0].columns, 181);
    EXPECT_EQ(sweeps[0].points.size(), 241U * 181U);
    EXPECT_LT(sweeps[0].times.back(), 4'290'000'000);
    for (const Eigen::Vector3f& point : sweeps[0].points) {
        if (!point.allFinite()) continue;
        const Eigen::Vector3d p = settings.mountInBase * point.cast<double>();
        EXPECT_LT(std::min({std::abs(std::abs(p.x()) - 4), std::abs(std::abs(p.y()) - 3), std::abs(p.z())}),
                  0.15);
        EXPECT_GE(point.x(), -1e-3F) << "180 degrees";
    }
    TurnAssembler assembler;
    EXPECT_TRUE(assembler.add(sweeps[0], std::nullopt)) << "a whole sweep is a scan";

    world->setMotors(robot, 0.3, 0.3);
    EXPECT_TRUE(clouds(*world, robot, scanner, 5s, 20ms).empty()) << "go";
    world->setMotors(robot, 0.0, 0.0);
    world->setBrake(robot, true);
    EXPECT_EQ(clouds(*world, robot, scanner, 6s, 20ms).size(), 1U) << "stop, scan";
}

}  // namespace
}  // namespace leitstand::simulation::test
