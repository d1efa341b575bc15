#include "core/mapping/placement/laser_localiser.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include <fmt/format.h>

#include "core/mapping/placement/placement_format.h"
#include "core/mapping/placement/wall_fit.h"
#include "core/mapping/placement/wall_map.h"
#include "core/mapping/sighting/contradiction.h"

namespace leitstand {
namespace {

const std::vector<double> Near = {0.2, 0.1};
const std::vector<double> Far = {0.3, 0.15, 0.1};
constexpr double Moved = 0.02, Turned = degrees(2);  ///< smaller motion is rest [m], [rad]
constexpr double WidestSearch = 1.2, WidestTurn = degrees(40);

/// Fits @p view to the walls of @p map. If less than @p enough of it meets them, it also searches around @p
/// guess.
WallFit fitAbout(const LaserView& view, const WallMap& map, const FlatPose& guess, double enough) {
    const WallFit fit = fitToWalls(view, map, guess, Near);
    if (fit.overlap >= enough) return fit;
    const Correlation about = correlate(view, map, guess, {0.15, degrees(12)});
    const WallFit other = fitToWalls(view, map, about.pose, Far);
    return other.overlap > fit.overlap + 0.05 ? other : fit;
}

}  // namespace

void LaserLocaliser::begin(const MapFix& fix) {
    m_last = fix;
    m_way = m_turn = m_drift = 0.0;
    m_certainty = fix.certainty;
    m_doubted = fix.certain ? 0 : m_settings.searchAfter;
    m_foundAgain = false;
    m_own.forget();
}

bool LaserLocaliser::due(Time stamp, const MotionBuffer& motion) const {
    if (stamp <= m_last.stamp) return stamp < m_last.stamp - std::chrono::seconds(5);  // the robot restarted
    const Travel travel = motion.travelled(m_last.stamp, stamp);
    if (travel.way >= m_settings.way || travel.turn >= m_settings.turn) return true;
    const bool rests = travel.way < Moved && travel.turn < Turned;
    return stamp - m_last.stamp >= (rests ? m_settings.atRest : m_settings.every);
}

MapFix LaserLocaliser::follow(const LaserView& view, const LocalMap& local, const Pose& predicted,
                              const MotionBuffer& motion) {
    const LocaliserSettings& how = m_settings;
    const Travel travel = motion.travelled(m_last.stamp, view.stamp);
    m_way += travel.way;
    m_turn += travel.turn;
    m_drift += travel.way;
    m_foundAgain = false;
    const WallMap map = wallMap(local, predicted, view.low, view.high);
    const FlatPose guess = FlatPose::of(predicted);
    // Tracks that slip turn the robot farther than pairs can bridge.
    const WallFit fit = fitAbout(view, map, guess, m_turn > how.turn ? how.sureOverlap : 0.0);
    m_overlap = fit.overlap;
    const double jump = (fit.pose.place - guess.place).norm();
    const double swing = std::abs(std::remainder(fit.pose.heading - guess.heading, 2.0 * M_PI));
    const bool sure =
        fit.overlap >= how.placement.plentyOverlap && fit.direction >= 0.5 * how.placement.plentyDirection;
    // A lost robot may be anywhere within reach; what it saw on the last metres decides.
    const double way = lost() ? m_way : m_drift;
    std::string doubt;
    if (static_cast<int>(view.points.size()) < how.placement.leastPoints) {
        doubt = logged(placement_format::TooLittle);
    } else if (fit.overlap < how.leastOverlap) {
        doubt = logged(placement_format::OnlyInMap, std::lround(100.0 * fit.overlap));
    } else if (jump > (sure ? how.sureJump + how.sureJumpOfWay * way : how.jump + how.jumpOfWay * way) ||
               swing > how.swing + how.swingOfTurn * m_turn + how.swingOfWay * way) {
        doubt = logged(placement_format::FarFromTracks, std::lround(100.0 * jump));
    } else if (lost() && !meetsAll(view, map, guess, fit.pose)) {
        doubt = logged(placement_format::LittleInMap);
    }
    MapFix fix{view.stamp, predicted, 0.0, false, doubt};
    if (doubt.empty()) {
        const bool open = fit.direction < how.leastDirection;
        fix.baseInMap = fit.pose.standing(map.ground) * view.tilt;
        const double meets = std::clamp(fit.overlap / how.placement.plentyOverlap, 0.0, 1.0);
        if (open) {
            fix.how = logged(placement_format::DirectionOpen);
            fix.certainty = std::min(meets, m_certainty * std::exp(-m_drift / how.fades));
        } else {
            fix.how = logged(placement_format::LaserInMap, std::lround(100.0 * fit.overlap));
            fix.certainty = meets * std::clamp(fit.direction / how.placement.plentyDirection, 0.0, 1.0);
            fix.certain = true;
            m_way = m_turn = m_drift = 0.0;
            m_certainty = fix.certainty;
            m_own.correct(guess, FlatPose::of(fix.baseInMap));
        }
        m_doubted = 0;
    } else {
        ++m_doubted;
        if (const auto carried = carriedOn(view, map, predicted, travel)) {
            fix.baseInMap = *carried;
            m_drift -= (1.0 - how.ownDrift) * travel.way;
        } else {
            m_own.breakOff();
        }
        fix.certainty = m_certainty * std::exp(-(m_drift + 0.1 * m_doubted) / how.fades);
        if (m_doubted >= how.searchAfter && m_doubted % how.searchAfter == 0) {
            const FlatPose before = FlatPose::of(fix.baseInMap);
            fix = sought(view, local, fix);
            if (m_foundAgain) m_own.correct(before, FlatPose::of(fix.baseInMap));
        }
    }
    m_own.add(view, FlatPose::of(fix.baseInMap));
    if (fix.certain) m_own.settle();
    m_last = fix;
    return fix;
}

std::optional<Pose> LaserLocaliser::carriedOn(const LaserView& view, const WallMap& map,
                                              const Pose& predicted, const Travel& travel) const {
    if (m_own.empty()) return std::nullopt;
    const FlatPose guess = FlatPose::of(predicted);
    const WallMap both = m_own.with(map);
    const WallFit fit =
        fitAbout(view, both, guess, travel.turn > m_settings.turn / 2 ? m_settings.ownOverlap : 0.0);
    const double jump = (fit.pose.place - guess.place).norm();
    const double swing = std::abs(std::remainder(fit.pose.heading - guess.heading, 2.0 * M_PI));
    if (fit.overlap < m_settings.ownOverlap ||
        jump > m_settings.sureJump + m_settings.sureJumpOfWay * travel.way ||
        swing > m_settings.swing + m_settings.swingOfTurn * travel.turn)
        return std::nullopt;
    return Pose(fit.pose.standing(0.0) * guess.standing(0.0).inverse() * predicted);
}

bool LaserLocaliser::meetsAll(const LaserView& view, const WallMap& map, const FlatPose& guess,
                              const FlatPose& found) const {
    // Unless the laser shows nothing of that any more: somebody stood in front of it.
    const bool goesOn =
        fitToWalls(view, m_own.with(WallMap()), guess, Near).overlap >= m_settings.leastOverlap;
    const LaserView all = goesOn ? m_own.seenFrom(guess, view) : view;
    return fitToWalls(all, map, found, {}).overlap >= m_settings.allOverlap;
}

MapFix LaserLocaliser::sought(const LaserView& view, const LocalMap& local, MapFix doubted) {
    const SearchWindow window{std::min(WidestSearch, 0.3 + 0.3 * m_drift),
                              std::min(WidestTurn, degrees(12) + 0.2 * m_turn)};
    const Placement found = placeRobot(view, local, doubted.baseInMap, window, m_settings.placement);
    if (!found.certain || found.overlap < m_settings.sureOverlap) return doubted;
    const WallMap map = wallMap(local, found.baseInMap, view.low, view.high);
    const FlatPose place = FlatPose::of(found.baseInMap);
    if (!meetsAll(view, map, FlatPose::of(doubted.baseInMap), place)) return doubted;
    if (contradiction(view, local, map, place) > m_settings.mostAgainst) return doubted;
    m_foundAgain = true;
    m_doubted = 0;
    m_way = m_turn = m_drift = 0.0;
    m_certainty = found.certainty;
    return {view.stamp, found.baseInMap, found.certainty, true,
            logged(placement_format::FoundAgain, found.how)};
}

}  // namespace leitstand
