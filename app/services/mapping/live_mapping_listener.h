#pragma once

#include <cstddef>
#include <functional>
#include <string>

#include "core/event/map_samples.h"
#include "core/event/scan_bodies.h"
#include "core/event/scan_links.h"
#include "core/mapping/calibration/scanner_calibration.h"
#include "core/mapping/live/live_mapper.h"

namespace leitstand {

/// Called on the mapping's thread, which they must not block.
struct LiveMappingListener {
    std::function<void(const RobotPlaceSample&)> onPlace =
        {};  ///< places for the log, of robots that do not make the map
    std::function<void(const MapUpdate&)> onUpdate = {};  ///< for the log, in order
    /// For the log: a place was recognised far off, or in another part of the map.
    std::function<void(const ScanLinksSample&)> onLoop = {};
    std::function<void(const Settled&)> onSettled = {};  ///< for the log, after a loop closed or an undo
    /// For the log, without a station: other robots in a scan that entered before they were placed, and
    /// passers-by.
    std::function<void(ScanBodiesSample)> onBodies = {};
    /// A search for a robot in the whole map failed: @p alike places look like what it sees, or none.
    std::function<void(const std::string& robot, std::size_t alike)> onLookedFor = {};
    /// What the map advises about a robot's scanner. Called when it changes noticeably.
    std::function<void(const std::string& robot, const ScannerFinding&)> onScanner = {};
    std::function<bool()> makesMap = {};  ///< whether our poses of scans are valid; empty: they are
    std::function<void(const LiveMapPtr&)> onMap = {};  ///< after a scan entered or moved, or was decided on
};

}  // namespace leitstand
