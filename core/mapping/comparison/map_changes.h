#pragma once

#include <cstddef>
#include <cstdint>
#include <set>
#include <span>
#include <string>
#include <vector>

#include <Eigen/Core>
#include <Eigen/Geometry>

#include "core/base/progress.h"
#include "core/mapping/live/loops/free_space.h"
#include "core/mapping/report_scan.h"

namespace leitstand {

/// Returns the mission that scans of @p robot ("kurt3d@monday") were carried from; empty: none.
[[nodiscard]] std::string carriedFrom(const std::string& robot);

/// Key scans of a map that were taken on two occasions.
struct Visits {
    std::set<std::uint64_t> before, after;  ///< ids
    /// The mission that the scans after were carried here from; empty: this one.
    std::string name;
    std::set<std::string> earlier;  ///< missions of the scans before
};

/// Returns the visits of a map of @p scans: those of the newest mission that it is put together from, and
/// those before. A mission's name is behind the @ of its robots' names. The newest one has the highest scan
/// numbers, since robots' clocks are not reliable. Both are empty for a map of a single mission.
[[nodiscard]] Visits visitsOf(std::span<const ReportScan> scans);

/// How a change is distinguished from something that is merely seen from elsewhere.
struct ChangeSettings {
    FreeSpaceSettings looking = {
        .margin = 0.2F, .marginOfRange = 0.03F, .nearest = 0.5F, .beside = false, .rays = 2};
    double reach = 8.0;      ///< scans so near each other judge each other [m]
    std::size_t scans = 10;  ///< of either visit that judge a scan, the nearest
    double edge = 0.1;       ///< of the grid: one point per cell of a scan is judged [m]
    int looksThrough = 2;    ///< least scans of the other visit that looked through ...
    int oftener = 3;         ///< ... and least multiple of those that saw something there
    double linked = 0.25;    ///< cells so near each other belong to one thing [m]
    std::size_t least = 20;  ///< cells of a thing; fewer are noise
    /// Least deviation of its cells along its second axis [m]. Of things that are thinner in two directions,
    /// scans miss each other's edges.
    double thinnest = 0.07;
};

/// Something in the map of one visit where the other visit looked through.
struct ChangedThing {
    bool isNew = false;                  ///< else it is gone
    Eigen::AlignedBox3d box;             ///< in the map [m]
    std::vector<Eigen::Vector3f> cells;  ///< places on it, ChangeSettings::edge apart, in the map [m]
    std::uint64_t scan = 0;              ///< the key scan that saw most of it
};

/// What changed in a map since the visits before.
struct MapChanges {
    Visits visits;
    std::size_t compared = 0;          ///< scans; 0: the visits' maps have not met
    std::vector<ChangedThing> things;  ///< largest first
};

/// Returns what came and what went in a map of @p scans, between its visitsOf(). A change is a point of one
/// visit that scans of the other looked through. Other scans of its own visit saw it too, or at least did not
/// look through it (after the votes of scans on points: Pomerleau et al. 2014). Space that the other visit
/// did not look at holds no change. Cancelled: nothing is compared.
[[nodiscard]] MapChanges changesOf(std::span<const ReportScan> scans, const ChangeSettings& settings = {},
                                   const Progress& progress = {});

}  // namespace leitstand
