#pragma once

#include <memory>
#include <set>
#include <string>
#include <vector>

#include "core/base/pose.h"
#include "core/mapping/live/map/local_map.h"
#include "core/mapping/live/map/matched_clouds.h"
#include "core/mapping/live/scan_cleaning.h"
#include "core/mapping/motion/odometry_drift.h"
#include "core/mapping/motion/turn_refinement.h"

namespace leitstand {

/// Settings for matching a scan.
struct MatchSettings {
    double reduce = 0.12;                    ///< edge of the voxel grid of the cloud for matching [m]
    double minRange = 0.4, maxRange = 15.0;  ///< nearer and farther points are left out [m]
    /// Largest distance of a pair of points, stage by stage [m] ...
    std::vector<double> near = {0.5, 0.25, 0.15, 0.07};
    std::vector<double> tight = {0.25, 0.15, 0.07};  ///< ... if `near` does not fit: much of the scan is new
    std::vector<double> wide = {1.5, 0.5, 0.25, 0.15, 0.07};  ///< ... if odometry is missing or guessed
    double judgedWithin = 0.15;                               ///< IcpSettings::judgedWithin [m]
    int maxIterations = 60;  ///< largest number of iterations per scan, over all stages
    /// Share of the disagreement with gravity in roll and pitch that is removed; 0: none.
    double levelShare = 0.1;
    double openBelow = 0.1;  ///< odometry is used along directions less certain than this (GuessPrior)
    OdometryDrift odometry;  ///< expected error of odometry, used along directions that surfaces leave open
};

/// Limits beyond which a scan does not fit.
struct FitSettings {
    double leastOverlapUnguided = 0.6;  ///< least overlap if no odometry shows how the robot moved
    double leastOverlap = 0.4;   ///< least share of points with a partner within IcpResult::OverlapDistance
    double mostResidual = 0.08;  ///< largest root mean square distance of the pairs [m]
    double jump = 0.2;           ///< largest distance from the pose by odometry [m] ...
    double jumpOfWay = 0.25;     ///< ... plus this much per distance driven [m / m]
    /// Least overlap to believe that the robot moved less than odometry says, because wheels spun ...
    double spunOverlap = 0.8;
    double spunAside = 0.1;         ///< ... and the position is at most this far to the side [m] ...
    double spunAsideOfWay = 0.1;    ///< ... plus this share of odometry's step [m / m]
    double turn = degrees(6);       ///< largest turn from the pose by odometry [rad] ...
    double turnOfTurn = 0.15;       ///< ... plus this much per angle turned [rad / rad] ...
    double turnOfWay = degrees(5);  ///< ... and per distance driven [rad / m]
    double leastCertainty = 0.02;   ///< least IcpResult::certainty, if odometry cannot replace it
    double mostDeviation = 0.3;     ///< largest expected error of odometry along open directions [m] ...
    double openWay = 5.0;           ///< ... counted over at most this much of the way driven last [m]
    double leastNew = 0.6;  ///< least share of new ground in a scan whose pose comes from odometry alone
    int leastPoints = 200;  ///< least number of points after reduction
    /// Least angle seen by an incomplete turn of the scanner, to begin a map [rad].
    double leastSeen = degrees(270);
};

/// When a scan enters the map (docs/design.md, "Conventions").
struct KeyScanRule {
    double distance = 0.3;       ///< least distance from the robot's last key scan [m] ...
    double angle = degrees(10);  ///< ... or least turn [rad] ...
    double newGround = 0.15;     ///< ... or least share of points on new ground ...
    /// ... where a point is on new ground if it is farther than this from all known points [m].
    double newGroundFrom = 0.5;
    /// Something pushed or held the robot if a scan is farther from its pose by odometry than `pushed` [m]
    /// plus `pushedOfWay` times the distance driven. If the map does not need such a scan, it is left out and
    /// the next scan is used.
    double pushed = 0.05, pushedOfWay = 0.05;
    /// The map needs such a scan if the robot has turned more than this since the last one [rad].
    double waitsWithin = degrees(60);
};

/// Settings for closing loops.
struct LoopSettings {
    bool on = true;
    /// Largest distance over the graph at which relative poses are nearly certain [m].
    double sameAge = 20.0;
    double reach = 3.0;  ///< scans this near each other may see the same place [m]
    double about = 6.0;  ///< a scan is matched with its surroundings up to this distance over the graph [m]
    double leastOverlap = 0.5;   ///< least IcpResult::overlap of a loop
    double mostResidual = 0.06;  ///< largest IcpResult::rms of a loop [m]
    /// Largest share of points that lie where the other scan saw free space (FreeSpace).
    double mostFilled = 0.06;
    /// A place is uncertain if there is another one within the expected error of the map that is nearly as
    /// good: it has at least this share of the MatchedPlace::fit ...
    double alike = 0.85;
    double alikeFromAbove = 0.9;  ///< ... and at least this share of the score of the walls, seen from above
    double apart = 0.8;           ///< two places that confirm each other are at least this far apart [m] ...
    double pendingWithin = 6.0;   ///< ... and at most this far [m]
    double agreeWithin = 0.08;    ///< ... and their corrections differ at most by this [m] ...
    double agreeWithinAngle = degrees(1.0);  ///< ... and this [rad]
    /// Largest turn of the map by a loop near the scan's pose in the map [rad], since rooms look alike from
    /// different sides. If the map may err by more, the scan is looked for in the whole map.
    double nearTurn = degrees(15);
    /// Each time a robot has driven this far, a scan is looked for in the whole map [m]; 0: never.
    double seekEvery = 2.0;
    double seekPartsEvery = 1.0;  ///< the same, while some parts of the map are not joined [m]
    double farBeyond = 8.0;  ///< a loop may move a scan by at most this multiple of its expected error ...
    double farTurn = degrees(60);  ///< ... and turn it at most by this [rad]
    std::size_t farAgree = 3;      ///< this many places must agree on a loop far from the expected pose ...
    std::size_t partsAgree = 3;    ///< ... and this many on the unknown relative pose of two parts
    std::size_t mostByHand = 12;   ///< largest number of links for scans that the operator moves
    /// Expected error of the relative pose of two places, per distance over the graph [m / m] ...
    double drift = 0.005;
    double openDrift = 0.03;     ///< ... where only odometry holds a scan ...
    double driftAtLeast = 0.02;  ///< ... and this much more in any case [m]
    /// The operator is asked when a loop moves the map by more than this multiple of the expected error.
    double askBeyond = 3.0;
    /// Standard deviation of a match along directions that surfaces hold [m] ...
    double matchDeviation = 0.01;
    /// ... its turns have the same deviation, as the shift of a point at this distance [m].
    double arm = 3.0;
    int linksAScan = 4;  ///< largest number of links from a scan to those that it was matched with
    /// How far aside a new part begins while it is not joined with the map's first part [m].
    double partsApart = 50.0;
    double noticed = 0.005;  ///< moves of scans are reported if they are larger than this [m] ...
    double noticedAngle = degrees(0.05);  ///< ... or turn more than this [rad]
    /// Moves are shown to the operator who is asked if they are larger than this [m] ...
    double previewed = 0.05;
    double previewedAngle = degrees(0.5);  ///< ... or turn more than this [rad]
};

/// All settings for making a map of scans while robots drive.
struct LiveSettings {
    MatchSettings match;
    FitSettings fit;
    KeyScanRule keyScans;
    LoopSettings loops;
    LocalMapSettings local;
    MapCrop crop;
    double kept = 0.02;  ///< grid to which key scans are thinned for the map: edge of a cell [m]
    /// How the turns of fitting scans are refined before they enter the map.
    TurnRefinementSettings refinement;
    /// Store for clouds that are far from all robots; null: all stay in memory.
    std::shared_ptr<PageStore> pages;
    std::size_t inMemory = MatchedClouds::Usual;  ///< number of clouds kept in memory if there is a store
    std::set<std::string> refined;  ///< robots whose turns are always refined, even if `refinement` is off
};

}  // namespace leitstand
