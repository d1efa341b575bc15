#include "robots/kurt3d/kurt3d_agent.h"

#include <algorithm>
#include <cmath>
#include <utility>
#include <variant>

#include "core/perception/heat.h"
#include "core/perception/picture_decoding.h"
#include "core/robot/robot_says.h"

namespace leitstand {
namespace {

constexpr auto HeatUnit = "right";  ///< pan-tilt unit that carries the infrared camera
constexpr auto CueAge = std::chrono::milliseconds(700);

SafeTeleoperationSettings safetyOf(const RobotDescription& robot) {
    SafeTeleoperationSettings safety;
    safety.body = boxAround(robot.footprint);
    return safety;
}

VirtualScanSettings scanOf(const RobotDescription& robot) {
    VirtualScanSettings scan;
    scan.body = boxAround(robot.footprint);
    return scan;
}

}  // namespace

Result<std::unique_ptr<Kurt3dAgent>> Kurt3dAgent::create(RobotHardware& hardware,
                                                         const RobotDescription& robot,
                                                         const FuzzySystem& fuzzy,
                                                         const Kurt3dSettings& settings) {
    FuzzyDriveSettings driving;
    driving.safety = safetyOf(robot);
    const auto drive = FuzzyDrive::create(fuzzy, driving);
    if (!drive) return drive.error();
    return std::unique_ptr<Kurt3dAgent>(new Kurt3dAgent(hardware, robot, *drive, settings));
}

Kurt3dAgent::Kurt3dAgent(RobotHardware& hardware, const RobotDescription& robot, const FuzzyDrive& drive,
                         const Kurt3dSettings& settings)
    : RobotAgent(hardware, robot, settings.agent),
      m_settings(settings),
      m_safety(safetyOf(robot)),
      m_scan(scanOf(robot)),
      m_explorer(drive),
      m_approach(drive) {}

void Kurt3dAgent::sense(HardwareSample& sample) {
    if (const auto* odometry = std::get_if<OdometrySample>(&sample.sample)) {
        m_odometry.add(odometry->header.stamp, odometry->baseInOdom);
    } else if (const auto* transforms = std::get_if<TransformsSample>(&sample.sample)) {
        for (const FrameTransform& one : transforms->transforms)
            m_frames[one.childFrame] = {one.header.frame, one.childInParent};
    } else if (const auto* info = std::get_if<CameraInfoSample>(&sample.sample)) {
        m_cameras[sample.sensor] = *info;
    } else if (const auto* cloud = std::get_if<CloudSample>(&sample.sample)) {
        if (const auto place = inBase(cloud->header.frame, sample.sensor))
            m_scan.add(*cloud, *place, [this](Time at) { return m_odometry.at(at); });
    } else if (const auto* picture = std::get_if<PictureSample>(&sample.sample)) {
        if (sample.role == StreamRole::Thermal) see(sample, *picture);
    }
}

std::optional<Pose> Kurt3dAgent::inBase(const std::string& frame, const std::string& sensor) const {
    Pose pose = Pose::Identity();
    std::string at = frame;
    for (int links = 0; links < 8 && at != robot().baseFrame; ++links) {
        const auto found = m_frames.find(at);
        if (found == m_frames.end()) break;
        pose = found->second.second * pose;
        at = found->second.first;
    }
    if (at == robot().baseFrame) return pose;
    const auto described = robot().sensors.find(sensor);
    if (described == robot().sensors.end() || described->second.frame != frame) return std::nullopt;
    return described->second.sensorInBase;
}

void Kurt3dAgent::see(const HardwareSample& sample, const PictureSample& picture) {
    const auto camera = m_cameras.find(sample.sensor);
    const auto place = inBase(picture.header.frame, sample.sensor);
    const StreamDescription* stream = robot().stream(StreamRole::Thermal, sample.sensor);
    const auto robotThen = m_odometry.at(picture.header.stamp);
    if (camera == m_cameras.end() || !place || !robotThen || stream == nullptr) return;
    const auto decoded = decodePicture(picture);
    if (!decoded) return;
    const auto heat = temperatures(*decoded, stream->thermal);
    if (!heat) return;
    const auto blobs = findHeat(*heat, camera->second);
    auto cues =
        cuesFrom(blobs, camera->second, heat->width, heat->height, *robotThen * *place, picture.header.stamp);
    if (!cues.empty()) m_cues = std::move(cues);
}

RobotAgent::Report Kurt3dAgent::report(Time now) {
    if (!m_cues.empty() && now - m_cues.front().at > CueAge) m_cues.clear();
    const auto here = m_odometry.at(now);
    if (here && (!m_thought || now - *m_thought >= m_settings.thinks)) {
        m_view = m_scan.view(*here, now);
        m_cue = m_approach.pick(m_cues, m_view, *here);
        m_report.cue = m_cue && m_approach.isNew(*m_cue, m_view, *here);
    }
    Report told = m_report;
    m_report.done = m_report.failed = false;
    m_report.text.clear();
    return told;
}

void Kurt3dAgent::goTo(const PoseSample& goal) {
    if (!goal.poseInFrame.translation().allFinite()) return;
    const auto here = m_odometry.newest();
    if (goal.header.frame == robot().odomFrame) {
        m_goal = goal.poseInFrame.translation().head<2>();
    } else if (goal.header.frame == robot().baseFrame && here) {
        m_goal = (*here * goal.poseInFrame).translation().head<2>();
    }
}

DriveVelocity Kurt3dAgent::steer(const ModeDecision& decision, const DriveVelocity& wish, Time now) {
    const bool began = decision.driver != m_before;
    if (began) {
        if (m_before == Driver::Approacher && m_approach.isActive()) m_approach.abort();
        if (decision.driver == Driver::Explorer || decision.driver == Driver::Returner) m_explorer.resume();
        m_velocity = {};
    }
    m_before = decision.driver;
    if (began || !m_thought || now - *m_thought >= m_settings.thinks) {
        m_thought = now;
        m_velocity = think(decision, now);
        lookForHeat(decision.driver, now);
    }
    switch (decision.driver) {
        case Driver::Operator:
        case Driver::Remote:
            return wish;
        case Driver::LimitedOperator:
            return safeVelocity(wish, m_view, m_safety).velocity;
        case Driver::Explorer:
        case Driver::Approacher:
        case Driver::Returner:
            return m_velocity;
        case Driver::Nobody:
            break;
    }
    return {};
}

void Kurt3dAgent::lookForHeat(Driver driver, Time now) {
    const auto here = m_odometry.at(now);
    double pan = 0.0;
    if (driver == Driver::Approacher && here && m_approach.isActive()) {
        pan = std::clamp(m_approach.bearing(*here), -degrees(100), degrees(100));
    } else if (driver == Driver::Explorer) {
        // To and fro, at an even rate.
        const double seconds = std::chrono::duration<double>(now.time_since_epoch()).count();
        const double phase = std::fmod(seconds * m_settings.lookRate / m_settings.lookAside, 4.0);
        pan = m_settings.lookAside * (phase < 2.0 ? phase - 1.0 : 3.0 - phase);
    } else if (!m_looks) {
        return;  // others' cameras stay where they are
    }
    m_looks = look(HeatUnit, pan, 0.0) && driver != Driver::Nobody && pan != 0.0;
}

DriveVelocity Kurt3dAgent::think(const ModeDecision& decision, Time now) {
    const auto here = m_odometry.at(now);
    if (!here) return {};
    // The link was good where the station was heard last, not where its silence was found too long.
    m_trail.moved(*here, decision.heardNow, decision.driver == Driver::Returner);
    switch (decision.driver) {
        case Driver::Explorer:
            return explore(m_goal, now);
        case Driver::Approacher:
            return approach(now);
        case Driver::Returner:
            if (m_trail.isBack()) {
                m_report.done = true;
                m_report.text = robot_says::BackWhereLinkWasGood;
                return {};
            } else {
                const DriveVelocity velocity = explore(m_trail.next(), now);
                m_report.done = false;  // one place of the trail is not its end
                return velocity;
            }
        default:
            m_explorer.see(m_view, *here, now);
            return {};
    }
}

DriveVelocity Kurt3dAgent::explore(const std::optional<Eigen::Vector2d>& goal, Time now) {
    if (m_explorer.goal() != goal) m_explorer.setGoal(goal);
    const ExplorerStep step = m_explorer.step(m_view, *m_odometry.at(now), m_scan.newest(), now);
    m_report.done = step.done;
    m_report.failed = step.failed;
    m_report.text = step.reason;
    if (step.done || step.failed) m_goal.reset();
    return step.velocity;
}

DriveVelocity Kurt3dAgent::approach(Time now) {
    if (!m_approach.isActive() && m_cue) m_approach.start(*m_cue, now);
    const ApproachStep step = m_approach.step(m_cue, m_view, *m_odometry.at(now), now);
    m_report.done = step.done;
    m_report.failed = step.failed;
    m_report.text = step.reason;
    if (m_approach.sightings().size() != m_sightings) {
        m_sightings = m_approach.sightings().size();
        m_explorer.shun(m_approach.sightings().back().position.head<2>(), 0.6);
        say(StreamRole::Sightings, SightingSample{{now, robot().odomFrame}, m_approach.sightings()});
    }
    return step.velocity;
}

}  // namespace leitstand
