#include "core/mission/state/undo.h"

#include <algorithm>
#include <variant>

#include "core/event/map_samples.h"
#include "core/event/scan_links.h"
#include "core/event/scan_pose.h"
#include "core/mission/state/decision.h"
#include "core/mission/state/scan_state.h"

namespace leitstand {
namespace {

using Kind = MapDecision::Kind;

MapDecision scansOf(const ScanPosesSample& decision) {
    const auto& poses = decision.poses;
    const bool aside = std::all_of(poses.begin(), poses.end(),
                                   [](const ScanPose& pose) { return pose.trust == ScanTrust::SetAside; });
    const bool certain = poses.front().trust == ScanTrust::Certain;
    MapDecision decided{aside ? Kind::SetAside : certain ? Kind::Taken : Kind::Tried, {}, 0};
    for (const ScanPose& pose : poses) decided.scans.push_back(pose.scan);
    return decided;
}

/// Returns @p decision as one of the operator on the map; empty: another kind, or another station's.
std::optional<MapDecision> onMap(const Decision& decision, const std::string& station) {
    std::optional<MapDecision> decided;
    if (const auto* poses = std::get_if<ScanPosesSample>(&decision.content)) {
        const bool ours = poses->cause == ScanPosesSample::Cause::Operator && poses->station == station;
        if (ours && !poses->poses.empty()) decided = scansOf(*poses);
    } else if (const auto* crop = std::get_if<MapCropSample>(&decision.content)) {
        if (crop->station == station) decided = MapDecision{Kind::Crop, {}, 0};
    } else if (const auto* links = std::get_if<ScanLinksSample>(&decision.content)) {
        const bool ours = links->station == station &&
                          std::all_of(links->links.begin(), links->links.end(),
                                      [](const Link& link) { return link.kind == LinkKind::Operator; });
        const bool closes = std::any_of(links->links.begin(), links->links.end(),
                                        [](const Link& link) { return link.active; });
        if (ours) decided = MapDecision{closes ? Kind::Loop : Kind::Refused, {}, 0};
    }
    if (decided) decided->event = decision.sequence;
    return decided;
}

/// Returns the loop that @p decision closed; empty: another kind.
std::optional<MapDecision> loopOf(const Decision& decision) {
    const auto* sample = std::get_if<ScanLinksSample>(&decision.content);
    const bool closes = sample != nullptr && std::any_of(sample->links.begin(), sample->links.end(),
                                                         [](const Link& link) { return link.active; });
    if (!closes) return std::nullopt;
    return MapDecision{Kind::Loop, {}, decision.sequence};
}

}  // namespace

UndoneThing undoneThing(const MapDecision& decision) {
    UndoneThing thing;
    thing.scans = decision.scans.size();
    if (thing.scans == 1) thing.scan = decision.scans.front();
    switch (decision.kind) {
        case Kind::Taken:
            thing.kind = UndoneThing::Kind::Taken;
            break;
        case Kind::SetAside:
            thing.kind = UndoneThing::Kind::SetAside;
            break;
        case Kind::Tried:
            thing.kind = UndoneThing::Kind::Tried;
            break;
        case Kind::Crop:
            thing.kind = UndoneThing::Kind::Crop;
            break;
        case Kind::Loop:
            thing.kind = UndoneThing::Kind::Loop;
            break;
        case Kind::Refused:
            thing.kind = UndoneThing::Kind::RefusedLoop;
            break;
    }
    return thing;
}

std::optional<MapDecision> undoable(const MissionState& state, const std::string& station) {
    const auto& all = *state.decisions;
    for (auto decision = all.rbegin(); decision != all.rend(); ++decision) {
        if (decision->undone) continue;
        if (auto decided = onMap(*decision, station)) return decided;
    }
    return std::nullopt;
}

std::optional<MapDecision> lastLoop(const MissionState& state) {
    const auto& all = *state.decisions;
    for (auto decision = all.rbegin(); decision != all.rend(); ++decision) {
        const auto* sample = std::get_if<ScanLinksSample>(&decision->content);
        if (sample == nullptr || decision->undone) continue;
        // A loop that was removed since, because it contradicts the rest, does not count.
        const bool stands = std::any_of(sample->links.begin(), sample->links.end(), [&](const Link& link) {
            const auto now = state.loops->find(link.id);
            return link.active && now != state.loops->end() && now->second.link.active;
        });
        if (stands) return loopOf(*decision);
    }
    return std::nullopt;
}

std::optional<MapDecision> redoable(const MissionState& state, const std::string& station) {
    const auto& all = *state.decisions;
    for (auto decision = all.rbegin(); decision != all.rend(); ++decision) {
        if (decision->undone) continue;
        if (onMap(*decision, station)) return std::nullopt;  // made since
        const auto* undo = std::get_if<UndoSample>(&decision->content);
        if (undo == nullptr || undo->station != station) continue;
        const Decision* target = decisionAt(state, undo->event);
        if (target == nullptr || !target->undone) continue;
        auto decided = onMap(*target, station);
        if (!decided) decided = loopOf(*target);
        if (!decided) continue;
        decided->event = decision->sequence;
        return decided;
    }
    return std::nullopt;
}

std::optional<UndoSample> undoOnMap(const MissionState& state, const std::string& station, Time now) {
    const auto decision = undoable(state, station);
    if (!decision) return std::nullopt;
    return UndoSample{now, station, decision->event, undoText(undoneThing(*decision))};
}

std::optional<UndoSample> undoLoop(const MissionState& state, const std::string& station, Time now) {
    const auto loop = lastLoop(state);
    if (!loop) return std::nullopt;
    return UndoSample{now, station, loop->event, undoText(undoneThing(*loop))};
}

std::optional<UndoSample> redoOnMap(const MissionState& state, const std::string& station, Time now) {
    const auto decision = redoable(state, station);
    if (!decision) return std::nullopt;
    UndoneThing thing = undoneThing(*decision);
    thing.again = true;
    return UndoSample{now, station, decision->event, undoText(thing)};
}

}  // namespace leitstand
