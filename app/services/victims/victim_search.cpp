#include "app/services/victims/victim_search.h"

#include <utility>

#include "core/event/map_samples.h"
#include "core/event/picture_samples.h"
#include "core/event/scan_pose.h"
#include "core/event/station_samples.h"
#include "core/event/status_samples.h"

namespace leitstand {
namespace {

constexpr double AboutARobot = 0.45;  // motion or heat this near to a robot is the robot [m]

}  // namespace

VictimSearch::VictimSearch(const std::vector<RobotDescription>& robots, const std::string& station,
                           const CueSettings& cues, const CandidateSettings& candidates)
    : m_book(station, candidates) {
    for (const RobotDescription& robot : robots) m_finders.try_emplace(robot.name, robot, cues);
}

void VictimSearch::correct(std::span<const PlaceOfRobot> fixes) {
    for (const PlaceOfRobot& one : fixes) correct(one.robot, one.fix);
}

void VictimSearch::correct(const std::string& robot, const MapFix& fix) {
    const auto finder = m_finders.find(robot);
    if (finder != m_finders.end()) finder->second.correct(fix);
}

const RobotInMap* VictimSearch::place(const std::string& robot) const {
    const auto finder = m_finders.find(robot);
    return finder == m_finders.end() ? nullptr : &finder->second.now();
}

void VictimSearch::follow(std::span<const ScanPose> poses) {
    for (const ScanPose& pose : poses) m_book.scanAt(pose.scan, pose.scanInMap);
    correct(m_scans.follow(poses));
}

std::uint64_t VictimSearch::scanFor(const PlacedCue& cue) const {
    const RobotInMap* const robot = place(cue.cue.robot);
    return m_scans.scanFor(cue.cue.robot,
                           robot == nullptr ? cue.inMap : Eigen::Vector3d(robot->baseInMap.translation()));
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

bool VictimSearch::shows(const Event& picture, const Eigen::Vector3d& inMap) {
    const auto finder = m_finders.find(picture.robot);
    return finder != m_finders.end() && finder->second.shows(picture, inMap);
}

TagPatterns TagsOfProfiles::of(const std::string& name) const {
    if (const auto found = byName.find(name); found != byName.end()) return found->second;
    return byName.empty() ? usualTags() : byName.rbegin()->second;
}

void VictimSearch::setTags(TagsOfProfiles tags, const std::string& profile) {
    m_tags = std::move(tags);
    m_book.tags(m_tags.of(profile));
}

void VictimSearch::restore(const FindSample& find) {
    const bool none = find.status == FindSample::Status::Discarded && find.mergedInto == 0;
    m_book.discarded(find.kind, find.number, none);
}

void VictimSearch::onEvent(const Event& event, bool search) {
    if (const auto* find = event.sample.as<FindSample>()) return restore(*find);
    if (const auto* info = event.sample.as<MissionInfoSample>()) return m_book.tags(m_tags.of(info->profile));
    if (const auto* candidate = event.sample.as<CandidateSample>()) return m_book.take(*candidate);
    if (KeyScanPlaces::wants(event)) {
        if (const auto* scan = event.sample.as<KeyScanSample>(); scan != nullptr && scan->scan)
            m_book.scanAt(scan->id, scan->scanInMap);
        if (const auto* moved = event.sample.as<ScanPosesSample>()) {
            for (const ScanPose& pose : moved->poses) m_book.scanAt(pose.scan, pose.scanInMap);
        }
        return correct(m_scans.onEvent(event));
    }
    const auto finder = m_finders.find(event.robot);
    if (finder == m_finders.end()) return;
    if (!search && event.sample.is<PictureSample>()) return;
    if (!search && event.sample.is<SightingSample>()) {
        m_notReceived.insert_or_assign(event.robot, event);  // a robot sends them once
        return;
    }
    if (search) {
        if (const auto late = m_notReceived.extract(event.robot)) finder->second.onEvent(late.mapped());
    }
    finder->second.onEvent(event);
    for (PlacedCue& cue : finder->second.found()) {
        if (!search || isRobot(cue)) continue;
        cue.scan = scanFor(cue);
        if (onCue) onCue(cue);
        m_book.add(cue);
    }
}

}  // namespace leitstand
