#include "tests/simulation/mapping/recorded_drive.h"

#include <cmath>
#include <stdexcept>
#include <utility>

#include "core/event/cloud_sample.h"
#include "core/event/motion_samples.h"
#include "robots/simulation/arena/arena_generator.h"
#include "tests/simulation/drives/driven_world.h"

namespace leitstand::simulation::test {
namespace {

/// A robot in a yellow arena, and what it says.
class Recorder {
public:
    Recorder(std::uint64_t seed, ScannerMount scanner)
        : m_driven(generateArena(Grade::Yellow, seed), setup(seed, scanner)) {
        drive.arena = m_driven.world->arena();
        drive.robot = shippedRobot("kurt3d");
        m_driven.onSample = [this](const HardwareSample& sample) {
            if (isForMapping(sample)) drive.received.push_back({m_driven.world->now(), sample});
        };
        drive.truth.add(m_driven.world->now(), m_driven.state().baseInArena);
        m_place = m_driven.place();
        pass(3.0);  // robots stand at first
    }
    void pass(double time) {
        for (int i = 0; i < static_cast<int>(time * 100.0 + 0.5); ++i) {
            m_driven.pass(0.01);
            drive.truth.add(m_driven.world->now(), m_driven.state().baseInArena);
            drive.way += (m_driven.place() - m_place).norm();
            m_place = m_driven.place();
        }
    }
    /// With the sticks at that; returns how far the robot came [m].
    double move(double forward, double turn, double time) {
        const Eigen::Vector2d before = m_driven.place();
        m_driven.sticks = DriveVelocity{forward, 0.0, turn};
        pass(time);
        return (m_driven.place() - before).norm();
    }
    [[nodiscard]] DrivenWorld& driven() { return m_driven; }

    RecordedDrive drive;

private:
    static DriveSetup setup(std::uint64_t seed, ScannerMount scanner) {
        DriveSetup made;
        made.seed = seed;
        made.infrared = false;
        made.scanner = scanner;
        return made;
    }
    DrivenWorld m_driven;
    Eigen::Vector2d m_place;
};

}  // namespace

bool isForMapping(const HardwareSample& sample) {
    return sample.sample.is<CloudSample>() || sample.sample.is<OdometrySample>() ||
           sample.sample.is<ImuSample>();
}

Pose RecordedDrive::baseInArena(Time stamp) const {
    const auto pose = truth.at(stamp);
    if (!pose) throw std::out_of_range("the drive has no truth at that time");
    return *pose;
}

RecordedDrive exploredYellow(std::uint64_t seed, double seconds) {
    Recorder recorder(seed, ScannerMount::ScanDrive);
    DrivenWorld& driven = recorder.driven();
    driven.station->mode("explore");
    recorder.pass(0.1);
    while (driven.world->seconds() < seconds) {
        if (driven.mode() == DriveMode::Explore) {
            recorder.pass(0.1);
            if (driven.reason() == "nothing is left to explore") driven.station->mode("teleoperation");
            continue;
        }
        // Curves to both sides, and around where it does not go on.
        if (recorder.move(0.4, 0.8 * std::sin(0.4 * driven.world->seconds()), 1.0) > 0.1) continue;
        (void)recorder.move(-0.2, 0.0, 1.0);
        (void)recorder.move(0.0, 1.0, 1.5);
    }
    return std::move(recorder.drive);
}

RecordedDrive stopScanGo(std::uint64_t seed, int stops) {
    constexpr double Sweep = 4.5;  // with settling [s]
    Recorder recorder(seed, ScannerMount::Tilting);
    (void)recorder.move(0.0, 0.0, 1.0);
    for (int i = 0; i < stops; ++i) {
        if (recorder.move(0.3, 0.0, 1.5) < 0.2) {
            (void)recorder.move(-0.2, 0.0, 1.0);
            (void)recorder.move(0.0, 1.0, 1.0);
        }
        (void)recorder.move(0.0, 0.0, Sweep);
    }
    return std::move(recorder.drive);
}

RecordedDrive withRadioGap(RecordedDrive drive, double from, double to) {
    const Time begin = drive.received.front().at;
    const auto inGap = [&](const RecordedDrive::Received& received) {
        const double time = std::chrono::duration<double>(received.at - begin).count();
        return time >= from && time < to;
    };
    std::vector<RecordedDrive::Received> received, late;
    for (RecordedDrive::Received& one : drive.received) {
        const bool gap = inGap(one), slice = one.sample.sample.is<CloudSample>();
        if (gap && slice) late.push_back(one);
        if (gap) continue;
        // What is new waits behind the history.
        for (std::size_t i = 0; i < late.size() && one.at > late.back().at; ++i) {
            late[i].at = one.at;
            received.push_back(late[i]);
            if (i % 2 == 0) received.push_back(late[i]);
            if (i + 1 == late.size()) late.clear();
        }
        received.push_back(std::move(one));
    }
    drive.received = std::move(received);
    return drive;
}

}  // namespace leitstand::simulation::test
