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

/// Functions that are called on the mapping's thread and must not block it.
struct LiveMappingListener {
    /// For the log: places of robots, found by their laser, by scans of other robots, by the operator, or by
    /// a search.
    std::function<void(const RobotPlaceSample&)> onPlace = {};
    std::function<void(const MapUpdate&)> onUpdate = {};  ///< for the log, in order
    /// For the log: links with a place that was recognised far away, or in another part of the map.
    std::function<void(const ScanLinksSample&)> onLoop = {};
    std::function<void(const Settled&)> onSettled = {};  ///< for the log, after a loop closed or an undo
    /// For the log, without a station's name: passers-by, and other robots in scans that entered before these
    /// robots were placed.
    std::function<void(ScanBodiesSample)> onBodies = {};
    /// A search for a robot failed: @p alike places of the map look like what the robot sees; 0: no place
    /// does.
    std::function<void(const std::string& robot, std::size_t alike)> onLookedFor = {};
    /// Called with what the map shows about a robot's scanner, when the suggested correction changes
    /// noticeably.
    std::function<void(const std::string& robot, const ScannerFinding&)> onScanner = {};
    /// Called with the topic of the clouds that make the map from now on, for a robot with several scanners.
    std::function<void(const std::string& robot, const std::string& topic)> onMapsWith = {};
    std::function<bool()> makesMap = {};  ///< returns whether this station makes the map; empty: it does
    /// Called after a scan entered or moved, or after a decision about one.
    std::function<void(const LiveMapPtr&)> onMap = {};
};

}  // namespace leitstand
