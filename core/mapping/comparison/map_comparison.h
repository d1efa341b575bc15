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

/// How well a scan fits onto the scan before it.
struct ScanFit {
    double rms = 0.0;      ///< root mean square distance of pairs within IcpResult::OverlapDistance [m]
    double overlap = 0.0;  ///< share of its points that have a partner within that distance
};

/// A key scan of a mission, with its recorded pose and its pose when registered again.
struct ComparedScan {
    std::uint64_t id = 0;
    std::string robot;
    Time end{};                            ///< of the sweep, robot's clock
    ScanPtr scan;                          ///< never null
    Pose sensorInBase = Pose::Identity();  ///< at `end`
    Pose recorded = Pose::Identity();      ///< scan in map, as recorded
    Pose again = Pose::Identity();         ///< scan in map, registered again
    bool uncertainRecorded = false, uncertainAgain = false;
    std::optional<ScanFit> fitRecorded{}, fitAgain{};  ///< empty: a robot's first scan, or one without points
};

/// A map in figures.
struct MapFigures {
    int uncertain = 0;                       ///< number of uncertain scans
    double rms = 0.0, overlap = 0.0;         ///< means of ScanFit over the scans
    double path = 0.0;                       ///< of the robots, from scan to scan [m]
    std::optional<double> seconds{};         ///< duration of the registration; empty: unknown
    std::optional<TrajectoryError> truth{};  ///< empty: the mission holds none
    std::optional<FindsError> finds{};       ///< empty: the mission holds no true victims
};

/// The recorded map of a mission, beside the map that other settings make of the same scans.
struct MapComparison {
    RegistrationSettings settings;
    std::vector<ComparedScan> scans;  ///< by id
    int rejected = 0;  ///< number of scans that were set aside in the mission; they take no part
    MapFigures recorded, again;
    double meanMoved = 0.0, mostMoved = 0.0;    ///< of scans, from recorded to again [m]
    double meanTurned = 0.0, mostTurned = 0.0;  ///< of scans, from recorded to again [rad]
};
using MapComparisonPtr = std::shared_ptr<const MapComparison>;

/// Registers @p scans again and measures both maps in the same way. Each robot's scans are registered on
/// their own, beginning at the recorded pose of its first scan. Empty: cancelled.
[[nodiscard]] std::optional<MapComparison> registeredAgain(std::vector<ComparedScan> scans,
                                                           const RegistrationSettings& settings,
                                                           const Progress& progress = {});

/// Computes the figures of @p whole from its scans: uncertain scans, means, paths, and how far scans moved.
void sumUp(MapComparison& whole);

/// Which map of a comparison is shown.
enum class ComparedMap : std::uint8_t {
    Recorded,
    Again,
    Both,  ///< the recorded map in grey, without labels and ceilings, and the other one as always
};
[[nodiscard]] MapPtr mapOf(const MapComparison& comparison, ComparedMap which);

}  // namespace leitstand
