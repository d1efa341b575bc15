#include "core/mission/undo.h"

#include <algorithm>
#include <variant>

#include <fmt/format.h>

namespace leitstand {
namespace {

/// The operator's decision on scans that @p decision is; null: another kind, or another station's.
const ScanPosesSample* decided(const Decision& decision, const std::string& station) {
    const auto* poses = std::get_if<ScanPosesSample>(&decision.content);
    const bool ours = poses != nullptr && poses->cause == ScanPosesSample::Cause::Operator &&
                      poses->station == station && !poses->poses.empty();
    return ours ? poses : nullptr;
}

std::string inWords(const ScanPosesSample& decision) {
    const auto& poses = decision.poses;
    const bool aside = std::all_of(poses.begin(), poses.end(),
                                   [](const ScanPose& pose) { return pose.trust == ScanTrust::SetAside; });
    const auto scans = poses.size() == 1 ? fmt::format("scan {}", poses.front().scan)
                                         : fmt::format("{} scans", poses.size());
    return scans + (aside ? " set aside" : poses.front().trust == ScanTrust::Certain ? " taken" : " tried");
}

}  // namespace

std::optional<UndoSample> undoOfScans(const MissionState& state, const std::string& station, Time now) {
    const auto& all = *state.decisions;
    for (auto decision = all.rbegin(); decision != all.rend(); ++decision) {
        const ScanPosesSample* poses = decided(*decision, station);
        if (poses != nullptr && !decision->undone)
            return UndoSample{now, station, decision->sequence, "undo: " + inWords(*poses)};
    }
    return std::nullopt;
}

std::optional<UndoSample> redoOfScans(const MissionState& state, const std::string& station, Time now) {
    const auto& all = *state.decisions;
    for (auto decision = all.rbegin(); decision != all.rend(); ++decision) {
        if (decision->undone) continue;
        if (decided(*decision, station) != nullptr) return std::nullopt;  // made since
        const auto* undo = std::get_if<UndoSample>(&decision->content);
        if (undo == nullptr || undo->station != station) continue;
        const Decision* target = decisionAt(state, undo->event);
        const ScanPosesSample* poses = target != nullptr ? decided(*target, station) : nullptr;
        if (poses != nullptr && target->undone)
            return UndoSample{now, station, decision->sequence, "redo: " + inWords(*poses)};
    }
    return std::nullopt;
}

}  // namespace leitstand
