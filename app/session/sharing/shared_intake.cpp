#include "app/session/sharing/shared_intake.h"

#include <algorithm>
#include <utility>
#include <variant>

#include "app/session/sharing/shared_evidence.h"
#include "core/base/words.h"
#include "core/mission/station_topics.h"
#include "transport/convert/decode.h"
#include "transport/convert/encode.h"

namespace leitstand {
namespace {

constexpr std::size_t MostOthers = 64;  ///< stations that are remembered, whatever others say

/// Whether it lies in the map of whom it is from.
bool isOfMap(const Sample& sample) {
    return std::holds_alternative<KeyScanSample>(sample) || std::holds_alternative<ScanPosesSample>(sample) ||
           std::holds_alternative<MapCropSample>(sample) || std::holds_alternative<RobotPlaceSample>(sample);
}

bool isPlacedInMap(const Sample& sample) {
    return isOfMap(sample) || std::holds_alternative<VictimSample>(sample) ||
           std::holds_alternative<CandidateSample>(sample);
}

/// The stamp of what the mission has of the same thing as @p sample; empty: nothing, or stamps do not matter.
std::optional<Time> knownStamp(const MissionState& mission, const Sample& sample) {
    if (const auto* find = std::get_if<VictimSample>(&sample)) {
        const auto known = mission.victims->find({find->kind, find->number});
        if (known != mission.victims->end()) return known->second.victim.stamp;
    } else if (const auto* candidate = std::get_if<CandidateSample>(&sample)) {
        const auto known = mission.candidates->find(candidate->id);
        if (known != mission.candidates->end()) return known->second.candidate.stamp;
    } else if (std::holds_alternative<ClockSample>(sample)) {
        if (mission.clock) return mission.clock->sample.stamp;
    } else if (std::holds_alternative<MissionInfoSample>(sample)) {
        if (mission.info) return mission.info->sample.stamp;
    } else if (std::holds_alternative<MapCropSample>(sample)) {
        if (mission.crop) return mission.crop->sample.stamp;
    }
    return std::nullopt;
}

Time stampOf(const Sample& sample) {
    return std::visit(
        [](const auto& one) {
            if constexpr (requires { Time(one.stamp); }) return one.stamp;
            return Time{};
        },
        sample);
}

std::vector<std::uint64_t> scansOf(const Sample& sample) {
    std::vector<std::uint64_t> scans;
    if (const auto* poses = std::get_if<ScanPosesSample>(&sample)) {
        for (const ScanPose& pose : poses->poses) scans.push_back(pose.scan);
    }
    return scans;
}

}  // namespace

SharedIntake::SharedIntake(SharedIntakeSetup setup) : m_setup(std::move(setup)) {
    for (const auto& [id, scan] : *m_setup.mission()->keyScans)
        m_scans[id] = {scan.entry.robot, scan.entry.stamp};
}

void SharedIntake::know(const Event& event) {
    const auto* scan = std::get_if<KeyScanSample>(&event.sample);
    if (scan == nullptr || !scan->scan) return;
    const std::lock_guard lock(m_mutex);
    m_scans.try_emplace(scan->id, Known{scan->scan->robot, scan->stamp});
}

bool SharedIntake::isAdopted(std::uint64_t id) const {
    const std::lock_guard lock(m_mutex);
    return m_adopted.contains(id);
}

bool SharedIntake::knows(const std::vector<std::uint64_t>& scans) const {
    return std::all_of(scans.begin(), scans.end(), [&](std::uint64_t id) { return m_scans.contains(id); });
}

void SharedIntake::tellOtherMap(std::uint64_t scan) const {
    if (!m_setup.tell) return;
    m_setup.tell(
        fill(translate("leitstand::Station",
                       "another station makes another map than this mission's (their scans {} differ): "
                       "it is not shown here; begin a new mission to see it"),
             scan));
}

bool SharedIntake::wants(const KeyScanSample& scan, Other& other) {
    if (!scan.scan) return false;
    const Known that{scan.scan->robot, scan.stamp};
    const auto known = m_scans.find(scan.id);
    const bool same = known != m_scans.end() && known->second == that;
    if (other.map == Map::Unknown && !m_scans.empty() && !same) {
        if (known == m_scans.end()) return false;  // nobody can tell yet; it comes again after the first
        other.map = Map::Other;
        other.waiting.clear();
        tellOtherMap(scan.id);
        return false;
    }
    other.map = Map::Same;
    if (same) return false;
    m_scans[scan.id] = that;
    m_adopted.insert(scan.id);
    return true;
}

bool SharedIntake::wants(const Event& event, Other& other) {
    const Sample& sample = event.sample;
    if (isOfMap(sample) && m_setup.holdsMap()) return false;
    if (other.map == Map::Other && isPlacedInMap(sample)) return false;
    if (const auto* scan = std::get_if<KeyScanSample>(&sample)) return wants(*scan, other);
    const auto known = knownStamp(*m_setup.mission(), sample);
    return !known || *known < stampOf(sample);
}

void SharedIntake::take(RawEvent event, const Sender& from, SteadyTime now) {
    const bool ours = from == m_setup.me;
    if (ours && event.topic != station_topic::Grants) return;
    const std::lock_guard lock(m_mutex);
    if (event.topic == station_topic::Grants) {
        m_setup.enter(std::move(event));
        return release(now);  // once a second
    }
    if (!m_others.contains(from) && m_others.size() >= MostOthers) return;
    const auto decoded = decodeStationEvent(event);
    if (!decoded) return m_setup.enter(std::move(event));  // counted as broken there, and kept
    Other& other = m_others[from];
    const bool wanted = wants(*decoded, other);
    const bool scan = std::holds_alternative<KeyScanSample>(decoded->sample);
    if (wanted && isOfMap(decoded->sample) && !scan) {
        // Also what need not wait stays behind what was said before.
        other.waiting.push_back({std::move(event), now, scansOf(decoded->sample)});
        if (other.waiting.size() > MostWaiting) other.waiting.pop_front();
    } else if (wanted) {
        Sample sample = decoded->sample;  // points are shared
        if (takeOurSequences(sample, *m_setup.mission())) {
            if (auto cdr = encode(sample, event.type)) event.cdr = std::move(cdr).value();
        }
        m_setup.enter(std::move(event));
    }
    release(now);
}

void SharedIntake::release(SteadyTime now) {
    for (auto& [from, other] : m_others) {
        while (!other.waiting.empty()) {
            Waiting& first = other.waiting.front();
            const bool late = now - first.since >= LongestWait;
            if ((other.map == Map::Unknown || !knows(first.scans)) && !late) break;
            first.event.received = {};  // it enters now
            if (other.map == Map::Same) m_setup.enter(std::move(first.event));
            other.waiting.pop_front();
        }
    }
}

}  // namespace leitstand
