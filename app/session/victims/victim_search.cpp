#include "app/session/victims/victim_search.h"

#include <limits>
#include <variant>

namespace leitstand {
namespace {

constexpr double AboutARobot = 0.45;  // what moves or is warm so near to a robot is the robot [m]

}  // namespace

VictimSearch::VictimSearch(const std::vector<RobotDescription>& robots, const std::string& station,
                           const CueSettings& cues, const CandidateSettings& candidates)
    : m_book(station, candidates) {
    for (const RobotDescription& robot : robots) m_finders.try_emplace(robot.name, robot, cues);
}

void VictimSearch::correct(const Scan& scan, double certainty) {
    const auto finder = m_finders.find(scan.robot);
    if (finder == m_finders.end()) return;
    finder->second.correct({scan.end, scan.scanInMap * scan.sensorInBase.inverse(), certainty, scan.counts,
                            scan.counts ? "its scan fits the map" : "its scan does not fit"});
}

void VictimSearch::correct(const std::string& robot, const MapFix& fix) {
    const auto finder = m_finders.find(robot);
    if (finder != m_finders.end()) finder->second.correct(fix);
}

const RobotInMap* VictimSearch::place(const std::string& robot) const {
    const auto finder = m_finders.find(robot);
    return finder == m_finders.end() ? nullptr : &finder->second.now();
}

void VictimSearch::take(const KeyScanSample& sample) {
    if (!sample.scan) return;
    const Scan scan{sample.scan->robot, sample.scan->end, sample.sensorInBase, sample.scanInMap, true};
    m_scans[sample.id] = scan;
    m_newest[scan.robot] = sample.id;
    m_book.scanAt(sample.id, scan.scanInMap);
    correct(scan, 1.0);
}

void VictimSearch::move(const ScanPose& pose) {
    m_book.scanAt(pose.scan, pose.scanInMap);
    Scan& scan = m_scans[pose.scan];  // of an earlier session: without a robot
    scan.scanInMap = pose.scanInMap;
    scan.counts = pose.trust == ScanTrust::Certain;
    const auto newest = m_newest.find(scan.robot);
    if (newest != m_newest.end() && newest->second == pose.scan) correct(scan, pose.certainty);
}

void VictimSearch::follow(std::span<const ScanPose> poses) {
    for (const ScanPose& pose : poses) move(pose);
}

std::uint64_t VictimSearch::scanFor(const PlacedCue& cue) const {
    const auto own = m_newest.find(cue.cue.robot);
    if (own != m_newest.end() && m_scans.at(own->second).counts) return own->second;
    const auto robot = m_finders.find(cue.cue.robot);
    const Eigen::Vector3d from =
        robot == m_finders.end() ? cue.inMap : Eigen::Vector3d(robot->second.now().baseInMap.translation());
    std::uint64_t best = 0;
    double nearest = std::numeric_limits<double>::infinity();
    for (const auto& [id, scan] : m_scans) {
        const double away = (scan.scanInMap.translation() - from).norm();
        if (!scan.counts || away >= nearest) continue;
        nearest = away;
        best = id;
    }
    return best;
}

bool VictimSearch::isRobot(const PlacedCue& cue) const {
    if (cue.cue.kind != "motion" && cue.cue.kind != "heat") return false;
    for (const auto& [name, finder] : m_finders) {
        if (name == cue.cue.robot || !finder.now().placed) continue;
        const Eigen::Vector3d off = finder.now().baseInMap.translation() - cue.inMap;
        if (off.head<2>().norm() < AboutARobot) return true;
    }
    return false;
}

std::optional<PlacedCue> VictimSearch::locate(const LookedAt& looked) {
    const auto finder = m_finders.find(looked.picture.robot);
    if (finder == m_finders.end()) return std::nullopt;
    auto cue = finder->second.locate(looked);
    if (cue) cue->scan = scanFor(*cue);
    return cue;
}

void VictimSearch::take(const Event& event, bool search) {
    if (const auto* scan = std::get_if<KeyScanSample>(&event.sample)) return take(*scan);
    if (const auto* poses = std::get_if<ScanPosesSample>(&event.sample)) return follow(poses->poses);
    if (const auto* candidate = std::get_if<CandidateSample>(&event.sample)) return m_book.take(*candidate);
    if (const auto* place = std::get_if<RobotPlaceSample>(&event.sample)) {
        const auto finder = m_finders.find(place->robot);
        if (finder != m_finders.end())
            finder->second.correct(
                {place->measured, place->baseInMap, place->certainty, place->certain, place->how});
        return;
    }
    const auto finder = m_finders.find(event.robot);
    if (finder == m_finders.end()) return;
    if (!search && std::holds_alternative<PictureSample>(event.sample)) return;
    if (!search && std::holds_alternative<SightingSample>(event.sample)) {
        m_unheard.insert_or_assign(event.robot, event);  // a robot says them once
        return;
    }
    if (search) {
        if (const auto late = m_unheard.extract(event.robot)) finder->second.take(late.mapped());
    }
    finder->second.take(event);
    for (PlacedCue& cue : finder->second.found()) {
        if (!search || isRobot(cue)) continue;
        cue.scan = scanFor(cue);
        if (onCue) onCue(cue);
        m_book.add(cue);
    }
}

}  // namespace leitstand
