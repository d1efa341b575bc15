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

/// The mission that a map with scans of @p robot, "kurt3d@monday", was carried from; empty: from none.
[[nodiscard]] std::string carriedFrom(const std::string& robot);

/// Key scans of a map that were taken on two occasions.
struct Visits {
    std::set<std::uint64_t> before, after;  ///< ids
    /// Of the mission that those after were carried here from; empty: of this one.
    std::string name;
    std::set<std::string> earlier;  ///< likewise, of those before
};

/// The visits of a map of @p scans: the newest of the missions that it is put together from (behind the @ of
/// its robots' names; by the numbers of their scans, since robots' clocks may say anything), and those
/// before. Both are empty where it is of one alone.
[[nodiscard]] Visits visitsOf(std::span<const ReportScan> scans);

/// How a change is told from what is merely seen from elsewhere.
struct ChangeSettings {
    FreeSpaceSettings looking = {
        .margin = 0.2F, .marginOfRange = 0.03F, .nearest = 0.5F, .beside = false, .rays = 2};
    double reach = 8.0;      ///< scans so near each other have a say in each other [m]
    std::size_t scans = 10;  ///< of either visit so many, the nearest
    double edge = 0.1;       ///< of the grid: one point of each cell of a scan is asked about [m]
    int looksThrough = 2;    ///< so many scans of the other visit at least looked through ...
    int oftener = 3;         ///< ... and so many times as many as saw something there
    double linked = 0.25;    ///< cells so near each other are of one thing [m]
    std::size_t least = 20;  ///< cells of a thing; less is noise
    /// Deviation of its cells along its second axis [m]: of what is thinner in two directions scans miss one
    /// another's edges.
    double thinnest = 0.07;
};

/// Something that stands in the map of one visit where the other one looked through.
struct ChangedThing {
    bool isNew = false;                  ///< else it is gone
    Eigen::AlignedBox3d box;             ///< in the map [m]
    std::vector<Eigen::Vector3f> cells;  ///< places on it, ChangeSettings::edge apart, in the map [m]
    std::uint64_t scan = 0;              ///< the key scan that saw most of it
};

/// What changed in a map since the visits before.
struct MapChanges {
    Visits visits;
    std::size_t compared = 0;          ///< scans; none: the visits' maps have not met
    std::vector<ChangedThing> things;  ///< largest first
};

/// What came and what went in a map of @p scans, between its visitsOf(): points of scans of the one where
/// scans of the other looked through, and which others of its own visit saw, too, or at least did not look
/// through (after the votes of scans on points: Pomerleau et al. 2014). What nobody looked at the other time
/// is no change. Cancelled: nothing is compared.
[[nodiscard]] MapChanges changesOf(std::span<const ReportScan> scans, const ChangeSettings& settings = {},
                                   const Progress& progress = {});

}  // namespace leitstand
