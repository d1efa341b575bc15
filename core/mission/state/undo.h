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

/// A decision on the map that the operator may take back or do again.
struct MapDecision {
    enum class Kind {
        Taken,     ///< scans count
        SetAside,  ///< scans do not count
        Tried,     ///< scans were registered again, and are still doubted
        Crop,      ///< the area that belongs to the map
        Loop,      ///< the map was joined where it meets itself
        Refused,   ///< the map was not joined there: it is another place
    };
    Kind kind = Kind::Taken;
    std::vector<std::uint64_t> scans;  ///< by id
    std::uint64_t event = 0;           ///< sequence that the UndoSample must name
};
/// Returns what an undo of @p decision takes back.
[[nodiscard]] UndoneThing undoneThing(const MapDecision& decision);

/// Returns the newest decision on the map that the operator of @p station made and that is not taken back;
/// empty: there is none.
[[nodiscard]] std::optional<MapDecision> undoable(const MissionState& state, const std::string& station);
/// Returns the decision on the map that @p station took back last, with the event of that undo. Empty: none
/// was taken back, or the operator decided something since.
[[nodiscard]] std::optional<MapDecision> redoable(const MissionState& state, const std::string& station);

/// Returns the newest loop closure, by itself or by hand, that is not taken back; empty: there is none.
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
