#include "robots/agent/self_driving_agent.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/event/cloud_sample.h"
#include "core/event/motion_samples.h"
#include "core/perception/surroundings/robot_profile.h"
#include "core/robot/robot_format.h"

namespace leitstand {
namespace {

constexpr double LevelPlane = degrees(30);  ///< planes of lasers that are tilted more are not used

DriveVelocity slowed(const DriveVelocity& velocity, double share) {
    return {share * velocity.forward, share * velocity.left, share * velocity.turn};
}

}  // namespace

VirtualScanSettings scanFor(const RobotDescription& robot, const SelfDrivingSettings& settings) {
    VirtualScanSettings scan = settings.scan;
    scan.body = boxAround(robot.footprint);
    scan.profile = profileOf(robot, settings.scan.profile);
    // A low robot keeps at least the height of the settings: others and boards stick out over it.
    scan.profile.height = std::max(scan.profile.height, settings.scan.profile.height);
    return scan;
}

Result<FuzzyDrive> SelfDrivingAgent::driveFor(const RobotDescription& robot, const FuzzySystem& fuzzy,
                                              const SelfDrivingSettings& settings) {
    FuzzyDriveSettings driving = settings.drive;
    driving.safety.body = boxAround(robot.footprint);
    return FuzzyDrive::create(fuzzy, driving);
}

SelfDrivingAgent::SelfDrivingAgent(RobotHardware& hardware, const RobotDescription& robot,
                                   const FuzzyDrive& drive, const AgentSettings& agent,
                                   const SelfDrivingSettings& settings)
    : RobotAgent(hardware, robot, agent),
      m_thinks(settings.thinks),
      m_safety(drive.settings().safety),
      m_scan(scanFor(robot, settings)),
      m_explorer(drive, settings.explorer) {}

void SelfDrivingAgent::sense(HardwareSample& sample) {
    const auto then = [this](Time at) { return m_odometry.at(at); };
    if (const auto* odometry = sample.sample.as<OdometrySample>()) {
        m_odometry.add(odometry->header.stamp, odometry->baseInOdom);
    } else if (const auto* transforms = sample.sample.as<TransformsSample>()) {
        for (const FrameTransform& one : transforms->transforms)
            m_frames[one.childFrame] = {one.header.frame, one.childInParent};
    } else if (const auto* cloud = sample.sample.as<CloudSample>()) {
        if (const auto place = inBase(cloud->header.frame, sample.sensor)) m_scan.add(*cloud, *place, then);
    } else if (const auto* ranges = sample.sample.as<RangesSample>()) {
        // A plane that a unit turns upright measures heights; its points also come as clouds.
        const auto place = inBase(ranges->header.frame, sample.sensor);
        if (place && std::abs(place->linear()(2, 2)) > std::cos(LevelPlane))
            m_scan.add(*ranges, *place, then);
    }
}

std::optional<Pose> SelfDrivingAgent::inBase(const std::string& frame, const std::string& sensor) const {
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

void SelfDrivingAgent::consider(VirtualScanView& view, const Pose& here, Time now) {
    static_cast<void>(view);
    static_cast<void>(here);
    static_cast<void>(now);
}

void SelfDrivingAgent::thought(const ModeDecision& decision, Time now) {
    static_cast<void>(decision);
    static_cast<void>(now);
}

void SelfDrivingAgent::takeOver(Driver before, Driver now) {
    static_cast<void>(before);
    static_cast<void>(now);
}

RobotAgent::Report SelfDrivingAgent::report(Time now) {
    if (const auto here = m_odometry.at(now); here && isDue(now)) {
        m_view = m_scan.view(*here, now);
        consider(m_view, *here, now);
    }
    Report reported = m_report;
    reported.sent = m_report.sent || m_goal;
    m_report.sent = m_report.done = m_report.failed = false;
    m_report.text.clear();
    return reported;
}

void SelfDrivingAgent::goTo(const PoseSample& goal) {
    if (!goal.poseInFrame.translation().allFinite()) return;
    const auto here = m_odometry.newest();
    if (goal.header.frame == robot().odomFrame) {
        m_goal = goal.poseInFrame.translation();
    } else if (goal.header.frame == robot().baseFrame && here) {
        m_goal = (*here * goal.poseInFrame).translation();
    }
}

DriveVelocity SelfDrivingAgent::steer(const ModeDecision& decision, const DriveVelocity& requested,
                                      Time now) {
    const bool began = decision.driver != m_driver;
    if (began) {
        takeOver(m_driver, decision.driver);
        if (decision.driver == Driver::Explorer || decision.driver == Driver::Returner) m_explorer.resume();
        m_velocity = {};
    }
    m_driver = decision.driver;
    if (began || isDue(now)) {
        m_thought = now;
        if (const auto here = m_odometry.at(now)) {
            // The link was good where the station was last heard, not where its silence became too long.
            m_trail.moved(*here, decision.receivedNow, decision.driver == Driver::Returner);
            m_velocity = think(decision, *here, now);
        } else {
            m_velocity = {};
        }
        thought(decision, now);
    }
    switch (decision.driver) {
        case Driver::Operator:
        case Driver::Remote:
            return requested;
        case Driver::LimitedOperator:
            return slowed(safeVelocity(requested, m_view, m_safety).velocity, caution());
        case Driver::Explorer:
        case Driver::Approacher:
        case Driver::Returner:
            return slowed(m_velocity, caution());
        case Driver::Nobody:
            break;
    }
    return {};
}

DriveVelocity SelfDrivingAgent::think(const ModeDecision& decision, const Pose& here, Time now) {
    if (decision.driver == Driver::Explorer) return explore(m_goal, here, now);
    if (decision.driver == Driver::Returner) return comeBack(here, now);
    m_explorer.see(m_view, here, now);
    return {};
}

DriveVelocity SelfDrivingAgent::comeBack(const Pose& here, Time now) {
    if (m_trail.isBack()) {
        m_report.done = true;
        m_report.text = robot_format::BackWhereLinkWasGood;
        return {};
    }
    const DriveVelocity velocity = explore(m_trail.next(), here, now);
    m_report.done = false;  // one place of the trail is not its end
    return velocity;
}

std::optional<DriveVelocity> SelfDrivingAgent::driveBy(const Eigen::Vector3d& place, const Pose& here,
                                                       Time now) {
    const DriveVelocity velocity = explore(place, here, now);
    const bool over = m_report.done || m_report.failed;
    m_report.done = m_report.failed = false;
    return over ? std::nullopt : std::optional(velocity);
}

DriveVelocity SelfDrivingAgent::explore(const std::optional<Eigen::Vector3d>& goal, const Pose& here,
                                        Time now) {
    if (m_explorer.goal() != goal) m_explorer.setGoal(goal);
    const ExplorerStep step = m_explorer.step(m_view, here, m_scan.newest(), now);
    m_report.done = step.done;
    m_report.failed = step.failed;
    m_report.text = step.reason;
    m_report.sent = m_goal.has_value();
    if (step.done || step.failed) m_goal.reset();
    return step.velocity;
}

}  // namespace leitstand
