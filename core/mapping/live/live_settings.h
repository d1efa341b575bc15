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
    std::vector<double> near = {0.5, 0.25, 0.15, 0.07};  ///< largest pair distances, stage by stage [m] ...
    std::vector<double> tight = {0.25, 0.15, 0.07};  ///< ... where these do not fit: much of the scan is new
    std::vector<double> wide = {1.5, 0.5, 0.25, 0.15,
                                0.07};  ///< ... and where odometry is missing or guessed
    double judgedWithin = 0.15;         ///< IcpSettings::judgedWithin [m]
    int maxIterations = 60;             ///< per scan, over all stages
    double levelShare = 0.1;  ///< removed share of the disagreement with gravity in roll and pitch; 0: none
    double openBelow = 0.1;   ///< certainty of a direction below which odometry counts in it (GuessPrior)
    OdometryDrift odometry;   ///< expected error of odometry, along directions that surfaces leave open
};

/// Bounds beyond which a scan does not fit.
struct FitSettings {
    double leastOverlapUnguided = 0.6;  ///< least overlap where no odometry shows how the robot came there
    double leastOverlap = 0.4;   ///< least share of points with a partner within IcpResult::OverlapDistance
    double mostResidual = 0.08;  ///< largest root mean square distance of the pairs [m]
    double jump = 0.2;           ///< largest distance from the pose by odometry [m] ...
    double jumpOfWay = 0.25;     ///< ... plus so much per distance [m / m]
    double spunOverlap = 0.8;    ///< least overlap to believe a step shorter than odometry's: wheels spun ...
    double spunAside = 0.1;      ///< ... if it leads no farther aside than this [m] ...
    double spunAsideOfWay = 0.1;      ///< ... plus this share of odometry's step [m / m]
    double turn = degrees(6);         ///< largest turn from the pose by odometry [rad] ...
    double turnOfTurn = 0.15;         ///< ... plus so much per turn [rad / rad] ...
    double turnOfWay = degrees(5);    ///< ... and per distance [rad / m]
    double leastCertainty = 0.02;     ///< least IcpResult::certainty, where odometry cannot replace it
    double mostDeviation = 0.3;       ///< largest expected error of odometry along open directions [m] ...
    double openWay = 5.0;             ///< ... over the last metres, at most so many [m]
    double leastNew = 0.6;            ///< least share of new ground in a scan whose pose is by odometry alone
    int leastPoints = 200;            ///< least number of points after reduction
    double leastSeen = degrees(270);  ///< least angle that a cut-off turn has seen, to begin a map [rad]
};

/// When a scan enters the map (docs/design.md, "Conventions").
struct KeyScanRule {
    double distance = 0.3;       ///< least distance from the robot's last key scan [m] ...
    double angle = degrees(10);  ///< ... or least turn [rad] ...
    double newGround = 0.15;     ///< ... or least share of its points ...
    double newGroundFrom = 0.5;  ///< ... that are farther than this from all known points [m]
    /// Something pushed or held the robot if a scan is farther from its pose by odometry than `pushed` [m]
    /// plus `pushedOfWay` times the way. Such a scan is left out for the next one if the map can do without
    /// it.
    double pushed = 0.05, pushedOfWay = 0.05;
    double waitsWithin = degrees(60);  ///< it is needed if the robot turned farther since the last one [rad]
};

/// Settings for closing loops.
struct LoopSettings {
    bool on = true;
    double sameAge = 20.0;  ///< largest distance over the graph with nearly certain relative poses [m]
    double reach = 3.0;     ///< scans this near each other may see the same [m]
    double about = 6.0;     ///< radius, over the graph, of the surroundings that a scan is matched with [m]
    double leastOverlap = 0.5;   ///< least IcpResult::overlap of a loop
    double mostResidual = 0.06;  ///< largest IcpResult::rms of a loop [m]
    double mostFilled = 0.06;    ///< largest share of points where the other scan looked through (FreeSpace)
    /// A place is uncertain if another one, as far off as the map may err, has this share of its
    /// MatchedPlace::fit ...
    double alike = 0.85;
    double alikeFromAbove = 0.9;  ///< ... and this share of the score of its walls, seen from above
    double apart = 0.8;           ///< least distance between two places that agree [m] ...
    double pendingWithin = 6.0;   ///< ... and largest distance [m]
    double agreeWithin = 0.08;    ///< ... and largest difference of their corrections [m] ...
    double agreeWithinAngle = degrees(1.0);  ///< ... [rad]
    /// Largest turn of the map by a loop near the scan's pose in the map [rad]: rooms look alike from another
    /// side. If the map may err by more, the scan is looked for in the whole map.
    double nearTurn = degrees(15);
    double seekEvery = 2.0;  ///< distance after which a scan is looked for in the whole map [m]; 0: never
    double seekPartsEvery = 1.0;  ///< the same while there are parts that have not met [m]
    double farBeyond = 8.0;  ///< no loop moves a scan by more than this multiple of the expected error ...
    double farTurn = degrees(60);  ///< ... or turns it by more than this [rad]
    std::size_t farAgree = 3;  ///< least number of places that agree on a loop far from the expected pose ...
    std::size_t partsAgree = 3;   ///< ... and on the relative pose of two parts, unknown so far
    std::size_t mostByHand = 12;  ///< largest number of links of what the operator moves
    /// Expected error of a map per distance over the graph between two places [m / m] ...
    double drift = 0.005;
    double openDrift = 0.03;       ///< ... where odometry alone holds a scan ...
    double driftAtLeast = 0.02;    ///< ... and always this much more [m]
    double askBeyond = 3.0;        ///< beyond this multiple of the expected error, the operator is asked
    double matchDeviation = 0.01;  ///< standard deviation of a match along held directions [m] ...
    double arm = 3.0;              ///< ... and of its turns, as the shift of a point so far away [m]
    int linksAScan = 4;            ///< largest number of links of a scan to those that it was matched with
    double partsApart = 50.0;  ///< how far aside a part begins that has not met the map's first one yet [m]
    double noticed = 0.005;    ///< smaller moves of scans are not reported [m] ...
    double noticedAngle = degrees(0.05);  ///< ... or turns [rad]
    double previewed = 0.05;              ///< smaller moves are not shown to an operator who is asked [m] ...
    double previewedAngle = degrees(0.5);  ///< ... [rad]
};

/// All settings by which scans become a map while robots drive.
struct LiveSettings {
    MatchSettings match;
    FitSettings fit;
    KeyScanRule keyScans;
    LoopSettings loops;
    LocalMapSettings local;
    MapCrop crop;
    double kept = 0.02;                 ///< edge of the grid to which key scans are thinned for the map [m]
    TurnRefinementSettings refinement;  ///< of turns that fit, before they enter the map
    std::shared_ptr<PageStore> pages;   ///< store for clouds far from robots; null: all stay in memory
    std::size_t inMemory = MatchedClouds::Usual;  ///< number of clouds in memory if there is a store
    std::set<std::string> refined;  ///< robots whose turns are all refined, even if `refinement` is not on
};

}  // namespace leitstand
