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

/// How well a scan fits the scan before it.
struct ScanFit {
    double rms = 0.0;      ///< root mean square distance of point pairs within IcpResult::OverlapDistance [m]
    double overlap = 0.0;  ///< share of its points that have a partner within that distance
};

/// A key scan of a mission, with its recorded pose and its pose after it was registered again.
struct ComparedScan {
    std::uint64_t id = 0;
    std::string robot;
    Time end{};                            ///< when the sweep ended, by the robot's clock
    ScanPtr scan;                          ///< never null
    Pose sensorInBase = Pose::Identity();  ///< pose at `end`
    Pose recorded = Pose::Identity();      ///< scan in map, as recorded
    Pose again = Pose::Identity();         ///< scan in map, registered again
    bool uncertainRecorded = false, uncertainAgain = false;
    /// Empty: the first scan of a robot, or a scan without points.
    std::optional<ScanFit> fitRecorded{}, fitAgain{};
};

/// A map in figures.
struct MapFigures {
    int uncertain = 0;                       ///< number of uncertain scans
    double rms = 0.0, overlap = 0.0;         ///< means of ScanFit over the scans
    double path = 0.0;                       ///< distance that the robots moved, summed from scan to scan [m]
    std::optional<double> seconds{};         ///< duration of the registration; empty: unknown
    std::optional<TrajectoryError> truth{};  ///< empty: the mission has no true poses
    std::optional<FindsError> finds{};       ///< empty: the mission has no true victims
};

/// The recorded map of a mission, and the map that other settings make of the same scans.
struct MapComparison {
    RegistrationSettings settings;
    std::vector<ComparedScan> scans;  ///< by id
    int rejected = 0;  ///< number of scans that were set aside in the mission; they are not compared
    MapFigures recorded, again;
    /// How far scans moved from the recorded pose to the new one [m].
    double meanMoved = 0.0, mostMoved = 0.0;
    /// How far scans turned from the recorded pose to the new one [rad].
    double meanTurned = 0.0, mostTurned = 0.0;
};
using MapComparisonPtr = std::shared_ptr<const MapComparison>;

/// Registers @p scans again and measures both maps in the same way. The scans of each robot are registered
/// separately, beginning at the recorded pose of its first scan. Empty: cancelled.
[[nodiscard]] std::optional<MapComparison> registeredAgain(std::vector<ComparedScan> scans,
                                                           const RegistrationSettings& settings,
                                                           const Progress& progress = {});

/// Computes the figures of @p whole from its scans: uncertain scans, means, paths, and how far scans moved.
void sumUp(MapComparison& whole);

/// Which map of a comparison is shown.
enum class ComparedMap : std::uint8_t {
    Recorded,
    Again,
    Both,  ///< the recorded map in grey without labels and ceilings, the new map as usual
};
[[nodiscard]] MapPtr mapOf(const MapComparison& comparison, ComparedMap which);

}  // namespace leitstand
