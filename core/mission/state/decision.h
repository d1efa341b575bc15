#pragma once

#include <cstdint>
#include <variant>

#include "core/base/time.h"
#include "core/event/find_sample.h"
#include "core/event/map_samples.h"
#include "core/event/scan_bodies.h"
#include "core/event/scan_links.h"
#include "core/event/station_samples.h"
#include "core/mission/state/scan_state.h"

namespace leitstand {

/// An event that can be undone, and whether it is undone. All decisions are kept in order, so that a timeline
/// can show each of them.
struct Decision {
    std::uint64_t sequence = 0;
    Time received{};      ///< when it was received, station's clock
    bool undone = false;  ///< whether there is an undo of it that is not undone itself
    /// A ScanLinksSample has only its loop links here.
    std::variant<FindSample, NoteSample, ScanPosesSample, KeyScanEntry, UndoSample, MapCropSample,
                 ScanLinksSample, ScanBodiesSample>
        content;
};

/// A link that closes a loop, from the newest decision about it that is not undone.
struct LoopState {
    std::uint64_t sequence = 0;  ///< sequence of that decision
    Link link;
};

}  // namespace leitstand
