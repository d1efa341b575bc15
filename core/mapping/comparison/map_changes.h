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

/// Returns the mission from which the scans of @p robot were taken: "monday" for "kurt3d@monday". Empty: they
/// are scans of the present mission.
[[nodiscard]] std::string carriedFrom(const std::string& robot);

/// The key scans of a map in two groups: those of its newest mission, and those of earlier missions.
struct Visits {
    /// Ids of the earlier key scans, and of those in the newest mission.
    std::set<std::uint64_t> before, after;
    /// Mission that the scans in `after` were taken from; empty: the present mission.
    std::string name;
    std::set<std::string> earlier;  ///< missions of the scans in `before`
};

/// Divides the scans of a map that is put together from several missions. `after` has the scans of the newest
/// mission, `before` has all others. The name of a robot in an earlier mission ends in "@MISSION". The
/// present mission, whose robots have no @, is the newest. If it has no scans, the newest mission is the one
/// with the highest scan number, since robots' clocks are not reliable. Both sets are empty for a map of a
/// single mission.
[[nodiscard]] Visits visitsOf(std::span<const ReportScan> scans);

/// How a real change is distinguished from something that is only seen from another side.
struct ChangeSettings {
    FreeSpaceSettings looking = {
        .margin = 0.2F, .marginOfRange = 0.03F, .nearest = 0.5F, .beside = false, .rays = 2};
    double reach = 8.0;      ///< largest distance between scans that judge each other [m]
    std::size_t scans = 10;  ///< a scan is judged by at most this many nearest scans of each visit
    double edge = 0.1;       ///< edge of a grid cell [m]; one point per cell of each scan is judged
    int looksThrough = 2;    ///< least number of scans of the other visit that looked through a change ...
    int oftener = 3;         ///< ... and at least this many times as many as saw something there
    double linked = 0.25;    ///< largest distance between neighbouring cells of one thing [m]
    std::size_t least = 20;  ///< things with fewer cells are noise
    /// Least standard deviation of a thing's cells along their second principal axis [m]. Things that are
    /// thinner in two directions are left out: scans miss each other's edges.
    double thinnest = 0.07;
};

/// Something that one visit saw where the other visit saw free space.
struct ChangedThing {
    bool isNew = false;                  ///< true: it appeared; false: it disappeared
    Eigen::AlignedBox3d box;             ///< in the map [m]
    std::vector<Eigen::Vector3f> cells;  ///< points of the thing, ChangeSettings::edge apart, in the map [m]
    std::uint64_t scan = 0;              ///< the key scan that saw most of it
};

/// What has changed in a map since the earlier visits.
struct MapChanges {
    Visits visits;
    /// Number of scans that have scans of the other visit nearby; 0: the two visits do not overlap.
    std::size_t compared = 0;
    std::vector<ChangedThing> things;  ///< largest first
};

/// Returns what appeared and disappeared between the visits of @p scans (visitsOf()). A point of one visit is
/// a change if scans of the other visit looked through it. It is no change if most scans of its own visit
/// looked through it as well: then something passed by. Scans vote on points (after Pomerleau et al. 2014).
/// Where the other visit did not look, there is no change. Cancelled: the result is empty.
[[nodiscard]] MapChanges changesOf(std::span<const ReportScan> scans, const ChangeSettings& settings = {},
                                   const Progress& progress = {});

}  // namespace leitstand
