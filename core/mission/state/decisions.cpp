#include "core/mission/state/decisions.h"

#include <algorithm>
#include <iterator>
#include <limits>
#include <map>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "core/event/all_samples.h"
#include "core/event/find_sample.h"
#include "core/event/map_samples.h"
#include "core/event/scan_bodies.h"
#include "core/event/scan_pose.h"
#include "core/event/station_samples.h"
#include "core/mission/state/crop_state.h"
#include "core/mission/state/decision.h"
#include "core/mission/state/find_state.h"
#include "core/mission/state/scan_state.h"
#include "core/mission/state/scans_in_parts.h"

namespace leitstand {

namespace {

/// Applies decisions to the state. Editors are taken once: each edit() checks whether others share the value.
class Effects {
public:
    explicit Effects(MissionState& state) : m_state(state) {}

    void apply(const Decision& decision) {
        std::visit([&](const auto& content) { effect(decision, content); }, decision.content);
    }

private:
    void effect(const Decision& decision, const FindSample& victim) {
        const auto [known, fresh] = m_state.finds.edit().try_emplace(FindKey{victim.kind, victim.number});
        if (fresh) known->second.filed = decision.sequence;
        known->second.sequence = decision.sequence;
        known->second.victim = victim;
    }

    void effect(const Decision& decision, const NoteSample& note) {
        m_state.notes.edit().push_back({decision.sequence, decision.received, note});
    }

    void effect(const Decision& decision, const KeyScanEntry& entry) {
        if (m_state.bodies->contains(entry.id)) m_state.bodies.edit().erase(entry.id);  // of another scan
        KeyScanState& scan = m_state.keyScans.edit()[entry.id];
        scan.sequence = scan.poseSequence = decision.sequence;
        scan.entry = entry;
        scan.pose = {.scan = entry.id, .scanInMap = entry.scanInMap};
    }

    void effect(const Decision& decision, const ScanPosesSample& sample) {
        auto& scans = m_state.keyScans.edit();
        for (const ScanPose& pose : sample.poses) {
            const auto scan = scans.find(pose.scan);
            if (scan == scans.end()) continue;
            const ScanPose before = scan->second.pose;
            scan->second.pose = pose;
            if (sample.cause == ScanPosesSample::Cause::LoopClosure) {
                // Whether the scan counts is an earlier decision, which may be undone. A loop only moves the
                // scan.
                scan->second.pose.trust = before.trust;
                scan->second.pose.doubts = before.doubts;
            }
            scan->second.poseSequence = decision.sequence;
        }
    }

    void effect(const Decision& decision, const MapCropSample& crop) {
        m_state.crop =
            std::make_shared<const CropState>(CropState{decision.sequence, decision.received, crop, {}});
    }

    void effect(const Decision& decision, const ScanLinksSample& sample) {
        auto& loops = m_state.loops.edit();
        for (const Link& link : sample.links) loops[link.id] = {decision.sequence, link};
    }

    void effect(const Decision&, const ScanBodiesSample& sample) {
        auto& bodies = m_state.bodies.edit();
        for (const BodiesOfScan& one : sample.scans) bodies[one.scan] = one.bodies;
    }

    void effect(const Decision&, const UndoSample&) {}

    MissionState& m_state;
};

Decision* find(std::vector<Decision>& decisions, std::uint64_t sequence) {
    const auto found = std::lower_bound(
        decisions.begin(), decisions.end(), sequence,
        [](const Decision& decision, std::uint64_t wanted) { return decision.sequence < wanted; });
    return found != decisions.end() && found->sequence == sequence ? &*found : nullptr;
}

/// Computes all that follows from the decisions of @p state, except where the area hangs.
void apply(MissionState& state) {
    std::vector<Decision>& decisions = state.decisions.edit();
    for (Decision& decision : decisions) decision.undone = false;
    // An undo names an earlier event. From the newest back, each is settled before its turn comes.
    for (auto decision = decisions.rbegin(); decision != decisions.rend(); ++decision) {
        const auto* undo = std::get_if<UndoSample>(&decision->content);
        if (undo == nullptr || decision->undone || undo->event >= decision->sequence) continue;
        if (Decision* target = find(decisions, undo->event)) target->undone = true;
    }
    state.finds.edit().clear();
    state.keyScans.edit().clear();
    state.loops.edit().clear();
    state.bodies.edit().clear();
    state.notes.edit().clear();
    state.crop.reset();
    Effects effects(state);
    for (const Decision& decision : *state.decisions) {
        if (!decision.undone) effects.apply(decision);
    }
}

/// Returns the corner @p at of an area, hung on the nearest of @p scans. The scans are as they were when it
/// was drawn. @p parts: the part of each scan.
AreaCorner hung(const Eigen::Vector2d& at, const std::map<std::uint64_t, KeyScanState>& scans,
                const std::vector<ScanInPart>& parts) {
    const KeyScanState* nearest = nullptr;
    double least = std::numeric_limits<double>::infinity();
    auto inPart = parts.begin();
    for (const auto& [id, scan] : scans) {
        const bool aside = (inPart++)->part != 0;  // for show only: where it lies means nothing
        const double distance = (scan.pose.scanInMap.translation().head<2>() - at).norm();
        if (scan.pose.trust != ScanTrust::Certain || aside || distance >= least) continue;
        least = distance;
        nearest = &scan;
    }
    if (nearest == nullptr) return {at, 0, Pose::Identity()};
    return {at, nearest->entry.id, nearest->pose.scanInMap};
}

/// Hangs the area of @p state on @p scans, which are as they were when it was drawn.
void hangArea(MissionState& state, const std::map<std::uint64_t, KeyScanState>& scans) {
    std::vector<ScanInPart> parts = scansInParts(scans);
    findParts(parts, MapParts({}));
    CropState crop = *state.crop;
    crop.corners.clear();
    for (const Eigen::Vector2d& corner : crop.sample.polygon)
        crop.corners.push_back(hung(corner, scans, parts));
    state.crop = std::make_shared<const CropState>(std::move(crop));
}

/// Does the same for decisions that were read together: what was undone later still stood then.
void hangArea(MissionState& state) {
    if (!state.crop || state.crop->sample.polygon.empty()) return;
    MissionState then;
    std::vector<Decision>& decisions = then.decisions.edit();
    std::copy_if(state.decisions->begin(), state.decisions->end(), std::back_inserter(decisions),
                 [&](const Decision& decision) { return decision.sequence < state.crop->sequence; });
    apply(then);
    hangArea(state, *then.keyScans);
}

/// Adds a remark for each scan that @p decision names and the mission does not have.
void notifyUnknown(MissionState& state, const Decision& decision) {
    const auto* poses = std::get_if<ScanPosesSample>(&decision.content);
    if (poses == nullptr) return;
    for (const ScanPose& pose : poses->poses) {
        if (state.keyScans->contains(pose.scan)) continue;
        remark(state, decision.sequence,
               fmt::format("a pose for key scan {}: expected a scan of the mission", pose.scan));
    }
}

}  // namespace

void remark(MissionState& state, std::uint64_t sequence, std::string text) {
    auto& remarks = state.remarks.edit();
    if (remarks.size() == MissionState::MaxRemarks) remarks.erase(remarks.begin());
    remarks.push_back({sequence, std::move(text)});
}

void decide(MissionState& state, Decision decision) {
    const auto* undo = std::get_if<UndoSample>(&decision.content);
    if (undo == nullptr) {
        notifyUnknown(state, decision);
        Effects(state).apply(decision);
        if (std::holds_alternative<MapCropSample>(decision.content)) hangArea(state, *state.keyScans);
        state.decisions.edit().push_back(std::move(decision));
        return;
    }
    const Decision* target = decisionAt(state, undo->event);
    if (target == nullptr) {
        remark(state, decision.sequence,
               fmt::format("undo of event {}: expected a decision of the mission before it", undo->event));
        return;
    }
    if (target->undone) {
        remark(state, decision.sequence, fmt::format("undo of event {}: it is undone already", undo->event));
    }
    state.decisions.edit().push_back(std::move(decision));
    reconsider(state);
}

void reconsider(MissionState& state) {
    apply(state);
    hangArea(state);
}

}  // namespace leitstand
