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

#include <fmt/format.h>

#include "app/services/log/live_mission.h"
#include "app/services/log/sequencer.h"
#include "app/services/mapping/live_mapping.h"
#include "app/services/mapping/loop_previews.h"
#include "app/services/mapping/mapping_words.h"
#include "app/services/places/mission_map.h"
#include "core/base/words.h"
#include "core/event/station_topics.h"
#include "core/mapping/live/map/local_map.h"

namespace leitstand {
namespace {

constexpr std::chrono::seconds HeldBack(10);  ///< scans, until it is decided who registers

/// Whether the area @p now lies elsewhere than @p before: less than so much is not worth cutting all scans
/// anew.
bool moved(const MapCrop& before, const MapCrop& now) {
    constexpr double Noticed = 0.03;  // [m]
    const auto same = [](const Eigen::Vector2d& a, const Eigen::Vector2d& b) {
        return (a - b).norm() < Noticed;
    };
    return before.ceiling != now.ceiling || !std::equal(before.polygon.begin(), before.polygon.end(),
                                                        now.polygon.begin(), now.polygon.end(), same);
}

using Undoing = std::optional<UndoSample> (*)(const MissionState&, const std::string&, Time);

}  // namespace

struct StationMapping::State {
    LiveMission& mission;
    const std::function<bool()> mayMap;
    const std::string station;
    const StationMappingListener listener;
    std::deque<Event> heldBack;           ///< scans; of the mission's thread
    MapPtr shown;                         ///< last; of the mapping's thread
    bool loopClosed = false;              ///< poses that follow it are not told yet; of the mapping's thread
    bool closedByItself = false;          ///< likewise, and nobody decided it
    std::map<std::string, bool> certain;  ///< whether a robot's place was; of the mapping's thread
    mutable std::mutex mutex;             ///< of the following
    LiveMapPtr scans = std::make_shared<const LiveMap>();
    MapCrop crop;       ///< as it was wished last
    MapCrop usualCrop;  ///< while the mission says nothing about it; fixed
    ClosedLoops closed;
    /// Of the poses, areas and undos that we said, how much came back from the log: only then the mission has
    /// all of it.
    std::uint64_t said = 0, heard = 0;
    std::set<std::uint64_t> registered;  ///< key scans that we said and that did not come back yet
    bool cropMoved = false;              ///< the mapping does not know the log's area yet; under the mutex
    std::deque<std::function<void(LiveMapper&)>> settled;  ///< to be done then, on the mapping's thread
    std::map<std::string, std::string> titles;             ///< by robot; fixed
    LoopPreviews previews;
    ScannerAdvice scanners;
    std::unique_ptr<LiveMapping> mapping;  ///< last: its thread ends first

    State(LiveMission& log, std::function<bool()> may, const StationMappingSetup& setup,
          StationMappingListener told)
        : mission(log),
          mayMap(std::move(may)),
          station(setup.station),
          listener(std::move(told)),
          scanners(setup.robots, setup.mission) {}

    void tell(const std::string& text) const {
        if (listener.onMessage) listener.onMessage(text);
    }
    void show(const LiveMapPtr& map);
    Result<void> say(const Sample& sample, std::string_view topic);
    void sayOrTell(const Sample& sample, std::string_view topic) {
        if (const auto kept = say(sample, topic); !kept) tell(kept.error().text);
    }
    void log(const MapUpdate& update);
    void logLoop(const ScanLinksSample& loop);
    void log(const Settled& settled);
    void log(const RobotPlaceSample& place);
    void hear(const Event& event);
    void hear(const KeyScanSample& scan);
    [[nodiscard]] MapCrop cropInLog() const;
    [[nodiscard]] const std::string& titleOf(const std::string& robot) const {
        const auto found = titles.find(robot);
        return found == titles.end() || found->second.empty() ? robot : found->second;
    }
    void whenSettled(std::function<void(LiveMapper&)> task, bool first = false);
    void settle(LiveMapper& mapper);
    [[nodiscard]] Result<void> known(std::uint64_t scan) const;
    [[nodiscard]] Result<void> granted() const;
    void decide(std::function<Result<ScanPosesSample>(LiveMapper&, Time)> what);
    [[nodiscard]] Result<void> placeable(const std::string& robot) const;
    /// The newest scan of @p robot as it would lie with the robot at @p baseInMap, where that is in another
    /// part of the map than the one it is surely in; empty: it is not.
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

Result<void> StationMapping::State::say(const Sample& sample, std::string_view topic) {
    {
        const std::lock_guard lock(mutex);
        ++said;  // first: it may come back at once
    }
    auto kept = mission.say(sample, topic);
    if (kept) return kept;
    const std::lock_guard lock(mutex);
    ++heard;
    return kept;
}

void StationMapping::State::log(const MapUpdate& update) {
    if (update.keyScan) {
        {
            const std::lock_guard lock(mutex);
            registered.insert(update.keyScan->id);
        }
        if (const auto kept = mission.say(*update.keyScan, station_topic::KeyScans); !kept)
            tell(kept.error().text);
    }
    if (update.links) sayOrTell(*update.links, station_topic::ScanLinks);
    if (update.poses) sayOrTell(*update.poses, station_topic::ScanPoses);
    if (update.loop) logLoop(*update.loop);
}

void StationMapping::State::logLoop(const ScanLinksSample& loop) {
    sayOrTell(loop, station_topic::ScanLinks);
    const bool closes = loop.links.front().active;
    loopClosed = loopClosed || closes;
    closedByItself = closedByItself || closes;
    const bool parts = loop.links.front().kind == LinkKind::Session;
    if (!closes) tell(parts ? mapping_words::partsMeet() : mapping_words::question());
}

void StationMapping::State::log(const Settled& settled) {
    if (settled.links) {
        sayOrTell(*settled.links, station_topic::ScanLinks);
        tell(mapping_words::contradicted());
    }
    if (settled.poses) sayOrTell(*settled.poses, station_topic::ScanPoses);
    const bool byItself = std::exchange(closedByItself, false);
    if (!std::exchange(loopClosed, false) || settled.links) return;
    if (byItself) {
        const std::lock_guard lock(mutex);
        closed = {closed.count + 1, settled.largest};
    }
    tell(mapping_words::met(settled.largest));
}

void StationMapping::State::log(const RobotPlaceSample& place) {
    if (const auto kept = mission.say(place, station_topic::RobotPlaces); !kept) tell(kept.error().text);
    const bool before = std::exchange(certain[place.robot], place.certain);
    if (place.cause == RobotPlaceSample::Cause::Tracked && before == place.certain) return;
    tell(mapping_words::place(titleOf(place.robot), place));
}

void StationMapping::State::whenSettled(std::function<void(LiveMapper&)> task, bool first) {
    const std::lock_guard lock(mutex);
    first ? settled.push_front(std::move(task)) : settled.push_back(std::move(task));
}

void StationMapping::State::settle(LiveMapper& mapper) {
    while (true) {
        std::function<void(LiveMapper&)> next;
        {
            const std::lock_guard lock(mutex);
            if (settled.empty() || heard < said) return;
            next = std::move(settled.front());
            settled.pop_front();
        }
        next(mapper);
    }
}

void StationMapping::State::hear(const KeyScanSample& scan) {
    {
        const std::lock_guard lock(mutex);
        if (registered.erase(scan.id) != 0) return;
    }
    mapping->adopt(scan);
}

void StationMapping::State::hear(const Event& event) {
    if (std::holds_alternative<ClockOffsetSample>(event.sample)) return mapping->onEvent(event);
    if (const auto* scan = std::get_if<KeyScanSample>(&event.sample)) return hear(*scan);
    if (const auto* place = std::get_if<RobotPlaceSample>(&event.sample)) {
        if (place->station != station) mapping->follow(*place);
        return;
    }
    if (const auto* bodies = std::get_if<ScanBodiesSample>(&event.sample)) {
        if (bodies->station != station) mapping->adopt(*bodies);
        return;
    }
    const auto* links = std::get_if<ScanLinksSample>(&event.sample);
    const auto* poses = std::get_if<ScanPosesSample>(&event.sample);
    const auto* undo = std::get_if<UndoSample>(&event.sample);
    const auto* area = std::get_if<MapCropSample>(&event.sample);
    if (links == nullptr && poses == nullptr && undo == nullptr && area == nullptr) return;
    if (undo != nullptr) {
        whenSettled(
            [this](LiveMapper& mapper) {
                const MissionStatePtr now = mission.state();
                mapper.follow(posesOf(*now));
                mapper.followLoops(loopsOf(*now));
            },
            true);
    }
    // Another station's, which makes the map.
    if (links != nullptr && links->station != station) mapping->adopt(*links);
    if (poses != nullptr && poses->station != station) mapping->follow(posesOf(*mission.state()));
    bool waits = undo != nullptr;
    const std::string& who = links != nullptr   ? links->station
                             : poses != nullptr ? poses->station
                             : undo != nullptr  ? undo->station
                                                : area->station;
    std::optional<MapCrop> changed;
    {
        const std::lock_guard lock(mutex);
        if (who == station) ++heard;
        waits = waits || !settled.empty();
        // What was wished since is on its way.
        cropMoved = cropMoved || undo != nullptr || area != nullptr || poses != nullptr;
        if (cropMoved && heard == said) {
            const MapCrop now = cropInLog();
            if (area != nullptr || undo != nullptr || moved(crop, now)) changed = crop = now;
            cropMoved = false;
        }
    }
    if (changed) mapping->setCrop(*changed);
    if (waits) mapping->post([this](LiveMapper& mapper) { settle(mapper); });
}

MapCrop StationMapping::State::cropInLog() const {
    return cropOf(*mission.state()).value_or(usualCrop);
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
        if (!decision) return tell(decision.error().text);
        if (const auto links = mapper.takeLinks()) sayOrTell(*links, station_topic::ScanLinks);
        sayOrTell(*decision, station_topic::ScanPoses);
    });
}

Result<void> StationMapping::State::takeBack(Undoing undoing, const std::string& nothing) {
    if (auto may = granted(); !may) return may;
    bool calm = false;
    {
        const std::lock_guard lock(mutex);
        calm = heard == said && settled.empty();
    }
    if (calm && !undoing(*mission.state(), station, stationTime())) return Error{nothing};
    mapping->post([this, undoing, nothing](LiveMapper& mapper) {
        whenSettled([this, undoing, nothing](LiveMapper&) {
            const auto undo = undoing(*mission.state(), station, stationTime());
            if (undo) {
                sayOrTell(*undo, station_topic::Undo);
            } else {
                tell(nothing);
            }
        });
        settle(mapper);
    });
    return {};
}

StationMapping::StationMapping(LiveMission& mission, std::function<bool()> mayMap, StationMappingSetup setup,
                               StationMappingListener listener)
    : m_state(std::make_unique<State>(mission, std::move(mayMap), setup, std::move(listener))) {
    State& state = *m_state;
    state.usualCrop = setup.settings.crop;
    setup.settings.crop = state.crop = state.cropInLog();
    LiveMappingListener listening;
    listening.onUpdate = [&state](const MapUpdate& update) { state.log(update); };
    listening.onLoop = [&state](const ScanLinksSample& loop) { state.logLoop(loop); };
    listening.onSettled = [&state](const Settled& settled) { state.log(settled); };
    listening.onBodies = [&state](ScanBodiesSample bodies) {
        bodies.station = state.station;
        if (const auto kept = state.mission.say(bodies, station_topic::ScanBodies); !kept)
            state.tell(kept.error().text);
    };
    listening.onLookedFor = [&state](const std::string& robot, std::size_t alike) {
        state.tell(mapping_words::lookedFor(state.titleOf(robot), alike));
    };
    listening.onScanner = [&state](const std::string& robot, const std::optional<ScannerCorrection>& more) {
        if (state.scanners.follow(robot, more)) state.tell(mapping_words::scannerIsOff(state.titleOf(robot)));
    };
    listening.makesMap = [&state] { return state.mayMap(); };
    listening.onPlace = [&state](const RobotPlaceSample& place) { state.log(place); };
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
        // One that was looked for in vain is nowhere: its place was a guess.
        const bool vain = robot->place && robot->place->sample.cause == RobotPlaceSample::Cause::Slot &&
                          !robot->place->sample.certain;
        if (robot->place && !vain) earlier.places.emplace(name, robot->place->sample);
    }
    for (const RobotDescription& robot : setup.robots) state.titles[robot.name] = robot.title;
    state.mapping = std::make_unique<LiveMapping>(setup.robots, setup.station, setup.settings,
                                                  std::move(listening), earlier);
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
    if (event.robot.empty()) return state.hear(event);
    // How robots move, and where their sensors sit, is known before the scans.
    const bool scan = std::holds_alternative<CloudSample>(event.sample),
               laser = std::holds_alternative<RangesSample>(event.sample);
    if (laser && !state.mayMap()) return;
    if (!scan) return state.mapping->onEvent(event);
    auto& waiting = state.heldBack;
    if (state.mayMap()) {
        for (const Event& one : std::exchange(waiting, {})) state.mapping->onEvent(one);
        return state.mapping->onEvent(event);
    }
    state.mapping->heard(event.robot, event.received);
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
        if (!loop) return state.tell(loop.error().text);
        state.sayOrTell(*loop, station_topic::ScanLinks);
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
            state.sayOrTell(*links, station_topic::ScanLinks);
            state.loopClosed = true;
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
    const ScanLinksSample said = answerTo(*open, same, m_state->station, stationTime());
    if (auto kept = m_state->say(said, station_topic::ScanLinks); !kept) return kept;
    m_state->mapping->adopt(said);
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
    const std::lock_guard lock(m_state->mutex);
    return m_state->closed;
}

std::optional<MapDecision> StationMapping::undoable() const {
    return leitstand::undoable(*m_state->mission.state(), m_state->station);
}

std::optional<MapDecision> StationMapping::redoable() const {
    return leitstand::redoable(*m_state->mission.state(), m_state->station);
}

Result<void> StationMapping::takeBack(const UndoSample& undo) {
    return m_state->say(undo, station_topic::Undo);
}

Result<void> StationMapping::setCrop(const MapCrop& crop) {
    if (auto may = m_state->granted(); !may) return may;
    const MapCropSample said{stationTime(), m_state->station, crop.polygon, crop.ceiling};
    if (auto kept = m_state->say(said, station_topic::MapCrop); !kept) return kept;
    const std::lock_guard lock(m_state->mutex);
    m_state->crop = crop;  // the mapping follows the log
    return {};
}

MapCrop StationMapping::crop() const {
    const std::lock_guard lock(m_state->mutex);
    return m_state->crop;
}

Result<void> StationMapping::State::placeable(const std::string& robot) const {
    if (auto may = granted(); !may) return may;
    if (!titles.contains(robot))
        return Error{leitstand::fill(
            translate("leitstand::Station", "\"{}\" is none of the station's robots"), robot)};
    const std::lock_guard lock(mutex);
    if (scans->scans.empty())
        return Error{translate("leitstand::Station", "there is no map yet to put a robot into")};
    return {};
}

std::optional<ScanPose> StationMapping::State::inOtherPart(const std::string& robot,
                                                           const Pose& baseInMap) const {
    const RobotsInMapPtr robots = mapping->robots();
    const auto now = std::find_if(robots->begin(), robots->end(),
                                  [&](const RobotInMap& one) { return one.robot == robot; });
    const std::lock_guard lock(mutex);
    const auto newest =
        std::find_if(scans->scans.rbegin(), scans->scans.rend(),
                     [&](const LiveKeyScan& scan) { return scan.counts() && scan.scan->robot == robot; });
    // Of one that is not sure where it is that scan says nothing: it may have been carried.
    const bool sure = now != robots->end() && now->certain;
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

std::optional<ScannerQuestion> StationMapping::scannerQuestion() const {
    return m_state->mayMap() ? m_state->scanners.question() : std::nullopt;
}

Result<void> StationMapping::answerScanner(const ScannerQuestion& asked, bool correct) {
    if (auto may = m_state->granted(); !may) return may;
    const auto question = m_state->scanners.question();
    if (!question || !question->asksAs(asked))
        return Error{translate("leitstand::Station", "nothing is asked about the scanner any more")};
    if (!correct) {
        m_state->scanners.leave(asked);
        m_state->mapping->leaveAsIs(asked.robot, faultOf(asked.more));
        return {};
    }
    const ScannerAdvice::Used used = m_state->scanners.use(asked);
    m_state->mapping->correct(asked.robot, used.total);
    m_state->tell(mapping_words::scannerCorrected(m_state->titleOf(asked.robot), used.file));
    if (!used.notWritten.empty()) m_state->tell(used.notWritten);
    return {};
}

LiveMapPtr StationMapping::scans() const {
    const std::lock_guard lock(m_state->mutex);
    return m_state->scans;
}

RobotsInMapPtr StationMapping::robots() const {
    return m_state->mapping->robots();
}

}  // namespace leitstand
