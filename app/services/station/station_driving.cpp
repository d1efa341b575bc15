#include <filesystem>
#include <string>
#include <utility>

#include "app/services/log/link_line.h"
#include "app/services/log/sequencer.h"
#include "app/services/station/station_state.h"
#include "core/base/words.h"
#include "core/event/station_topics.h"
#include "core/station/preflight/brake_format.h"
#include "transport/domain/join_settings.h"
#include "transport/link/grant_sender.h"
#include "transport/link/guard_arguments.h"

// The parts of a station that move robots, and that keep them from moving.

namespace leitstand {

Result<void> Station::State::control() {
    GrantListener held;
    held.onChange = [this] {
        refresh({});
        const std::lock_guard lock(mutex);
        if (open) sharing->look();
    };
    held.onHeld = [this](const std::vector<HeldGrant>& now) {
        if (const auto kept = memory->remember(now); !kept) notify(kept.error().text);
    };
    auto keeper = GrantKeeper::create(*node, memory->identity(), std::move(held));
    if (!keeper) return keeper.error();
    grants = std::move(keeper).value();
    StopSenderSettings stopping;
    stopping.station = memory->identity().id;
    stopping.mayRelease = [this](const std::string& robot) { return grants->mayAct(driveGrant(robot)); };
    stopping.onChange = [this](const std::string& robot) { refresh(robot); };
    auto sender = StopSender::create(*node, settings.mission.robots, std::move(stopping));
    if (!sender) return sender.error();
    stops = std::move(sender).value();
    return {};
}

bool Station::State::mayMove(const std::string& robot) const {
    return grants->mayAct(driveGrant(robot)) && stops->allowsDriving(robot) && !brakes->refuses(robot) &&
           guards->allows(robot);
}

void Station::State::moveJoints() {
    JointMoving::Wire wire;
    wire.conditions = [this](const std::string& robot) {
        JointConditions now;
        now.heard = lines.at(robot)->link().status().state != LinkState::Lost;
        now.mayMove = mayMove(robot) && now.heard && !brakes->isRunning(robot);
        now.hold = stops->holdsByZeros(robot);
        return now;
    };
    wire.send = [this](const std::string& robot, const JointGroup& group, const JointSetpoints& setpoints) {
        return lines.at(robot)->moveJoints(group, setpoints);
    };
    wire.notify = [this](const std::string& text) { notify(text); };
    joints = std::make_unique<JointMoving>(settings.mission.robots, std::move(wire));
}

Result<void> Station::State::lineTo(const RobotDescription& robot) {
    const auto conditions = [this, name = robot.name] {
        return DriveConditions{mayMove(name), stops->holdsByZeros(name), brakes->silences(name)};
    };
    const auto pulse = [this, name = robot.name](const GuardPulse& now) { guards->pulse(name, now); };
    LinkListener watch;
    watch.onStatus = [this](const LinkStatus& link) {
        if (!open) return;
        streams->take(link);
        brakes->look(link.robot);
    };
    watch.onState = [this, title = robot.title](const LinkStatus& link) {
        notify(fmt::format("{}: {}", title, linkStateWords(link.state)));
    };
    watch.onClockOffset = [this](const ClockOffsetSample& offset) {
        const std::lock_guard lock(mutex);
        if (open)
            (void)mission->record(offset, station_topic::ClockOffsets);  // a plain sample can be encoded
    };
    const auto called = [this, title = robot.title](const RobotCalls::Outcome& outcome) {
        notify(title + ": " + worded(outcome));
    };
    auto line = RobotLine::create(*node, robot, memory->identity().id, {conditions, pulse},
                                  {std::move(watch), called});
    if (!line) return line.error();
    for (const std::string& problem : (*line)->problems()) notify(robot.title + ": " + problem);
    lines.emplace(robot.name, std::move(line).value());
    return {};
}

void Station::State::watchBrakes() {
    StationBrakes::Hands hands = brakeHands(lines, *grants, *stops);
    hands.focus = [this](const std::string& robot, bool on) {
        if (on) {
            giveSticks(lines, robot);
            grants->requestGrant(driveGrant(robot));
        } else if (DriveStreamer* const drive = lines.at(robot)->drive()) {
            drive->setFocus(false);  // others may be driven by now
        }
    };
    hands.refresh = [this](const std::string& robot) {
        guards->want(robot, brakes->needsGuard(robot));
        refresh(robot);
    };
    hands.done = [this](const std::string& robot, const BrakeResult& result, const Result<void>& kept) {
        if (!kept) notify(kept.error().text);
        const NoteSample note{stationTime(), memory->identity().id, robot, toString(result)};
        const RobotDescription& described = lines.at(robot)->robot();
        notify(described.title + ": " + brakeWorded(note.text));
        const std::lock_guard lock(mutex);
        if (open) (void)mission->record(note, station_topic::Notes);  // a plain sample can be encoded
    };
    const std::filesystem::path file = settings.memory.parent_path() / "brakes.yaml";
    brakes = std::make_unique<StationBrakes>(settings.mission.robots, file, std::move(hands));
}

void Station::State::guardRobots() {
    StationGuards::Setup setup;
    setup.program = guardProgram();
    for (const RobotDescription& robot : settings.mission.robots) {
        const auto message = driveMessageFor(robot);
        if (!message) continue;  // it is not driven
        GuardArguments arguments;
        arguments.network.domain = settings.domain.domain;
        arguments.network.interfaces = settings.domain.interfaces;
        arguments.network.initialPeers = settings.domain.initialPeers;
        arguments.network.multicast = settings.domain.multicast;
        arguments.network.discoveryServer = settings.domain.discoveryServer;
        if (isSecured(settings.domain)) arguments.keys = settings.domain.keys;
        arguments.guard.robot = robot.name;
        arguments.guard.station = memory->identity().id;
        arguments.guard.driver = senderOf(node->guid());
        arguments.guard.message = *message;
        setup.words.emplace(robot.name, wordsOf(arguments));
    }
    setup.onChange = [this](const std::string& robot) { refresh(robot); };
    setup.onTrouble = [this](const std::string& robot, const std::string& problem) {
        for (const RobotDescription& one : settings.mission.robots) {
            if (one.name != robot) continue;
            notify(leitstand::fill(translate("leitstand::Station", "{} has no guard and is not driven: {}"),
                                   one.title, problem));
        }
    };
    guards = std::make_unique<StationGuards>(std::move(setup));
}

}  // namespace leitstand
