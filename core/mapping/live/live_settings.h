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
    std::vector<double> near = {0.5, 0.25, 0.15, 0.07};  ///< schedule of pair distances, with odometry [m]
    std::vector<double> tight = {0.25, 0.15, 0.07};  ///< ... where that does not fit: much of the scan is new
    std::vector<double> wide = {1.5, 0.5, 0.25, 0.15,
                                0.07};  ///< ... and where odometry is missing or guessed
    double judgedWithin = 0.15;         ///< IcpSettings::judgedWithin [m]
    int maxIterations = 60;             ///< a scan, over all stages
    double levelShare = 0.1;  ///< of gravity's disagreement in roll and pitch that is removed; 0: none
    double openBelow = 0.1;   ///< certainty of a direction below which odometry counts in it (GuessPrior)
    OdometryDrift odometry;   ///< for what surfaces leave open
};

/// Bounds beyond which a scan does not fit.
struct FitSettings {
    double leastOverlapUnguided = 0.6;  ///< where no odometry shows how the robot came there
    double leastOverlap = 0.4;          ///< of its points, with a partner within IcpResult::OverlapDistance
    double mostResidual = 0.08;         ///< root mean square of the pairs [m]
    double jump = 0.2;                  ///< against the odometry's step [m] ...
    double jumpOfWay = 0.25;            ///< ... and per distance [m / m]
    double spunOverlap = 0.8;         ///< from here on a step is believed that is shorter than odometry's ...
    double spunAside = 0.1;           ///< ... and leads no farther aside [m] ...
    double spunAsideOfWay = 0.1;      ///< ... than this, and this share of it [m / m]
    double turn = degrees(6);         ///< against the odometry's step [rad] ...
    double turnOfTurn = 0.15;         ///< ... [rad / rad] ...
    double turnOfWay = degrees(5);    ///< ... [rad / m]
    double leastCertainty = 0.02;     ///< IcpResult::certainty, where odometry cannot replace it
    double mostDeviation = 0.3;       ///< expected along open directions, over the last metres [m]
    double openWay = 5.0;             ///< length of these last metres [m]
    double leastNew = 0.6;            ///< share of new ground in a scan that odometry alone holds
    int leastPoints = 200;            ///< after reduction
    double leastSeen = degrees(270);  ///< of directions, by a cut-off turn that begins a map [rad]
};

/// When a scan enters the map (docs/design.md, "Conventions").
struct KeyScanRule {
    double distance = 0.3;       ///< moved since the last one [m] ...
    double angle = degrees(10);  ///< ... or turned [rad] ...
    double newGround = 0.15;     ///< ... or this share of its points is ...
    double newGroundFrom = 0.5;  ///< ... farther than this from everything known [m]
    /// Least distance [m], and share of the way, between a scan and its pose by odometry. Such a scan was
    /// taken while something pushed or held the robot. If the map can do without it, it is left out for the
    /// next one.
    double pushed = 0.05, pushedOfWay = 0.05;
    double waitsWithin = degrees(60);  ///< it cannot if the robot turned farther since the last one [rad]
};

/// Settings for closing loops.
struct LoopSettings {
    bool on = true;
    double sameAge = 20.0;       ///< over such a distance relative poses are nearly certain [m]
    double reach = 3.0;          ///< scans this near each other may see the same [m]
    double about = 6.0;          ///< distance around the other scan that is matched against [m]
    double leastOverlap = 0.5;   ///< IcpResult::overlap of a loop
    double mostResidual = 0.06;  ///< IcpResult::rms [m]
    double mostFilled = 0.06;    ///< share of points that lie where the other scan looked through (FreeSpace)
    /// Share of MatchedPlace::fit with which another place as far off as the map may err is as likely ...
    double alike = 0.85;
    double alikeFromAbove = 0.9;             ///< ... and share of the score of its walls, seen from above
    double apart = 0.8;                      ///< least distance between two places that agree [m] ...
    double pendingWithin = 6.0;              ///< ... and largest distance [m]
    double agreeWithin = 0.08;               ///< ... and largest difference of their corrections [m] ...
    double agreeWithinAngle = degrees(1.0);  ///< ... [rad]
    /// Largest turn of the map by a loop of places near each other [rad]: rooms look alike from another side.
    /// If the map may err so much, the place is looked for in the whole map.
    double nearTurn = degrees(15);
    double seekEvery = 2.0;  ///< distance after which a scan is looked for in the whole map [m]; 0: never
    double seekPartsEvery = 1.0;  ///< the same while there are parts that have not met [m]
    double farBeyond = 8.0;  ///< no loop moves a scan by more than this multiple of the expected error ...
    double farTurn = degrees(60);  ///< ... or turns it by more [rad]
    std::size_t farAgree = 3;      ///< least number of places that agree there ...
    std::size_t partsAgree = 3;    ///< ... and where two parts met whose relative pose was unknown
    std::size_t mostByHand = 12;   ///< largest number of links of what the operator moves
    /// Expected error of a map per distance over the graph between two places [m / m] ...
    double drift = 0.005;
    double openDrift = 0.03;       ///< ... where odometry alone holds a scan ...
    double driftAtLeast = 0.02;    ///< ... and at least [m]
    double askBeyond = 3.0;        ///< beyond this multiple the operator is asked
    double matchDeviation = 0.01;  ///< of a match, along directions that surfaces hold [m] ...
    double arm = 3.0;              ///< ... and of turns, as the shift of a point so far away [m]
    int linksAScan = 4;            ///< links to the scans that it was matched with
    double partsApart = 50.0;  ///< a part that has not met the map's first one yet begins so far aside [m]
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
    double kept = 0.02;                           ///< key scans are thinned to this for the map [m]
    TurnRefinementSettings refinement;            ///< of turns that fit, before they enter the map
    std::shared_ptr<PageStore> pages;             ///< for clouds of scans far from robots; null: in memory
    std::size_t inMemory = MatchedClouds::Usual;  ///< number of clouds in memory then
    std::set<std::string> refined;  ///< robots whose turns are refined also where refinement is not on
};

}  // namespace leitstand
