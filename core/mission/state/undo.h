#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "core/base/time.h"
#include "core/event/station_samples.h"
#include "core/mission/state/mission_state.h"
#include "core/mission/state/undo_format.h"

namespace leitstand {

/// A decision about the map that the operator can undo or redo.
struct MapDecision {
    enum class Kind {
        Taken,     ///< scans were accepted
        SetAside,  ///< scans were set aside
        Tried,     ///< scans were registered again, and are still uncertain
        Crop,      ///< the area that belongs to the map was set
        Loop,      ///< the map was joined at a place that was mapped twice
        Refused,   ///< the map was not joined at a possible loop: it is another place
    };
    Kind kind = Kind::Taken;
    std::vector<std::uint64_t> scans;  ///< ids of the scans
    std::uint64_t event = 0;           ///< sequence to name in the UndoSample
};
/// Returns what an undo of @p decision undoes, for the text of the UndoSample.
[[nodiscard]] UndoneThing undoneThing(const MapDecision& decision);

/// Returns the newest decision about the map that the operator of @p station made and did not undo; empty:
/// there is none.
[[nodiscard]] std::optional<MapDecision> undoable(const MissionState& state, const std::string& station);
/// Returns the decision about the map that @p station undid last, with the event of that undo. Empty: none
/// was undone, or the operator made another decision since.
[[nodiscard]] std::optional<MapDecision> redoable(const MissionState& state, const std::string& station);

/// Returns the newest loop closure that is not undone, whether automatic or by hand; empty: there is none.
[[nodiscard]] std::optional<MapDecision> lastLoop(const MissionState& state);
/// Returns the undo of lastLoop(); empty when there is none.
[[nodiscard]] std::optional<UndoSample> undoLoop(const MissionState& state, const std::string& station,
                                                 Time now);

/// Returns the undo of undoable(); empty when there is none.
[[nodiscard]] std::optional<UndoSample> undoOnMap(const MissionState& state, const std::string& station,
                                                  Time now);
/// Returns the redo of redoable(); empty when there is none.
[[nodiscard]] std::optional<UndoSample> redoOnMap(const MissionState& state, const std::string& station,
                                                  Time now);

}  // namespace leitstand
