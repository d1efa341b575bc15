#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/base/pose.h"
#include "core/base/progress.h"
#include "core/base/time.h"
#include "core/mapping/comparison/found_victims.h"
#include "core/mapping/comparison/trajectory_error.h"
#include "core/mapping/map.h"
#include "core/mapping/registration_settings.h"

namespace leitstand {

/// How well a scan meets the one before it.
struct ScanFit {
    double rms = 0.0;      ///< of pairs within IcpResult::OverlapDistance [m]
    double overlap = 0.0;  ///< share of its points that have such a partner
};

/// A key scan of a mission, where it was recorded and where it comes to be when it is registered again.
struct ComparedScan {
    std::uint64_t id = 0;
    std::string robot;
    Time end{};                            ///< of the sweep, robot's clock
    ScanPtr scan;                          ///< never null
    Pose sensorInBase = Pose::Identity();  ///< then
    Pose recorded = Pose::Identity();      ///< scan in map
    Pose again = Pose::Identity();         ///< likewise
    bool uncertainRecorded = false, uncertainAgain = false;
    std::optional<ScanFit> fitRecorded{}, fitAgain{};  ///< empty: a robot's first, or it has no points
};

/// A map in figures.
struct MapFigures {
    int uncertain = 0;                       ///< scans
    double rms = 0.0, overlap = 0.0;         ///< means over scans
    double path = 0.0;                       ///< way of the robots from scan to scan [m]
    std::optional<double> seconds{};         ///< that registering took; empty: nobody knows
    std::optional<TrajectoryError> truth{};  ///< empty: the mission does not hold it
    std::optional<FindsError> finds{};       ///< likewise, or not of its victims
};

/// The map of a mission as it was recorded beside that which other settings make of the same scans.
struct MapComparison {
    RegistrationSettings settings;
    std::vector<ComparedScan> scans;  ///< by id
    int rejected = 0;                 ///< scans that were set aside; they take no part
    MapFigures recorded, again;
    double meanMoved = 0.0, mostMoved = 0.0;    ///< of scans, from recorded to again [m]
    double meanTurned = 0.0, mostTurned = 0.0;  ///< likewise [rad]
};
using MapComparisonPtr = std::shared_ptr<const MapComparison>;

/// Registers @p scans again, those of each robot for themselves, its first where it was recorded, and
/// measures both maps with the same yardstick. Nothing when cancelled.
[[nodiscard]] std::optional<MapComparison> registeredAgain(std::vector<ComparedScan> scans,
                                                           const RegistrationSettings& settings,
                                                           const Progress& progress = {});

/// Fills in what @p whole's scans sum up to: scans that are uncertain, means, ways, and how far scans moved.
void sumUp(MapComparison& whole);

/// Which map of a comparison is shown.
enum class ComparedMap : std::uint8_t {
    Recorded,
    Again,
    Both,  ///< the recorded one without labels (grey) and without ceilings, the other one as always
};
[[nodiscard]] MapPtr mapOf(const MapComparison& comparison, ComparedMap which);

}  // namespace leitstand
