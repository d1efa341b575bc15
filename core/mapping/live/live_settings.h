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

/// How a scan is matched.
struct MatchSettings {
    double reduce = 0.12;                                ///< edge of the voxel grid of what is matched [m]
    double minRange = 0.4, maxRange = 15.0;              ///< nearer and farther points are left out [m]
    std::vector<double> near = {0.5, 0.25, 0.15, 0.07};  ///< schedule of pair distances, with odometry [m]
    std::vector<double> tight = {0.25, 0.15, 0.07};  ///< ... where that does not fit: much of the scan is new
    std::vector<double> wide = {1.5, 0.5, 0.25, 0.15,
                                0.07};  ///< ... and where odometry is missing or guessed
    double judgedWithin = 0.15;         ///< IcpSettings::judgedWithin [m]
    int maxIterations = 60;             ///< a scan, over all stages
    double levelShare = 0.1;  ///< of what gravity says against the match, in roll and pitch; 0: none
    double openBelow = 0.1;   ///< certainty of a direction below which odometry has a say in it (GuessPrior)
    OdometryDrift odometry;   ///< for what surfaces leave open
};

/// When a scan does not fit.
struct FitSettings {
    double leastOverlapUnguided = 0.6;  ///< where no odometry tells how the robot came there
    double leastOverlap = 0.4;          ///< of its points, with a partner within IcpResult::OverlapDistance
    double mostResidual = 0.08;         ///< root mean square of the pairs [m]
    double jump = 0.2;                  ///< against the odometry's step [m] ...
    double jumpOfWay = 0.25;            ///< ... and so much of the way [m / m]
    double spunOverlap = 0.8;       ///< from there on a step is believed that is shorter than odometry's ...
    double spunAside = 0.1;         ///< ... and leads no farther aside [m] ...
    double spunAsideOfWay = 0.1;    ///< ... than so, and so much of it [m / m]
    double turn = degrees(6);       ///< a jump likewise [rad] ...
    double turnOfTurn = 0.15;       ///< ... [rad / rad] ...
    double turnOfWay = degrees(5);  ///< ... [rad / m]
    double leastCertainty = 0.02;   ///< IcpResult::certainty, where no odometry can do instead
    double mostDeviation = 0.3;     ///< expected along open directions, of the last metres of way [m]
    double openWay = 5.0;           ///< so much of it [m]
    double leastNew = 0.6;          ///< of what a scan sees that odometry alone holds
    int leastPoints = 200;          ///< after reduction
    double leastSeen = degrees(270);  ///< of directions, by a cut-off turn that a map begins with [rad]
};

/// When a scan enters the map (design, section 3).
struct KeyScanRule {
    double distance = 0.3;       ///< moved since the last one [m] ...
    double angle = degrees(10);  ///< ... or turned [rad] ...
    double newGround = 0.15;     ///< ... or this share of its points is ...
    double newGroundFrom = 0.5;  ///< ... farther than this from all that is known [m]
    /// One that came to lie so far from where odometry says [m], and so much of the way, was taken while
    /// something pushed or held the robot: where the map can do without it, it is left out for the next.
    double pushed = 0.05, pushedOfWay = 0.05;
    double waitsWithin = degrees(60);  ///< it cannot where the robot turned farther since the last one [rad]
};

/// When the map meets itself.
struct LoopSettings {
    bool on = true;
    double sameAge = 20.0;       ///< over so much way scans are nearly certain to each other [m]
    double reach = 3.0;          ///< scans this near each other may see the same [m]
    double about = 6.0;          ///< of the way about the other scan, which is matched against [m]
    double leastOverlap = 0.5;   ///< IcpResult::overlap of a loop
    double mostResidual = 0.06;  ///< IcpResult::rms [m]
    double mostFilled = 0.06;    ///< share of points that lie where the other scan looked through (FreeSpace)
    /// Another place about as far off as the map may err is as likely where the scan fits so many times as
    /// well (MatchedPlace::fit) ...
    double alike = 0.85;
    double alikeFromAbove = 0.9;  ///< ... and its walls, seen from above, so many times as well
    double apart = 0.8;           ///< two places that are to agree lie so far from each other [m] ...
    double pendingWithin = 6.0;   ///< ... and no farther [m]
    double agreeWithin = 0.08;    ///< ... and say the same [m] ...
    double agreeWithinAngle = degrees(1.0);  ///< ... [rad]
    /// A loop of places that lie near each other turns the map by no more: rooms look alike from another
    /// side. Where it may err so much, the place is looked for in the whole map [rad].
    double nearTurn = degrees(15);
    double seekEvery = 2.0;       ///< a scan is looked for in the whole map after so much way [m]; 0: none is
    double seekPartsEvery = 1.0;  ///< likewise, while there are parts that have not met [m]
    double farBeyond = 8.0;       ///< no loop moves a scan by more than so many times the expected error ...
    double farTurn = degrees(60);  ///< ... or turns it by more [rad]
    std::size_t farAgree = 3;      ///< so many places are to agree there ...
    std::size_t partsAgree = 3;    ///< ... and where two parts met of which nobody knew how they lie
    std::size_t mostByHand = 12;   ///< links of what the operator moves, at most
    double drift =
        0.005;  ///< of a map, by what lies on the way between two places, as a share of it [m / m] ...
    double openDrift = 0.03;       ///< ... where odometry alone holds a scan ...
    double driftAtLeast = 0.02;    ///< ... whatever the way [m]
    double askBeyond = 3.0;        ///< so many times that, the operator is asked
    double matchDeviation = 0.01;  ///< of a match, along directions that surfaces hold [m] ...
    double arm = 3.0;              ///< ... and turns by as much as moves a point so far away likewise [m]
    int linksAScan = 4;            ///< with what it was matched against
    double partsApart = 50.0;  ///< a part that has not met the map's first one yet begins so far aside [m]
    double noticed = 0.005;    ///< scans that move less are not told [m] ...
    double noticedAngle = degrees(0.05);   ///< ... or turn less [rad]
    double previewed = 0.05;               ///< nor shown to an operator who is asked [m] ...
    double previewedAngle = degrees(0.5);  ///< ... [rad]
};

/// All that decides how scans become a map while robots drive.
struct LiveSettings {
    MatchSettings match;
    FitSettings fit;
    KeyScanRule keyScans;
    LoopSettings loops;
    LocalMapSettings local;
    MapCrop crop;
    double kept = 0.02;                 ///< key scans are thinned to this for the map [m]
    TurnRefinementSettings refinement;  ///< of turns that fit, before they enter the map
    std::shared_ptr<PageStore> pages;   ///< for what is matched of scans far from robots; null: in memory
    std::size_t inMemory = MatchedClouds::Usual;  ///< of how many scans that is in memory then
    std::set<std::string> refined;  ///< robots whose turns are refined also where refinement is not on
};

}  // namespace leitstand
