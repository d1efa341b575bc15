#include "app/services/station/lines/robot_line.h"

#include <algorithm>
#include <array>
#include <utility>

#include "core/base/time.h"
#include "core/base/words.h"
#include "core/event/stream_role.h"
#include "core/robot/joints/joint_message.h"
#include "transport/convert/encode.h"

namespace leitstand {
namespace {

/// Commands that are requests: published once, when the operator makes them.
constexpr std::array Requests = {StreamRole::ModeCommand, StreamRole::GoalPose, StreamRole::PanTiltCommand,
                                 StreamRole::StreamCommand};

}  // namespace

Result<std::unique_ptr<RobotLine>> RobotLine::create(Node& node, const RobotDescription& robot,
                                                     const std::string& station, Driving driving,
                                                     Listener listener) {
    std::unique_ptr<RobotLine> line(new RobotLine(robot));
    auto opened = line->open(node, station, std::move(driving), std::move(listener));
    if (!opened) return opened.error();
    return line;
}

Result<void> RobotLine::open(Node& node, const std::string& station, Driving with, Listener listener) {
    for (const StreamRole role : Requests) {
        const StreamDescription* stream = m_robot.stream(role);
        if (stream == nullptr) continue;
        // Several requests of one moment do not displace one another before they are acknowledged.
        Qos qos = stream->qos;
        qos.depth = std::max(qos.depth, 32);
        auto publisher = node.publisher({stream->topic, stream->type, qos, Flow::Immediate});
        if (!publisher) return publisher.error();
        m_commands.emplace(role, Command{stream->type, std::move(publisher).value()});
    }
    for (const JointGroup& group : m_robot.jointGroups) {
        const StreamDescription* const stream = m_robot.commandsOf(group);
        if (stream == nullptr) continue;
        auto publisher = node.publisher({stream->topic, stream->type, stream->qos, Flow::Immediate});
        if (!publisher) return publisher.error();
        m_joints.emplace(group.name, Command{stream->type, std::move(publisher).value()});
    }
    if (const ServiceDescription* const action = m_robot.navigation()) {
        auto navigation = NavigationClient::create(node, action->name);
        if (navigation)
            m_navigation = std::move(navigation).value();
        else
            m_problems.push_back(navigation.error().text);
    }
    m_calls = RobotCalls::create(node, m_robot, std::move(listener.called), m_problems);
    LinkClientSettings pings;
    pings.station = station;
    LinkListener& watch = listener.link;
    watch.onStatus = [this, then = std::move(watch.onStatus)](const LinkStatus& status) {
        m_linkLost = status.state == LinkState::Lost;
        m_calls->expire(steadyNow());
        if (status.clock) m_clockAhead = status.clock->ahead.count();
        if (then) then(status);
    };
    auto link = LinkClient::create(node, m_robot, pings, std::move(watch));
    if (!link) return link.error();
    m_link = std::move(link).value();
    const bool driven = m_robot.stream(StreamRole::DriveCommand) != nullptr ||
                        m_robot.stream(StreamRole::TrackCommand) != nullptr;
    if (!driven) return {};
    DriveStreamerSettings driving;
    driving.onPulse = std::move(with.onPulse);
    driving.conditions = [this, given = std::move(with.conditions)] {
        DriveConditions now = given();
        if (m_linkLost) now.mayDrive = false;  // when it is back, sticks that are still held move nothing
        return now;
    };
    driving.sight = [this](const DriveVelocity& sticks, bool withoutEyes) {
        return m_sight.cap(sticks, withoutEyes);
    };
    driving.clockAhead = [this] { return std::chrono::nanoseconds(m_clockAhead); };
    auto drive = DriveStreamer::create(node, m_robot, std::move(driving));
    if (!drive) return drive.error();
    m_drive = std::move(drive).value();
    return {};
}

void RobotLine::fillView(RobotView& robot) const {
    robot.link = m_link->status();
    m_sight.fillView(robot);
    if (m_navigation) robot.navigation = m_navigation->view();
    if (!m_drive) return;
    const DriveStatus status = m_drive->status();
    robot.drive = {.drivable = true,
                   .velocity = status.velocity,
                   .focus = status.focus,
                   .driving = status.driving,
                   .needsNeutral = status.needsNeutral,
                   .listening = status.listeners > 0,
                   .reachable = m_drive->listeners() > 0,
                   .sight = status.sight};
}

Result<void> RobotLine::publish(StreamRole role, const Sample& command) {
    const auto found = m_commands.find(role);
    if (found == m_commands.end()) {
        return Error{leitstand::fill(translate("leitstand::Error", "{}: its file names no {} stream"),
                                     m_robot.name, toString(role))};
    }
    const auto cdr = encode(command, found->second.type);
    if (!cdr) return cdr.error();
    return found->second.publisher->write(*cdr);
}

Result<void> RobotLine::moveJoints(const JointGroup& group, const JointSetpoints& setpoints) {
    const auto found = m_joints.find(group.name);
    if (found == m_joints.end()) {
        return Error{leitstand::fill(translate("leitstand::Error", "{}: its file names no {} stream"),
                                     m_robot.name, toString(StreamRole::JointCommand))};
    }
    const auto cdr = encode(jointMessage(group, setpoints, found->second.type), found->second.type);
    if (!cdr) return cdr.error();
    return found->second.publisher->write(*cdr);
}

Result<void> RobotLine::goTo(const PoseSample& goal) {
    if (m_navigation && m_navigation->view().offered) return m_navigation->go(goal);
    if (m_navigation && !m_commands.contains(StreamRole::GoalPose)) {
        return Error{leitstand::fill(translate("leitstand::Error", "{}: nobody offers its navigation {}"),
                                     m_robot.name, m_robot.navigation()->name)};
    }
    return publish(StreamRole::GoalPose, goal);
}

void RobotLine::cancelGoal() {
    if (m_navigation) m_navigation->cancel();
}

}  // namespace leitstand
