#include "core/mapping/live/map_links.h"

#include <algorithm>
#include <memory>
#include <utility>
#include <vector>

#include "core/base/words.h"

namespace leitstand {

std::set<std::uint64_t> MapLinks::together(std::uint64_t id) const {
    std::set<std::uint64_t> ids;
    for (const auto& [scan, way] : m_map.graph.sameAge(id)) ids.insert(scan);
    return ids;
}

void MapLinks::restore(const ScanLinksSample& sample) {
    m_map.graph.restore(sample.links);
    ++m_map.revision;
    m_map.unsolved = m_map.unsolved || std::any_of(sample.links.begin(), sample.links.end(),
                                                   [](const Link& link) { return closesLoop(link.kind); });
}

void MapLinks::followLoops(std::span<const Link> loops) {
    if (!m_map.graph.follow(loops)) return;
    m_map.linksChanged();
}

std::optional<SoughtPlace> MapLinks::sought() {
    const std::uint64_t id = std::exchange(m_map.sought, 0);
    const LiveKeyScan* const scan = id == 0 ? nullptr : m_map.find(id);
    if (scan == nullptr || !scan->counts()) return std::nullopt;
    // In turns, if a place of its own part may be far off, too.
    const bool elsewhere =
        inParts(m_map.map) && !(m_soughtElsewhere && m_map.loops.mayErrFar(*scan, m_map.map));
    m_soughtElsewhere = elsewhere;
    return SoughtPlace{id, std::make_shared<const LiveMap>(m_map.map), m_map.graph.sameAge(id), elsewhere};
}

std::optional<ScanLinksSample> MapLinks::recognised(const SoughtPlace& sought, const Pose& scanInMap,
                                                    Time now) {
    const LiveKeyScan* const scan = m_map.find(sought.scan);
    if (scan == nullptr || !scan->counts()) return std::nullopt;
    // If the map moved meanwhile, the place is looked for again with a later scan.
    for (const LiveKeyScan& before : sought.map->scans) {
        const LiveKeyScan* const after = m_map.find(before.id);
        if (after == nullptr || before.pose.trust != after->pose.trust ||
            !before.pose.scanInMap.isApprox(after->pose.scanInMap))
            return std::nullopt;
    }
    std::vector<Link> loop = m_map.loops.closeFar(*scan, scanInMap, m_map.map);
    if (loop.empty()) return std::nullopt;
    return ScanLinksSample{now, m_map.station, std::move(loop)};
}

Result<ScanLinksSample> MapLinks::propose(std::uint64_t id, const Pose& scanInMap, Time now) {
    const LiveKeyScan* const scan = m_map.find(id);
    if (scan == nullptr || !scan->counts())
        return Error{leitstand::fill(
            translate("leitstand::Station", "scan {}: expected one that counts: accept it first"), id)};
    auto link = m_map.byHand.propose(*scan, scanInMap, m_map.map);
    if (!link) return link.error();
    return ScanLinksSample{now, m_map.station, {*link}};
}

std::optional<ScanLinksSample> MapLinks::join(const std::map<std::uint64_t, Pose>& scansInMap, Time now) {
    std::vector<Link> links = m_map.byHand.join(scansInMap, m_map.map);
    if (links.empty()) return std::nullopt;
    m_map.loops.moved();
    m_map.linksChanged();
    return ScanLinksSample{now, m_map.station, std::move(links)};
}

std::optional<ScanLinksSample> MapLinks::meetMore(Time now) {
    if (m_map.meeting.empty()) return std::nullopt;
    const LiveKeyScan* const scan = m_map.find(m_map.meeting.front());
    m_map.meeting.pop_front();
    if (scan != nullptr && scan->counts()) m_map.loops.meetAt(*scan, m_map.map);
    if (!m_map.meeting.empty()) return std::nullopt;
    std::vector<Link> links = m_map.loops.takeMet();
    if (links.empty()) return std::nullopt;
    m_map.linksChanged();
    return ScanLinksSample{now, m_map.station, std::move(links)};
}

void MapLinks::meetNoMore() {
    m_map.meeting.clear();
    (void)m_map.loops.forgetMet();
}

Result<ScanLinksSample> MapLinks::moveTo(std::uint64_t scan, SubmapKind kind, const Pose& scanInMap,
                                         Time now) {
    const LiveKeyScan* const chosen = m_map.find(scan);
    const Pose moved = chosen != nullptr ? scanInMap * chosen->pose.scanInMap.inverse() : Pose::Identity();
    // By the map as it is: scans that entered while it was moved come along.
    const std::set<std::uint64_t> submap = submapOf(m_map.map, scan, kind);
    std::map<std::uint64_t, Pose> scansInMap;
    for (const LiveKeyScan& one : m_map.map.scans) {
        if (submap.contains(one.id)) scansInMap.emplace(one.id, moved * one.pose.scanInMap);
    }
    std::vector<Link> links = m_map.byHand.moveTo(scansInMap, leftBehind(m_map.map, scan, kind), m_map.map);
    if (links.empty())
        return Error{translate("leitstand::Station",
                               "it does not fit the rest of the map there: move it nearer to where it "
                               "belongs, or snap it first")};
    m_map.loops.moved();
    m_map.linksChanged();
    return ScanLinksSample{now, m_map.station, std::move(links)};
}

MapProblem MapLinks::problemWith(std::span<const Link> instead) const {
    MapProblem problem;
    problem.revision = m_map.revision;
    std::set<std::uint64_t> counting;
    for (const LiveKeyScan& scan : m_map.map.scans) {
        // A scan that begins a part lies where it entered, unless a link leads to it.
        const bool aside = scan.begins() && scan.id != m_map.map.scans.front().id;
        if (scan.pose.trust != ScanTrust::SetAside)
            problem.graph.nodes.push_back({scan.id, aside ? scan.enteredAt : scan.pose.scanInMap, false});
        if (scan.counts()) counting.insert(scan.id);
    }
    std::vector<Link>& links = problem.graph.links;
    links = m_map.graph.links();
    for (const Link& link : instead) {
        const auto known =
            std::find_if(links.begin(), links.end(), [&](const Link& one) { return one.id == link.id; });
        if (known == links.end())
            links.push_back(link);  // from another station; it will be received here in a moment
        else
            *known = link;
    }
    (void)leaveUnheld(links, m_map.scansInParts());
    for (Link& link : links) {
        // A decision may have removed what a scan was matched with. Then odometry places it, as before.
        const bool counts = counting.contains(link.to);
        if (link.kind == LinkKind::Match) link.active = link.active && counts && counting.contains(link.from);
        if (link.kind == LinkKind::Odometry) link.active = link.active || !counts;
    }
    return problem;
}

std::optional<MapProblem> MapLinks::problem() {
    if (!std::exchange(m_map.unsolved, false)) return std::nullopt;
    return problemWith({});
}

Settled MapLinks::settle(const MapSolution& solution, Time now) {
    Settled settled;
    if (solution.revision != m_map.revision) {
        m_map.unsolved = true;
        return settled;
    }
    const std::vector<Link> contradicted = m_map.graph.contradict(solution.contradicted);
    if (!contradicted.empty()) settled.links = ScanLinksSample{now, m_map.station, contradicted};
    std::map<std::uint64_t, Pose> solved;
    for (const GraphNode& node : solution.nodes) solved.emplace(node.id, node.pose);
    std::map<std::uint64_t, Pose> corrections;  // to put before the poses of scans
    std::map<std::string, Pose> newest;         // the newest of these, by robot
    std::vector<ScanPose> moved;
    for (LiveKeyScan& scan : m_map.map.scans) {
        const Pose before = scan.pose.scanInMap;
        Pose& robots = newest.try_emplace(scan.scan->robot, Pose::Identity()).first->second;
        const auto known = solved.find(scan.id);
        const auto beside = corrections.find(scan.matched);
        const Pose correction = known != solved.end()         ? known->second * before.inverse()
                                : beside != corrections.end() ? beside->second
                                                              : robots;
        corrections[scan.id] = robots = correction;
        const Pose after = known != solved.end() ? known->second : correction * before;
        if (!isNoticed(before, after, m_map.settings.loops)) continue;
        settled.largest = std::max(settled.largest, distanceBetween(before, after));
        scan.pose.scanInMap = after;
        m_map.cropped.fit(scan, m_map.clouds);
        moved.push_back(scan.pose);
    }
    // Parts that came together lie so only now.
    m_map.findParts();
    if (moved.empty()) return settled;
    m_map.loops.moved();
    // Scans that were compared with others in the map as it was are compared again.
    const std::vector<std::uint64_t> again = m_map.loops.forgetMet();
    m_map.meeting.insert(m_map.meeting.begin(), again.begin(), again.end());
    for (auto& [name, track] : m_map.robots) {
        const LiveKeyScan* const key = track.key == 0 ? nullptr : m_map.find(track.key);
        if (key == nullptr) continue;
        track.sensorInMap = key->pose.scanInMap * track.keyInMap.inverse() * track.sensorInMap;
        track.keyInMap = key->pose.scanInMap;
    }
    m_map.matcher.mapChanged();
    settled.poses =
        ScanPosesSample{now, m_map.station, ScanPosesSample::Cause::LoopClosure, std::move(moved)};
    return settled;
}

}  // namespace leitstand
