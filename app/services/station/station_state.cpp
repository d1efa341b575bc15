#include "app/services/station/station_state.h"

#include <algorithm>
#include <array>
#include <filesystem>
#include <utility>

#include <fmt/format.h>

#include "app/services/log/link_line.h"
#include "app/services/log/mission_robots.h"
#include "app/services/log/sequencer.h"
#include "app/services/places/mission_map.h"
#include "core/base/words.h"
#include "core/event/motion_samples.h"
#include "core/event/station_topics.h"
#include "core/event/stream_role.h"
#include "core/io/page_file.h"
#include "core/io/settings/alarm_file.h"
#include "core/mission/state/session_state.h"
#include "core/station/preflight/brake_format.h"
#include "transport/domain/join_settings.h"
#include "transport/link/grant_sender.h"
#include "transport/link/guard_arguments.h"

namespace leitstand {
Station::State::~State() {
    {
        const std::lock_guard lock(mutex);
        open = false;
    }
    if (node) node->onDiscovery([] {});
    for (const auto& [name, line] : lines) {
        if (line->drive() != nullptr) line->drive()->setFocus(false);  // robots stand, whatever the disk does
    }
    if (joints) joints->end();
    if (cameras) cameras->snapshots().finish();  // they are noted in the log
    if (finds) finds->finish();                  // the log has to have what the operator saw
    // Waiting events still go into the log; their effect on the map is dropped.
    services.close();
    reception.reset();  // the alarms used it
    if (feed) feed->end();
    clock.reset();
    mission.reset();  // its thread uses the lines and passes events on to the mapping
    mapping.reset();
    victims.reset();
    coverage.reset();
    finds.reset();
    cameras.reset();
    joints.reset();
    alarms.reset();
    sharing.reset();
    intake.reset();
    lines.clear();
    guards.reset();  // their thread uses the lines; they learn that nobody drives
    streams.reset();
    brakes.reset();
    stops.reset();
    grants.reset();
    presence.reset();
    rosNodes.reset();
    topicWatch.reset();
    modelWatch.reset();
    node.reset();
}

void Station::State::refresh(const std::string& robot) {
    const std::lock_guard lock(mutex);
    if (!open) return;
    for (const auto& [name, line] : lines) {
        if ((robot.empty() || name == robot) && line->drive() != nullptr) line->drive()->refresh();
    }
}

void Station::State::map(std::vector<KeyScanSample> earlier, std::vector<ScanLinksSample> links) {
    StationMappingListener listening;
    listening.onMessage = [this](const std::string& text) { notify(text); };
    listening.onMap = listener.onMap;
    listening.onScans = listener.onScans;
    // When there can be no such file there can be no log either, which is reported.
    if (auto pages = PageFile::open(settings.mission.folder))
        settings.mapping.pages = std::move(pages).value();
    mapping = std::make_unique<StationMapping>(
        *mission, [this] { return grants->mayAct(MapGrant); },
        StationMappingSetup{settings.mission.robots, memory->identity().id, settings.mapping,
                            std::move(earlier), std::move(links), settings.mission.folder},
        std::move(listening));
    grants->requestGrant(MapGrant);
}

void Station::State::watch() {
    StationAlarmsSetup setup;
    setup.robots = settings.mission.robots;
    setup.station = memory->identity().id;
    const auto limits = readAlarmLimits(settings.alarms);
    if (limits)
        setup.limits = *limits;
    else
        notify(limits.error().text);  // the usual ones are used then
    setup.view = [this](const std::string& robot) { return view(robot); };
    setup.mission = [this] { return mission->state(); };
    setup.scans = [this] { return mapping->scans(); };
    setup.places = [this] { return mapping->robots(); };
    setup.onLog = [this](const AlarmSample& alarm) {
        if (const auto kept = mission->record(alarm, station_topic::Alarms); !kept) notify(kept.error().text);
    };
    alarms = std::make_unique<StationAlarms>(std::move(setup));
}

void Station::State::share() {
    SharedIntakeSetup intakeSetup;
    intakeSetup.me = senderOf(node->guid());
    intakeSetup.mission = [this] { return mission->state(); };
    intakeSetup.holdsMap = [this] { return grants->mayAct(MapGrant); };
    intakeSetup.enter = [this](RawEvent event) { mission->receive(std::move(event)); };
    intakeSetup.notify = [this](const std::string& text) { notify(text); };
    intakeSetup.station = memory->identity().id;
    intakeSetup.onJoined = [this] {
        if (open) sharing->publishFindsAgain();
    };
    intakeSetup.fileAgain = [this](const FindSample& find) { fileAgain(find); };
    MissionSharingSetup sharingSetup;
    sharingSetup.station = memory->identity().id;
    sharingSetup.folder = settings.mission.folder;
    sharingSetup.holdsMap = intakeSetup.holdsMap;
    sharingSetup.notify = intakeSetup.notify;
    sharingSetup.robots = [this] { return mapping->robots(); };
    intake = std::make_unique<SharedIntake>(std::move(intakeSetup));
    sharingSetup.sharesMap = [this] { return intake->sharesMap(); };
    sharingSetup.isAdopted = [this](std::uint64_t scan) { return intake->isAdopted(scan); };
    sharing = std::make_unique<MissionSharing>(*node, *mission, std::move(sharingSetup));
}

void Station::State::follow() {
    const auto all = std::to_array<EventSink*>({brakes.get(), alarms.get(), mapping.get(), victims.get(),
                                                coverage.get(), finds.get(), joints.get(), &frames,
                                                &cameras->turning(), intake.get(), sharing.get()});
    for (EventSink* const service : all) services.add(*service);
}

void Station::State::listen() {
    feed = std::make_unique<MissionFeed>(*node, *mission, [this](const ReceivedSample& sample) {
        for (const auto& [name, line] : lines) line->link().onSample(sample);
    });
    for (const RobotDescription& robot : settings.mission.robots) {
        for (const auto& problem : feed->listenTo(robot, MissionFeed::Commands::Received)) notify(problem);
    }
    const auto gate = [this](ReceivedSample sample) {
        const SteadyTime now = std::chrono::steady_clock::now();
        intake->take(std::move(sample.event), senderOf(sample.writer), now);
    };
    for (const auto& problem : feed->listenToStations(gate)) notify(problem);
    node->onDiscovery([this] {
        notifyMismatches();
        notifyDrops();
        sharing->look();
    });
}

bool Station::State::isAtRest() const {
    return std::none_of(lines.begin(), lines.end(), [this](const auto& one) {
        const auto& [name, line] = one;
        const StopStatus stop = stops->status(name);
        if (stop.releasing || (stop.sent && !stop.standing)) return true;
        if (brakes->isRunning(name) || joints->isMoving(name)) return true;
        if (line->drive() == nullptr) return false;
        const DriveStatus drive = line->drive()->status();
        return drive.driving || drive.velocity != DriveVelocity{};
    });
}

void Station::State::watchReception() {
    ReceptionWatchSetup setup;
    setup.robots = settings.mission.robots;
    setup.link = [this](const std::string& robot) { return lines.at(robot)->link().status().state; };
    setup.mayRejoin = [this] { return isAtRest(); };
    setup.onRejoining = [this](const Guid& me) {
        grants->rejoined(me);
        intake->rejoined(senderOf(me));
    };
    setup.notify = [this](const std::string& text) { notify(text); };
    reception = std::make_unique<ReceptionWatch>(*node, std::move(setup));
}

void Station::State::notifyMismatches() {
    for (const Mismatch& mismatch : node->mismatches()) {
        {
            const std::lock_guard lock(mutex);
            if (!reported.insert(toString(mismatch.complaint)).second) continue;
        }
        notify(worded(mismatch.complaint));
    }
}

void Station::State::notifyDrops() {
    std::vector<ScreenDrop> due;
    {
        const std::lock_guard lock(mutex);
        due = screened.due(node->dropped());
    }
    for (const ScreenDrop& drop : due) notify(worded(drop));
}

void Station::State::watchStreams() {
    streams = std::make_unique<StationStreams>(
        settings.mission.robots,
        [this](const std::string& robot, StreamCommandSample command) {
            command.stamp = stationTime();
            command.station = memory->identity().id;
            return request(robot, StreamRole::StreamCommand, command);
        },
        [this](const std::string& robot, const std::string& topic, bool off) {
            line(robot)->link().setPaused(topic, off);
        });
}

Result<void> Station::State::start() {
    auto network = nodeSettings(settings.domain, "leitstand");
    if (!network) return network.error();
    auto remembered = StationFile::open(settings.memory, settings.mission.title);
    if (!remembered) return remembered.error();
    memory = std::move(remembered).value();
    if (!memory->warning().empty()) notify(memory->warning());
    settings.mission.station = memory->identity().id;
    auto joined = Node::create(*network);
    if (!joined) return joined.error();
    node = std::move(joined).value();
    topicWatch.emplace(*node);
    modelWatch.emplace(*node);
    rosNodes.emplace(*node);
    presence.emplace(*node, rosNodes->nodes(), "/leitstand");
    for (const std::string& warning : node->warnings()) notify(warning);
    LiveMission::Listener log;
    log.onAlarm = [this](const std::string& text) { notify(text); };
    log.onEvent = [this](const Event& event) {
        if (!open) return;
        if (RobotLine* const known = line(event.robot)) known->sight().onEvent(event);
        services.onEvent(event);
        if (listener.onEvent) listener.onEvent(event);
    };
    std::vector<KeyScanSample> earlier = keyScansOf(settings.mission.folder);
    std::vector<ScanLinksSample> links = scanLinksOf(settings.mission.folder);
    carryMapping(settings.mission.folder, settings.mission.robots);
    auto recorded = LiveMission::open(settings.mission, std::move(log));
    if (!recorded) return recorded.error();
    mission = std::move(recorded).value();
    if (auto controlled = control(); !controlled) return controlled;
    watchStreams();
    watchBrakes();
    guardRobots();
    for (const RobotDescription& robot : settings.mission.robots) {
        if (auto made = lineTo(robot); !made) return made;
    }
    moveJoints();
    cameras = std::make_unique<StationCameras>(
        settings.mission, *grants,
        [this](const std::string& robot, const PanTiltCommand& command) {
            return request(robot, StreamRole::PanTiltCommand, command);
        },
        [this](const NoteSample& note) { return mission->record(note, station_topic::Notes); },
        [this](const std::string& text) { notify(text); });
    cover(earlier);
    map(std::move(earlier), std::move(links));
    search();
    file();
    watch();
    clock = std::make_unique<StationClock>(*mission, memory->identity().id, [this](const ClockSample& now) {
        sharing->publish(now, station_topic::Clock);
    });
    share();
    watchReception();
    follow();
    {
        const std::lock_guard lock(mutex);
        open = true;
    }
    refresh({});
    listen();
    return {};
}

RobotView Station::State::view(const std::string& name) const {
    const RobotLine* const known = line(name);
    if (known == nullptr) return {};
    RobotView view;
    known->fillView(view);
    if (open && reception) view.reception = reception->fault(name);
    view.grant = grants->view(driveGrant(name));
    view.stop = stops->status(name);
    return view;
}

Result<void> Station::State::request(const std::string& robot, StreamRole role, const Sample& sample) const {
    RobotLine* const to = line(robot);
    if (to == nullptr)
        return Error{leitstand::fill(
            translate("leitstand::Station", "\"{}\" is none of the station's robots"), robot)};
    return to->publish(role, sample);
}

}  // namespace leitstand
