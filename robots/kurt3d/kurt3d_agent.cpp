#include "robots/kurt3d/kurt3d_agent.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <utility>

#include "core/base/time.h"
#include "core/event/all_samples.h"
#include "core/event/picture_samples.h"
#include "core/event/stream_role.h"
#include "core/perception/heat/heat.h"
#include "core/perception/pictures/coding/picture_decoding.h"
#include "core/robot/control/pan_tilt.h"

namespace leitstand {
namespace {

constexpr auto CueAge = std::chrono::milliseconds(700);

// Bounds for visiting what it passed by.
constexpr double BeenTo = 1.0;       ///< heat nearer to each other is one body [m]
constexpr double LooksFrom = 3.0;    ///< the camera looks at heat that is nearer [m]
constexpr double ThereWithin = 0.6;  ///< of where it was seen from [m]
constexpr auto LooksFor = std::chrono::seconds(8);
constexpr double TurnsFrom = degrees(60);  ///< when it is farther aside, the robot turns, too [rad]
constexpr double TurnRate = 0.5;           ///< [rad/s]

/// Returns the infrared camera that can be turned; null: there is none.
const SensorDescription* heatCamera(const RobotDescription& robot) {
    for (const StreamDescription& stream : robot.streams) {
        const auto sensor = robot.sensors.find(stream.sensor);
        if (stream.role == StreamRole::Thermal && sensor != robot.sensors.end() && sensor->second.panTilt)
            return &sensor->second;
    }
    return nullptr;
}

}  // namespace

Result<std::unique_ptr<Kurt3dAgent>> Kurt3dAgent::create(RobotHardware& hardware,
                                                         const RobotDescription& robot,
                                                         const FuzzySystem& fuzzy,
                                                         const Kurt3dSettings& settings) {
    const auto drive = driveFor(robot, fuzzy, settings.driving);
    if (!drive) return drive.error();
    return std::unique_ptr<Kurt3dAgent>(new Kurt3dAgent(hardware, robot, *drive, settings));
}

Kurt3dAgent::Kurt3dAgent(RobotHardware& hardware, const RobotDescription& robot, const FuzzyDrive& drive,
                         const Kurt3dSettings& settings)
    : SelfDrivingAgent(hardware, robot, drive, settings.agent, settings.driving),
      m_settings(settings),
      m_approach(drive) {}

void Kurt3dAgent::sense(HardwareSample& sample) {
    SelfDrivingAgent::sense(sample);
    if (const auto* info = sample.sample.as<CameraInfoSample>()) {
        m_cameras[sample.sensor] = *info;
    } else if (const auto* picture = sample.sample.as<PictureSample>()) {
        if (sample.role == StreamRole::Thermal) see(sample, *picture);
    }
}

void Kurt3dAgent::see(const HardwareSample& sample, const PictureSample& picture) {
    const auto camera = m_cameras.find(sample.sensor);
    const auto place = inBase(picture.header.frame, sample.sensor);
    const StreamDescription* stream = robot().stream(StreamRole::Thermal, sample.sensor);
    const auto robotThen = odometry().at(picture.header.stamp);
    if (camera == m_cameras.end() || !place || !robotThen || stream == nullptr) return;
    const auto decoded = decodePicture(picture);
    if (!decoded) return;
    const auto heat = temperatures(*decoded, stream->thermal);
    if (!heat) return;
    const auto blobs = findHeat(*heat, camera->second);
    auto cues = cuesFrom(blobs, *heat, camera->second, *robotThen * *place, picture.header.stamp);
    if (!cues.empty()) m_cues = std::move(cues);
}

void Kurt3dAgent::consider(VirtualScanView& view, const Pose& here, Time now) {
    if (!m_cues.empty() && now - m_cues.front().at > CueAge) m_cues.clear();
    if (!m_cues.empty() && m_cues.front().at > m_considered) {
        m_considered = m_cues.front().at;
        for (const HeatCue& cue : m_cues) {
            if (const auto heat = m_approach.another(cue, view, here))
                m_passed.see(*heat, here.translation());
        }
    }
    m_cue = m_approach.pick(m_cues, view, here);
    reported().cue = m_cue && m_approach.isNew(*m_cue, view, here);
}

void Kurt3dAgent::takeOver(Driver before, Driver now) {
    static_cast<void>(now);
    if (before == Driver::Approacher && m_approach.isActive()) m_approach.abort();
}

DriveVelocity Kurt3dAgent::think(const ModeDecision& decision, const Pose& here, Time now) {
    const bool explores = decision.driver == Driver::Explorer && !hasGoal();
    if (!explores) leaveVisited();
    if (decision.driver == Driver::Approacher) return approach(here, now);
    if (explores) {
        if (const auto velocity = visit(here, now)) return *velocity;
    }
    return SelfDrivingAgent::think(decision, here, now);
}

void Kurt3dAgent::thought(const ModeDecision& decision, Time now) {
    if (decision.mode != DriveMode::VictimApproach) m_heat.reset();
    lookForHeat(decision, now);
}

void Kurt3dAgent::lookForHeat(const ModeDecision& decision, Time now) {
    const SensorDescription* camera = heatCamera(robot());
    if (camera == nullptr) return;
    const auto here = odometry().at(now);
    PanTiltAngles angles;
    // Also while it waits before a victim: for its operator, who judges by what the cameras show.
    std::optional<Eigen::Vector3d> lookAt = m_heat;
    if (m_visited && here && (m_visited->heat - here->translation()).norm() < LooksFrom)
        lookAt = m_visited->heat;
    if (lookAt && here) {
        const Eigen::Vector3d heat = here->inverse() * *lookAt;
        angles = within(*camera->panTilt, towards(heat - camera->sensorInBase.translation()));
    } else if (decision.driver == Driver::Explorer) {
        // Swings to both sides at an even rate.
        const double seconds = toSeconds(now.time_since_epoch());
        const double phase = std::fmod(seconds * m_settings.lookRate / m_settings.lookAside, 4.0);
        angles.pan = m_settings.lookAside * (phase < 2.0 ? phase - 1.0 : 3.0 - phase);
    } else if (!m_looks) {
        return;  // cameras that it did not turn stay where they are
    }
    m_looks = look(camera->panTilt->unit, angles.pan, angles.tilt) && angles != PanTiltAngles{};
}

void Kurt3dAgent::leaveVisited() {
    m_visited.reset();
    m_lookedSince.reset();
}

std::optional<DriveVelocity> Kurt3dAgent::visit(const Pose& here, Time now) {
    if (!m_visited) m_visited = m_passed.next(here.translation());
    if (!m_visited) return std::nullopt;
    if (!m_lookedSince) {
        if (const auto velocity = driveBy(m_visited->from, here, now)) return velocity;
        const bool there = (m_visited->from - here.translation()).head<2>().norm() < ThereWithin;
        if (there) m_lookedSince = now;
    }
    // When it is in sight, the modes begin an approach.
    if (!m_lookedSince || now - *m_lookedSince > LooksFor) {
        m_passed.forget(m_visited->heat, BeenTo);
        leaveVisited();
        return std::nullopt;
    }
    const Eigen::Vector3d heat = here.inverse() * m_visited->heat;
    const double bearing = std::atan2(heat.y(), heat.x());
    if (std::abs(bearing) < TurnsFrom) return DriveVelocity{};
    return safeVelocity({0.0, 0.0, std::copysign(TurnRate, bearing)}, view(), safety()).velocity;
}

DriveVelocity Kurt3dAgent::approach(const Pose& here, Time now) {
    if (!m_approach.isActive() && m_cue) m_approach.start(*m_cue, now);
    const ApproachStep step = m_approach.step(m_cue, view(), here, now);
    m_heat = m_approach.heat();
    reported().done = step.done;
    reported().failed = step.failed;
    reported().text = step.reason;
    if (step.done || step.failed) m_passed.forget(*m_heat, BeenTo);
    if (step.failed) {  // what it has just left is no reason to begin again
        reported().cue = false;
        m_cue.reset();
    }
    if (m_approach.sightings().size() != m_sightings) {
        m_sightings = m_approach.sightings().size();
        explorer().shun(m_approach.sightings().back().position, 0.6);
        publish(StreamRole::Sightings, SightingSample{{now, robot().odomFrame}, m_approach.sightings()});
    }
    return step.velocity;
}

}  // namespace leitstand
