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

/// An event that undo can take back, and whether it is undone. All decisions are kept in order, so that a
/// timeline can jump to each.
struct Decision {
    std::uint64_t sequence = 0;
    Time received{};      ///< station's clock
    bool undone = false;  ///< by an undo that is not undone itself
    /// A ScanLinksSample holds only those of its links that close loops.
    std::variant<FindSample, NoteSample, ScanPosesSample, KeyScanEntry, UndoSample, MapCropSample,
                 ScanLinksSample, ScanBodiesSample>
        content;
};

/// A link that closes a loop, as the newest decision that is not undone has it.
struct LoopState {
    std::uint64_t sequence = 0;  ///< of that decision
    Link link;
};

}  // namespace leitstand
