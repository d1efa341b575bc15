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
#include "core/mapping/live/loops/places/free_space.h"
#include "core/mapping/report_scan.h"

namespace leitstand {

/// Returns the mission from which the scans of @p robot were taken over: "monday" for "kurt3d@monday". Empty:
/// the scans are of the present mission.
[[nodiscard]] std::string carriedFrom(const std::string& robot);

/// The key scans of a map, divided by when they were taken: in its newest mission, or before.
struct Visits {
    /// Ids of the key scans before, and of those in the newest mission.
    std::set<std::uint64_t> before, after;
    /// Mission of the scans in `after`, if they were taken over from another one; empty: the present one.
    std::string name;
    std::set<std::string> earlier;  ///< missions of the scans in `before`
};

/// Divides the scans of a map that is put together from several missions. `after` has the scans of the newest
/// mission, `before` has all others. A mission's name is behind the @ of its robots' names. The present
/// mission, whose robots have no @, is the newest. Without its scans, the mission with the highest scan
/// number is, since robots' clocks are not reliable. Both sets are empty for a map of a single mission.
[[nodiscard]] Visits visitsOf(std::span<const ReportScan> scans);

/// How a change is distinguished from something that is merely seen from elsewhere.
struct ChangeSettings {
    FreeSpaceSettings looking = {
        .margin = 0.2F, .marginOfRange = 0.03F, .nearest = 0.5F, .beside = false, .rays = 2};
    double reach = 8.0;      ///< largest distance between scans that judge each other [m]
    std::size_t scans = 10;  ///< largest number of scans of each visit that judge a scan: the nearest
    double edge = 0.1;       ///< edge of a grid cell; of each scan, one point per cell is judged [m]
    int looksThrough = 2;    ///< least number of scans of the other visit that looked through a change ...
    int oftener = 3;         ///< ... and how many times as many as saw something there, at least
    double linked = 0.25;    ///< largest distance between neighbouring cells of one thing [m]
    std::size_t least = 20;  ///< least number of cells of a thing; fewer are noise
    /// Least standard deviation of a thing's cells along their second principal axis [m]. Things that are
    /// thinner in two directions are left out: scans miss each other's edges.
    double thinnest = 0.07;
};

/// Something in the map of one visit where the other visit looked through.
struct ChangedThing {
    bool isNew = false;                  ///< true: it came; false: it is gone
    Eigen::AlignedBox3d box;             ///< in the map [m]
    std::vector<Eigen::Vector3f> cells;  ///< places on it, ChangeSettings::edge apart, in the map [m]
    std::uint64_t scan = 0;              ///< the key scan that saw most of it
};

/// What changed in a map since the visits before.
struct MapChanges {
    Visits visits;
    /// Number of scans with scans of the other visit nearby; 0: the two visits do not overlap.
    std::size_t compared = 0;
    std::vector<ChangedThing> things;  ///< largest first
};

/// Returns what came and what went between the visits of @p scans (visitsOf()). A point of one visit is a
/// change if scans of the other visit looked through it. It is none if scans of its own visit mostly looked
/// through it, too: then something passed by (votes of scans on points, after Pomerleau et al. 2014). Space
/// that the other visit did not look at holds no change. Cancelled: nothing is compared.
[[nodiscard]] MapChanges changesOf(std::span<const ReportScan> scans, const ChangeSettings& settings = {},
                                   const Progress& progress = {});

}  // namespace leitstand
