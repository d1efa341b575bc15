#include <algorithm>
#include <map>
#include <set>
#include <utility>
#include <vector>

#include "core/base/words.h"
#include "core/mapping/graph/map_parts.h"
#include "core/mapping/live/live_mapper.h"
#include "core/mapping/live/live_mapper_state.h"

namespace leitstand {
namespace {

/// Deactivates those of @p links that no pose follows. Returns their ids.
std::set<std::uint64_t> leaveUnheld(std::vector<Link>& links, std::span<const ScanInPart> scans) {
    std::set<std::uint64_t> unheld = unheldLoops(links, scans);
    for (Link& link : links) link.active = link.active && !unheld.contains(link.id);
    return unheld;
}

}  // namespace

std::vector<ScanInPart> LiveMapper::State::scansInParts() const {
    std::vector<ScanInPart> scans;
    scans.reserve(map.scans.size());
    for (const LiveKeyScan& scan : map.scans)
        scans.push_back({scan.id, scan.matched, scan.begins(), scan.enteredAt, scan.part});
    return scans;
}

void LiveMapper::State::findParts() {
    std::vector<ScanInPart> scans = scansInParts();
    std::set<std::uint64_t> before, joined;  // parts that were there, and those that belong to others now
    for (const ScanInPart& scan : scans) before.insert(scan.part);
    std::vector<Link> links = loops.graph().links();
    loops.setUnheld(leaveUnheld(links, scans));
    leitstand::findParts(scans, MapParts(links));
    bool changed = false;
    for (std::size_t i = 0; i < scans.size(); ++i) {
        const std::uint64_t was = map.scans[i].part;
        if (scans[i].part == was) continue;
        changed = true;
        if (was != 0 && before.contains(scans[i].part)) joined.insert(was);
    }
    if (!changed) return;
    // Parts that came apart do not meet any more. Parts that came together may see the same elsewhere, too.
    meeting.clear();
    (void)loops.forgetMet();
    for (std::size_t i = 0; i < scans.size(); ++i) {
        LiveKeyScan& scan = map.scans[i];
        if (scan.counts() && joined.contains(scan.part) && !joined.contains(scans[i].part))
            meeting.push_back(scan.id);
        if (scans[i].part == scan.part) continue;
        scan.part = scans[i].part;
        cropped.fit(scan, clouds);
    }
    matcher.mapChanged();
}

bool LiveMapper::State::isAlone(const RobotTrack& robot) {
    if (robot.placedInMap || robot.key == 0) return false;
    const std::uint64_t part = partOf(robot);
    return std::none_of(map.scans.begin(), map.scans.end(),
                        [part](const LiveKeyScan& scan) { return scan.counts() && scan.part == part; });
}

bool LiveMapper::State::beginsPart(const RobotTrack& robot) {
    if (empty()) return false;
    return robot.known || robot.placedInMap ? isAlone(robot) : robot.beginsPart;
}

std::uint64_t LiveMapper::State::partFor(const RobotTrack& robot, const Pose& guess) {
    return robot.placedInMap || robot.key == 0 ? partAt(map.scans, guess) : partOf(robot);
}

const LiveSettings& LiveMapper::State::preparing(const RobotTrack& robot, const Pose& guess) {
    return beginsPart(robot) || partFor(robot, guess) != 0 ? uncropped : settings;
}

std::uint64_t LiveMapper::State::partOf(const RobotTrack& robot) {
    const LiveKeyScan* const key = find(robot.key);
    return key != nullptr ? key->part : 0;
}

void LiveMapper::State::link(MapUpdate& update, const RobotTrack& robot,
                             std::span<const std::uint64_t> against, const Match& match, Time now) {
    const LiveKeyScan& key = map.scans.back();
    std::vector<LiveKeyScan> others;
    for (const std::uint64_t id : against) {
        if (const LiveKeyScan* const other = find(id)) others.push_back(*other);
    }
    // A robot that was placed may have been carried, which its odometry does not know. A scan that begins a
    // part is connected with nothing.
    const bool apart = robot.key == 0 || robot.placedInMap || key.part == key.id;
    const LiveKeyScan* before = apart ? nullptr : find(robot.key);
    // A scan that odometry alone holds must not depend on a scan that may be rejected.
    if (before != nullptr && !before->counts() && key.counts() && match.doubts != 0) {
        const auto counts = std::find_if(map.scans.rbegin(), map.scans.rend(), [&](const LiveKeyScan& one) {
            return one.counts() && one.id != key.id && one.scan->robot == key.scan->robot &&
                   one.odometryFrame == key.odometryFrame;
        });
        if (counts != map.scans.rend()) before = &*counts;
    }
    std::vector<Link> links = loops.add({key, before, others, match});
    if (!links.empty()) update.links = ScanLinksSample{now, station, std::move(links)};
    if (!key.counts()) return;
    std::vector<Link> loop = loops.close(key, map);
    if (loop.empty()) {
        if (loops.seeks(key, map)) sought = key.id;
        return;
    }
    unsolved = unsolved || loop.front().active;
    update.loop = ScanLinksSample{now, station, std::move(loop)};
}

void LiveMapper::State::linkAgain(std::uint64_t id, std::span<const std::uint64_t> against,
                                  const Match& match, Time now) {
    std::vector<LiveKeyScan> others;
    for (const std::uint64_t other : against) {
        if (const LiveKeyScan* const scan = find(other)) others.push_back(*scan);
    }
    std::vector<Link> links = loops.replace({*find(id), nullptr, others, match});
    if (!links.empty()) madeLinks = ScanLinksSample{now, station, std::move(links)};
    findParts();
}

std::set<std::uint64_t> LiveMapper::together(std::uint64_t id) const {
    std::set<std::uint64_t> ids;
    for (const auto& [scan, way] : m_state->loops.sameAge(id)) ids.insert(scan);
    return ids;
}

std::optional<ScanLinksSample> LiveMapper::takeLinks() {
    return std::exchange(m_state->madeLinks, std::nullopt);
}

void LiveMapper::restore(const ScanLinksSample& sample) {
    State& state = *m_state;
    state.loops.restore(sample.links);
    ++state.revision;
    state.unsolved = state.unsolved || std::any_of(sample.links.begin(), sample.links.end(),
                                                   [](const Link& link) { return closesLoop(link.kind); });
}

void LiveMapper::takeAsSolved() {
    m_state->unsolved = false;
}

void LiveMapper::followLoops(std::span<const Link> loops) {
    if (!m_state->loops.follow(loops)) return;
    ++m_state->revision;
    m_state->unsolved = true;
}

std::optional<SoughtPlace> LiveMapper::sought() {
    State& state = *m_state;
    const std::uint64_t id = std::exchange(state.sought, 0);
    const LiveKeyScan* const scan = id == 0 ? nullptr : state.find(id);
    if (scan == nullptr || !scan->counts()) return std::nullopt;
    // In turns, if a place of its own part may be far off, too.
    const bool elsewhere =
        inParts(state.map) && !(state.soughtElsewhere && state.loops.mayErrFar(*scan, state.map));
    state.soughtElsewhere = elsewhere;
    return SoughtPlace{id, map(), state.loops.sameAge(id), elsewhere};
}

std::optional<ScanLinksSample> LiveMapper::recognised(const SoughtPlace& sought, const Pose& scanInMap,
                                                      Time now) {
    State& state = *m_state;
    const LiveKeyScan* const scan = state.find(sought.scan);
    if (scan == nullptr || !scan->counts()) return std::nullopt;
    // If the map moved meanwhile, the place is looked for again with a later scan.
    for (const LiveKeyScan& before : sought.map->scans) {
        const LiveKeyScan* const after = state.find(before.id);
        if (after == nullptr || before.pose.trust != after->pose.trust ||
            !before.pose.scanInMap.isApprox(after->pose.scanInMap))
            return std::nullopt;
    }
    std::vector<Link> loop = state.loops.closeFar(*scan, scanInMap, state.map);
    if (loop.empty()) return std::nullopt;
    return ScanLinksSample{now, state.station, std::move(loop)};
}

Result<ScanLinksSample> LiveMapper::propose(std::uint64_t id, const Pose& scanInMap, Time now) {
    State& state = *m_state;
    const LiveKeyScan* const scan = state.find(id);
    if (scan == nullptr || !scan->counts())
        return Error{leitstand::fill(
            translate("leitstand::Station", "scan {}: expected one that counts: accept it first"), id)};
    auto link = state.loops.propose(*scan, scanInMap, state.map);
    if (!link) return link.error();
    return ScanLinksSample{now, state.station, {*link}};
}

std::optional<ScanLinksSample> LiveMapper::join(const std::map<std::uint64_t, Pose>& scansInMap, Time now) {
    State& state = *m_state;
    std::vector<Link> links = state.loops.join(scansInMap, state.map);
    if (links.empty()) return std::nullopt;
    ++state.revision;
    state.unsolved = true;
    return ScanLinksSample{now, state.station, std::move(links)};
}

bool LiveMapper::meetsMore() const {
    return !m_state->meeting.empty();
}

std::optional<ScanLinksSample> LiveMapper::meetMore(Time now) {
    State& state = *m_state;
    if (state.meeting.empty()) return std::nullopt;
    const LiveKeyScan* const scan = state.find(state.meeting.front());
    state.meeting.pop_front();
    if (scan != nullptr && scan->counts()) state.loops.meetAt(*scan, state.map);
    if (!state.meeting.empty()) return std::nullopt;
    std::vector<Link> links = state.loops.takeMet();
    if (links.empty()) return std::nullopt;
    ++state.revision;
    state.unsolved = true;
    return ScanLinksSample{now, state.station, std::move(links)};
}

void LiveMapper::meetNoMore() {
    m_state->meeting.clear();
    (void)m_state->loops.forgetMet();
}

Result<ScanLinksSample> LiveMapper::moveTo(std::uint64_t scan, SubmapKind kind, const Pose& scanInMap,
                                           Time now) {
    State& state = *m_state;
    const LiveKeyScan* const chosen = state.find(scan);
    const Pose moved = chosen != nullptr ? scanInMap * chosen->pose.scanInMap.inverse() : Pose::Identity();
    // By the map as it is: scans that entered while it was moved come along.
    const std::set<std::uint64_t> submap = submapOf(state.map, scan, kind);
    std::map<std::uint64_t, Pose> scansInMap;
    for (const LiveKeyScan& one : state.map.scans) {
        if (submap.contains(one.id)) scansInMap.emplace(one.id, moved * one.pose.scanInMap);
    }
    std::vector<Link> links = state.loops.moveTo(scansInMap, leftBehind(state.map, scan, kind), state.map);
    if (links.empty())
        return Error{translate("leitstand::Station",
                               "it does not fit the rest of the map there: move it nearer to where it "
                               "belongs, or snap it first")};
    ++state.revision;
    state.unsolved = true;
    return ScanLinksSample{now, state.station, std::move(links)};
}

MapProblem LiveMapper::State::problem(std::span<const Link> instead) const {
    MapProblem problem;
    problem.revision = revision;
    std::set<std::uint64_t> counting;
    for (const LiveKeyScan& scan : map.scans) {
        // A scan that begins a part lies where it entered, unless a link leads to it.
        const bool aside = scan.begins() && scan.id != map.scans.front().id;
        if (scan.pose.trust != ScanTrust::SetAside)
            problem.graph.nodes.push_back({scan.id, aside ? scan.enteredAt : scan.pose.scanInMap, false});
        if (scan.counts()) counting.insert(scan.id);
    }
    std::vector<Link>& links = problem.graph.links;
    links = loops.graph().links();
    for (const Link& link : instead) {
        const auto known =
            std::find_if(links.begin(), links.end(), [&](const Link& one) { return one.id == link.id; });
        if (known == links.end())
            links.push_back(link);  // from another station; it will be received here in a moment
        else
            *known = link;
    }
    (void)leaveUnheld(links, scansInParts());
    for (Link& link : links) {
        // A decision may have removed what a scan was matched with. Then odometry places it, as before.
        const bool counts = counting.contains(link.to);
        if (link.kind == LinkKind::Match) link.active = link.active && counts && counting.contains(link.from);
        if (link.kind == LinkKind::Odometry) link.active = link.active || !counts;
    }
    return problem;
}

std::optional<MapProblem> LiveMapper::problem() {
    if (!std::exchange(m_state->unsolved, false)) return std::nullopt;
    return m_state->problem({});
}

MapProblem LiveMapper::problemWith(std::span<const Link> links) const {
    return m_state->problem(links);
}

void LiveMapper::leaveUnsettled() {
    m_state->unsolved = true;
}

Settled LiveMapper::settle(const MapSolution& solution, Time now) {
    State& state = *m_state;
    Settled settled;
    if (solution.revision != state.revision) {
        state.unsolved = true;
        return settled;
    }
    const std::vector<Link> contradicted = state.loops.contradict(solution.contradicted);
    if (!contradicted.empty()) settled.links = ScanLinksSample{now, state.station, contradicted};
    std::map<std::uint64_t, Pose> solved;
    for (const GraphNode& node : solution.nodes) solved.emplace(node.id, node.pose);
    std::map<std::uint64_t, Pose> corrections;  // to put before the poses of scans
    std::map<std::string, Pose> newest;         // the newest of these, by robot
    std::vector<ScanPose> moved;
    for (LiveKeyScan& scan : state.map.scans) {
        const Pose before = scan.pose.scanInMap;
        Pose& robots = newest.try_emplace(scan.scan->robot, Pose::Identity()).first->second;
        const auto known = solved.find(scan.id);
        const auto beside = corrections.find(scan.matched);
        const Pose correction = known != solved.end()         ? known->second * before.inverse()
                                : beside != corrections.end() ? beside->second
                                                              : robots;
        corrections[scan.id] = robots = correction;
        const Pose after = known != solved.end() ? known->second : correction * before;
        if (!isNoticed(before, after, state.settings.loops)) continue;
        settled.largest = std::max(settled.largest, distanceBetween(before, after));
        scan.pose.scanInMap = after;
        state.cropped.fit(scan, state.clouds);
        moved.push_back(scan.pose);
    }
    // Parts that came together lie so only now.
    state.findParts();
    if (moved.empty()) return settled;
    state.loops.moved();
    // Scans that were compared with others in the map as it was are compared again.
    const std::vector<std::uint64_t> again = state.loops.forgetMet();
    state.meeting.insert(state.meeting.begin(), again.begin(), again.end());
    for (auto& [name, track] : state.robots) {
        const LiveKeyScan* const key = track.key == 0 ? nullptr : state.find(track.key);
        if (key == nullptr) continue;
        track.sensorInMap = key->pose.scanInMap * track.keyInMap.inverse() * track.sensorInMap;
        track.keyInMap = key->pose.scanInMap;
    }
    state.matcher.mapChanged();
    settled.poses =
        ScanPosesSample{now, state.station, ScanPosesSample::Cause::LoopClosure, std::move(moved)};
    return settled;
}

}  // namespace leitstand
