#include "tests/simulation/mapping/recorded_drive.h"

#include <cmath>
#include <stdexcept>
#include <variant>

#include "robots/simulation/arena/arena_generator.h"
#include "tests/simulation/drives/driven_world.h"

namespace leitstand::simulation::test {
namespace {

bool isForMapping(const HardwareSample& sample) {
    return std::holds_alternative<CloudSample>(sample.sample) ||
           std::holds_alternative<OdometrySample>(sample.sample) ||
           std::holds_alternative<ImuSample>(sample.sample);
}

}  // namespace

Pose RecordedDrive::baseInArena(Time stamp) const {
    const auto pose = truth.at(stamp);
    if (!pose) throw std::out_of_range("the drive has no truth at that time");
    return *pose;
}

RecordedDrive exploredYellow(std::uint64_t seed, double seconds) {
    RecordedDrive drive;
    drive.arena = generateArena(Grade::Yellow, seed);
    drive.robot = shippedRobot("kurt3d");
    DriveSetup setup;
    setup.seed = seed;
    setup.infrared = false;
    DrivenWorld driven(drive.arena, setup);
    driven.onSample = [&](const HardwareSample& sample) {
        if (isForMapping(sample)) drive.heard.push_back({driven.world->now(), sample});
    };
    drive.truth.add(driven.world->now(), driven.state().baseInArena);
    Eigen::Vector2d place = driven.place();
    const auto pass = [&](double time) {
        for (int i = 0; i < static_cast<int>(time * 100.0 + 0.5); ++i) {
            driven.pass(0.01);
            drive.truth.add(driven.world->now(), driven.state().baseInArena);
            drive.way += (driven.place() - place).norm();
            place = driven.place();
        }
    };
    pass(3.0);  // robots stand at first
    driven.station->mode("explore");
    pass(0.1);
    while (driven.world->seconds() < seconds) {
        if (driven.mode() == DriveMode::Explore) {
            pass(0.1);
            if (driven.reason() == "nothing is left to explore") driven.station->mode("teleoperation");
        } else {
            // Curves to both sides, and around where it does not go on.
            const double now = driven.world->seconds();
            driven.sticks = DriveVelocity{0.4, 0.0, 0.8 * std::sin(0.4 * now)};
            const Eigen::Vector2d before = driven.place();
            pass(1.0);
            if ((driven.place() - before).norm() > 0.1) continue;
            driven.sticks = DriveVelocity{-0.2, 0.0, 0.0};
            pass(1.0);
            driven.sticks = DriveVelocity{0.0, 0.0, 1.0};
            pass(1.5);
        }
    }
    return drive;
}

}  // namespace leitstand::simulation::test
