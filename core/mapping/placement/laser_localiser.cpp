#include "core/mapping/placement/laser_localiser.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include <fmt/format.h>

#include "core/mapping/placement/placement_says.h"
#include "core/mapping/placement/wall_fit.h"
#include "core/mapping/placement/wall_map.h"

namespace leitstand {
namespace {

const std::vector<double> Near = {0.2, 0.1};
const std::vector<double> Far = {0.3, 0.15, 0.1};
constexpr double Moved = 0.02, Turned = degrees(2);  ///< less is at rest [m], [rad]
constexpr double WidestSearch = 1.2, WidestTurn = degrees(40);

}  // namespace

void LaserLocaliser::begin(const MapFix& fix) {
    m_last = fix;
    m_way = m_turn = 0.0;
    m_certainty = fix.certainty;
    m_doubted = fix.certain ? 0 : m_settings.searchAfter;
    m_foundAgain = false;
}

bool LaserLocaliser::due(Time stamp, const MotionBuffer& motion) const {
    if (stamp <= m_last.stamp) return stamp < m_last.stamp - std::chrono::seconds(5);  // the robot began anew
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
    m_foundAgain = false;
    const WallMap map = wallMap(local, predicted, view.low, view.high);
    const FlatPose guess = FlatPose::of(predicted);
    WallFit fit = fitToWalls(view, map, guess, Near);
    if (fit.overlap < how.sureOverlap && m_turn > how.turn) {
        // Tracks that slip turn the robot farther than pairs find each other.
        const Correlation about = correlate(view, map, guess, {0.15, degrees(12)});
        const WallFit other = fitToWalls(view, map, about.pose, Far);
        if (other.overlap > fit.overlap + 0.05) fit = other;
    }
    m_overlap = fit.overlap;
    const double jump = (fit.pose.place - guess.place).norm();
    const double swing = std::abs(std::remainder(fit.pose.heading - guess.heading, 2.0 * M_PI));
    const bool sure =
        fit.overlap >= how.placement.plentyOverlap && fit.direction >= 0.5 * how.placement.plentyDirection;
    std::string doubt;
    if (static_cast<int>(view.points.size()) < how.placement.leastPoints) {
        doubt = placement_says::TooLittle;
    } else if (fit.overlap < how.leastOverlap) {
        doubt = fmt::format(placement_says::OnlyInMap, std::lround(100.0 * fit.overlap));
    } else if (jump > (sure ? how.sureJump + how.sureJumpOfWay * m_way : how.jump + how.jumpOfWay * m_way) ||
               swing > how.swing + how.swingOfTurn * m_turn + how.swingOfWay * m_way) {
        doubt = fmt::format(placement_says::FarFromTracks, std::lround(100.0 * jump));
    }
    MapFix fix{view.stamp, predicted, 0.0, false, doubt};
    if (doubt.empty()) {
        const bool open = fit.direction < WallFit::OpenBelow;
        fix.baseInMap = fit.pose.standing(map.ground) * view.tilt;
        const double meets = std::clamp(fit.overlap / how.placement.plentyOverlap, 0.0, 1.0);
        if (open) {
            fix.how = placement_says::DirectionOpen;
            fix.certainty = std::min(meets, m_certainty * std::exp(-m_way / how.fades));
        } else {
            fix.how = fmt::format(placement_says::LaserInMap, std::lround(100.0 * fit.overlap));
            fix.certainty = meets * std::clamp(fit.direction / how.placement.plentyDirection, 0.0, 1.0);
            fix.certain = true;
            m_way = m_turn = 0.0;
            m_certainty = fix.certainty;
        }
        m_doubted = 0;
    } else {
        fix.certainty = m_certainty * std::exp(-(m_way + 0.1 * ++m_doubted) / how.fades);
        if (m_doubted >= how.searchAfter && m_doubted % how.searchAfter == 0) fix = sought(view, local, fix);
    }
    m_last = fix;
    return fix;
}

MapFix LaserLocaliser::sought(const LaserView& view, const LocalMap& local, MapFix doubted) {
    const SearchWindow window{std::min(WidestSearch, 0.3 + 0.3 * m_way),
                              std::min(WidestTurn, degrees(12) + 0.2 * m_turn)};
    const Placement found = placeRobot(view, local, doubted.baseInMap, window, m_settings.placement);
    if (!found.certain || found.overlap < m_settings.sureOverlap) return doubted;
    m_foundAgain = true;
    m_doubted = 0;
    m_way = m_turn = 0.0;
    m_certainty = found.certainty;
    return {view.stamp, found.baseInMap, found.certainty, true,
            fmt::format(placement_says::FoundAgain, found.how)};
}

}  // namespace leitstand
