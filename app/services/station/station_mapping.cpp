#include "app/services/station/station_mapping.h"

#include <algorithm>
#include <chrono>
#include <deque>
#include <map>
#include <mutex>
#include <optional>
#include <set>
#include <utility>
#include <variant>

#include "app/services/log/live_mission.h"
#include "app/services/log/sequencer.h"
#include "app/services/mapping/live_mapping.h"
#include "app/services/mapping/loop_previews.h"
#include "app/services/mapping/mapping_text.h"
#include "app/services/mapping/station_scanners.h"
#include "app/services/places/mission_map.h"
#include "core/base/words.h"
#include "core/event/scan_bodies.h"
#include "core/event/station_topics.h"
#include "core/mapping/live/map/local_map.h"
#include "core/mission/state/decision.h"

namespace leitstand {
namespace {

constexpr std::chrono::seconds HeldBack(10);  ///< for scans, until it is decided who registers

using Undoing = std::optional<UndoSample> (*)(const MissionState&, const std::string&, Time);

}  // namespace

struct StationMapping::State {
    LiveMission& mission;
    const std::function<bool()> mayMap;
    const std::string station;
    const StationMappingListener listener;
    std::deque<Event> heldBack;  ///< waiting scans; of the mission's thread
    MapPtr shown;                ///< last; of the mapping's thread
    mutable std::mutex mutex;    ///< guards the following
    LiveMapPtr scans = std::make_shared<const LiveMap>();
    std::set<std::string> robots;  ///< names; fixed
    LoopPreviews previews;
    MapLog log;
    StationScanners scanners;
    std::unique_ptr<LiveMapping> mapping;  ///< last: its thread ends first

    State(LiveMission& recorded, std::function<bool()> may, const StationMappingSetup& setup,
          StationMappingListener listening)
        : mission(recorded),
          mayMap(std::move(may)),
          station(setup.station),
          listener(std::move(listening)),
          log(recorded, logSetup(setup)),
          scanners(
              setup.robots, setup.mission,
              {[this] { return granted(); }, [this](const std::string& robot) { return log.titleOf(robot); },
               [this](const std::string& text) { notify(text); }}) {
        for (const RobotDescription& robot : setup.robots) robots.insert(robot.name);
    }

    [[nodiscard]] MapLogSetup logSetup(const StationMappingSetup& setup) const {
        MapLogSetup kept;
        kept.station = setup.station;
        for (const RobotDescription& robot : setup.robots) kept.titles[robot.name] = robot.title;
        kept.usualCrop = setup.settings.crop;
        kept.notify = [this](const std::string& text) { notify(text); };
        return kept;
    }
    void notify(const std::string& text) const {
        if (listener.onMessage) listener.onMessage(text);
    }
    void show(const LiveMapPtr& map);
    [[nodiscard]] Result<void> known(std::uint64_t scan) const;
    [[nodiscard]] Result<void> granted() const;
    void decide(std::function<Result<ScanPosesSample>(LiveMapper&, Time)> what);
    [[nodiscard]] Result<void> placeable(const std::string& robot) const;
    /// Returns the newest scan of @p robot as it would lie with the robot at @p baseInMap. Empty unless that
    /// is in another part of the map than the robot surely is.
    [[nodiscard]] std::optional<ScanPose> inOtherPart(const std::string& robot, const Pose& baseInMap) const;
    [[nodiscard]] Result<void> takeBack(Undoing undoing, const std::string& nothing);
};

void StationMapping::State::show(const LiveMapPtr& map) {
    {
        const std::lock_guard lock(mutex);
        scans = map;
    }
    if (listener.onScans) listener.onScans(map);
    if (!listener.onMap) return;
    shown = shownMap(*map, shown);
    listener.onMap(shown);
}

Result<void> StationMapping::State::granted() const {
    if (mayMap()) return {};
    return Error{translate("leitstand::Station",
                           "the map is another station's: ask it for the map, or wait until it is silent")};
}

Result<void> StationMapping::State::known(std::uint64_t id) const {
    if (auto may = granted(); !may) return may;
    const std::lock_guard lock(mutex);
    const bool found = std::any_of(scans->scans.begin(), scans->scans.end(),
                                   [&](const LiveKeyScan& scan) { return scan.id == id; });
    if (found) return {};
    return Error{
        leitstand::fill(translate("leitstand::Station", "key scan {}: expected one of the map"), id)};
}

void StationMapping::State::decide(std::function<Result<ScanPosesSample>(LiveMapper&, Time)> what) {
    mapping->post([this, what = std::move(what)](LiveMapper& mapper) {
        const auto decision = what(mapper, stationTime());
        if (!decision) return notify(decision.error().text);
        if (const auto links = mapper.takeLinks()) log.publishOrNotify(*links, station_topic::ScanLinks);
        log.publishOrNotify(*decision, station_topic::ScanPoses);
    });
}

Result<void> StationMapping::State::takeBack(Undoing undoing, const std::string& nothing) {
    if (auto may = granted(); !may) return may;
    if (log.isSettled() && !undoing(*mission.state(), station, stationTime())) return Error{nothing};
    log.whenSettled([this, undoing, nothing](LiveMapper&) {
        const auto undo = undoing(*mission.state(), station, stationTime());
        if (undo) {
            log.publishOrNotify(*undo, station_topic::Undo);
        } else {
            notify(nothing);
        }
    });
    return {};
}

StationMapping::StationMapping(LiveMission& mission, std::function<bool()> mayMap, StationMappingSetup setup,
                               StationMappingListener listener)
    : m_state(std::make_unique<State>(mission, std::move(mayMap), setup, std::move(listener))) {
    State& state = *m_state;
    setup.settings.crop = state.log.crop();
    LiveMappingListener listening;
    listening.onUpdate = [&state](const MapUpdate& update) { state.log.publish(update); };
    listening.onLoop = [&state](const ScanLinksSample& loop) { state.log.publishLoop(loop); };
    listening.onSettled = [&state](const Settled& settled) { state.log.publish(settled); };
    listening.onBodies = [&state](const ScanBodiesSample& bodies) { state.log.publish(bodies); };
    listening.onLookedFor = [&state](const std::string& robot, std::size_t alike) {
        state.notify(mapping_words::lookedFor(state.log.titleOf(robot), alike));
    };
    state.scanners.listen(listening);
    listening.makesMap = [&state] { return state.mayMap(); };
    listening.onPlace = [&state](const RobotPlaceSample& place) { state.log.publish(place); };
    listening.onMap = [&state](const LiveMapPtr& map) { state.show(map); };
    const MissionStatePtr before = mission.state();
    EarlierMap earlier{std::move(setup.earlier), posesOf(*before)};
    earlier.links = std::move(setup.earlierLinks);
    earlier.loops = loopsOf(*before);
    earlier.bodies = *before->bodies;
    const bool byHand = setup.station.starts_with(MapByHandStation);
    earlier.asRecorded = byHand;
    earlier.shared =
        !byHand &&
        std::any_of(before->decisions->begin(), before->decisions->end(), [&](const Decision& one) {
            const auto* poses = std::get_if<ScanPosesSample>(&one.content);
            return poses != nullptr && poses->station != setup.station && poses->station != TidyingStation &&
                   poses->station != CarriedStation && !poses->station.starts_with(MapByHandStation);
        });
    for (const auto& [name, robot] : before->robots) {
        // A robot that was looked for in vain has no place: it was a guess.
        const bool vain = robot->place && robot->place->sample.cause == RobotPlaceSample::Cause::Slot &&
                          !robot->place->sample.certain;
        if (robot->place && !vain) earlier.places.emplace(name, robot->place->sample);
    }
    state.mapping = std::make_unique<LiveMapping>(setup.robots, setup.station, setup.settings,
                                                  std::move(listening), earlier);
    state.scanners.attach(*state.mapping);
    state.log.follow(*state.mapping);
}

StationMapping::~StationMapping() = default;

void StationMapping::close() {
    m_state->mapping->close();
}

void StationMapping::whenCalm(std::function<void()> done) {
    m_state->mapping->whenCalm(std::move(done));
}

bool StationMapping::makesMap() const {
    return m_state->mayMap();
}

void StationMapping::onEvent(const Event& event) {
    State& state = *m_state;
    if (event.robot.empty()) return state.log.onEvent(event);
    // How robots move, and where their sensors are, must be known before the scans.
    const bool scan = event.sample.is<CloudSample>(), laser = event.sample.is<RangesSample>();
    if (laser && !state.mayMap()) return;
    if (!scan) return state.mapping->onEvent(event);
    auto& waiting = state.heldBack;
    if (state.mayMap()) {
        for (const Event& one : std::exchange(waiting, {})) state.mapping->onEvent(one);
        return state.mapping->onEvent(event);
    }
    state.mapping->scanReceived(event.robot, event.received);
    waiting.push_back(event);
    while (event.received - waiting.front().received > HeldBack) waiting.pop_front();
}

Result<void> StationMapping::accept(std::uint64_t scan) {
    if (auto may = m_state->known(scan); !may) return may;
    m_state->decide([scan](LiveMapper& mapper, Time now) { return mapper.accept(scan, now); });
    return {};
}

Result<void> StationMapping::reject(std::uint64_t scan) {
    if (auto may = m_state->known(scan); !may) return may;
    m_state->decide([scan](LiveMapper& mapper, Time now) { return mapper.reject(scan, now); });
    return {};
}

Result<void> StationMapping::retry(std::uint64_t scan, const RetrySettings& settings) {
    if (auto may = m_state->known(scan); !may) return may;
    m_state->decide(
        [scan, settings](LiveMapper& mapper, Time now) { return mapper.retry(scan, settings, now); });
    return {};
}

Result<void> StationMapping::rewind(Time moment) {
    if (auto may = m_state->granted(); !may) return may;
    const LiveMapPtr map = scans();
    const bool any = std::any_of(map->scans.begin(), map->scans.end(), [&](const LiveKeyScan& scan) {
        return scan.entered > moment && scan.pose.trust != ScanTrust::SetAside;
    });
    if (!any)
        return Error{translate("leitstand::Station", "rewind: no scan entered the map after that moment")};
    m_state->decide([moment](LiveMapper& mapper, Time now) { return mapper.rewind(moment, now); });
    return {};
}

Result<void> StationMapping::undo() {
    return m_state->takeBack(
        &undoOnMap,
        translate("leitstand::Station", "nothing to be taken back: no decision on the map stands"));
}

Result<void> StationMapping::redo() {
    return m_state->takeBack(
        &redoOnMap, translate("leitstand::Station", "nothing to be done again: nothing was taken back last"));
}

Result<void> StationMapping::propose(std::uint64_t scan, const Pose& scanInMap) {
    if (auto may = m_state->known(scan); !may) return may;
    m_state->mapping->post([&state = *m_state, scan, scanInMap](LiveMapper& mapper) {
        const auto loop = mapper.propose(scan, scanInMap, stationTime());
        if (!loop) return state.notify(loop.error().text);
        state.log.publishOrNotify(*loop, station_topic::ScanLinks);
    });
    return {};
}

Result<void> StationMapping::moveTo(std::uint64_t scan, SubmapKind kind, const Pose& scanInMap,
                                    std::function<void(Result<std::size_t>)> done) {
    if (auto may = m_state->known(scan); !may) return may;
    m_state->mapping->post(
        [&state = *m_state, scan, kind, scanInMap, done = std::move(done)](LiveMapper& mapper) {
            if (const auto may = state.granted(); !may) return done(may.error());
            const auto links = mapper.moveTo(scan, kind, scanInMap, stationTime());
            if (!links) return done(links.error());
            state.log.publishOrNotify(*links, station_topic::ScanLinks);
            state.log.movedByHand();
            done(links->links.size());
        });
    return {};
}

Result<void> StationMapping::answerLoop(const OpenLoop& asked, bool same) {
    if (auto may = m_state->granted(); !may) return may;
    const auto open = openLoop(*m_state->mission.state());
    if (!open) return Error{translate("leitstand::Station", "nothing is asked about the map")};
    if (open->event != asked.event)
        return Error{
            translate("leitstand::Station", "the map asks about another place by now: look at it again")};
    const ScanLinksSample answer = answerTo(*open, same, m_state->station, stationTime());
    if (auto kept = m_state->log.publish(answer, station_topic::ScanLinks); !kept) return kept;
    m_state->mapping->adopt(answer);
    return {};
}

LoopPreviewPtr StationMapping::preview(const OpenLoop& asked) {
    const MissionStatePtr mission = m_state->mission.state();
    const std::uint64_t newest = mission->decisions->empty() ? 0 : mission->decisions->back().sequence;
    return m_state->previews.of(asked, newest, *m_state->mapping);
}

Result<void> StationMapping::undoLoop() {
    return m_state->takeBack(&leitstand::undoLoop,
                             translate("leitstand::Station", "nothing to be taken back: no loop closed"));
}

std::optional<MapDecision> StationMapping::loop() const {
    return lastLoop(*m_state->mission.state());
}

ClosedLoops StationMapping::closedLoops() const {
    return m_state->log.closedLoops();
}

std::optional<MapDecision> StationMapping::undoable() const {
    return leitstand::undoable(*m_state->mission.state(), m_state->station);
}

std::optional<MapDecision> StationMapping::redoable() const {
    return leitstand::redoable(*m_state->mission.state(), m_state->station);
}

Result<void> StationMapping::takeBack(const UndoSample& undo) {
    return m_state->log.publish(undo, station_topic::Undo);
}

Result<void> StationMapping::setCrop(const MapCrop& crop) {
    if (auto may = m_state->granted(); !may) return may;
    return m_state->log.setCrop(crop, stationTime());
}

MapCrop StationMapping::crop() const {
    return m_state->log.crop();
}

Result<void> StationMapping::State::placeable(const std::string& robot) const {
    if (auto may = granted(); !may) return may;
    if (!robots.contains(robot))
        return Error{leitstand::fill(
            translate("leitstand::Station", "\"{}\" is none of the station's robots"), robot)};
    const std::lock_guard lock(mutex);
    if (scans->scans.empty())
        return Error{translate("leitstand::Station", "there is no map yet to put a robot into")};
    return {};
}

std::optional<ScanPose> StationMapping::State::inOtherPart(const std::string& robot,
                                                           const Pose& baseInMap) const {
    const RobotsInMapPtr placed = mapping->robots();
    const auto now = std::find_if(placed->begin(), placed->end(),
                                  [&](const RobotInMap& one) { return one.robot == robot; });
    const std::lock_guard lock(mutex);
    const auto newest =
        std::find_if(scans->scans.rbegin(), scans->scans.rend(),
                     [&](const LiveKeyScan& scan) { return scan.counts() && scan.scan->robot == robot; });
    // For a robot at an uncertain place that scan proves nothing: the robot may have been carried.
    const bool sure = now != placed->end() && now->certain;
    if (!sure || newest == scans->scans.rend() || newest->part == partAt(scans->scans, baseInMap))
        return std::nullopt;
    ScanPose shown = newest->pose;
    shown.scanInMap = baseInMap * now->baseInMap.inverse() * newest->pose.scanInMap;
    return shown;
}

Result<void> StationMapping::place(const std::string& robot, const Pose& baseInMap) {
    if (auto may = m_state->placeable(robot); !may) return may;
    if (const auto shown = m_state->inOtherPart(robot, baseInMap))
        return propose(shown->scan, shown->scanInMap);
    m_state->mapping->place(robot, baseInMap);
    return {};
}

Result<void> StationMapping::lookFor(const std::string& robot) {
    if (auto may = m_state->placeable(robot); !may) return may;
    m_state->mapping->lookFor(robot);
    return {};
}

StationScanners& StationMapping::scanners() const {
    return m_state->scanners;
}

LiveMapPtr StationMapping::scans() const {
    const std::lock_guard lock(m_state->mutex);
    return m_state->scans;
}

RobotsInMapPtr StationMapping::robots() const {
    return m_state->mapping->robots();
}

}  // namespace leitstand
