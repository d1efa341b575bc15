#include "core/mapping/placement/laser_robot.h"

#include <chrono>
#include <cmath>
#include <utility>

#include <fmt/format.h>

#include "core/mapping/placement/placement_format.h"
#include "core/mapping/sighting/contradiction.h"

namespace leitstand {
namespace {

constexpr double SameLocal = 0.5;  ///< the local map is kept while the place is so near [m]
constexpr std::chrono::seconds TryAgain(2);
constexpr std::chrono::seconds SeenWithin(3);  ///< duration of a scan and of its registration
constexpr double MostMoved = 0.05;             ///< meanwhile; a robot that drives is seen smeared [m]
constexpr double SeenWindow = 0.35;            ///< around a body that is seen [m] ...
constexpr double MostOff = 0.13;               ///< largest distance of the robot from its middle [m]
constexpr double BodyMargin = 0.12;            ///< ... margin around the robot for the body's points [m] ...
constexpr double LeastOfBody = 0.7;            ///< ... and least share of them that lie on it
constexpr double LeastSure = 0.6;  ///< of the certainty, since it is looked for everywhere, at all headings
constexpr double AsGood = 0.7;     ///< share of the best one; it may as well be the other one
constexpr SearchWindow ResumedWindow{0.5, degrees(20)};

}  // namespace

LaserRobot::LaserRobot(RobotTracker& tracker, std::string station, const LocaliserSettings& settings)
    : m_tracker(tracker), m_station(std::move(station)), m_settings(settings), m_localiser(settings) {}

const LocalMap& LaserRobot::localAt(const LiveMapPtr& map, const Pose& place) {
    if (map != m_map || distanceBetween(place, m_localPlace) > SameLocal) {
        m_local = localMap(map->scans, place);
        m_localPlace = place;
        m_map = map;
    }
    return m_local;
}

RobotPlaceSample LaserRobot::taken(const MapFix& fix, RobotPlaceSample::Cause cause, double overlap,
                                   Time now) {
    m_tracker.correct(fix);
    m_resumed.reset();
    if (fix.certain) m_put = false;
    RobotPlaceSample sample;
    sample.stamp = now;
    sample.station = m_station;
    sample.robot = m_tracker.now().robot;
    sample.cause = cause;
    sample.measured = fix.stamp;
    sample.baseInMap = fix.baseInMap;
    sample.odomInMap = m_tracker.odomInMap().value_or(fix.baseInMap);
    sample.certainty = fix.certainty;
    sample.overlap = overlap;
    sample.certain = fix.certain;
    sample.how = fix.how;
    return sample;
}

void LaserRobot::wasAt(Time stamp) {
    const auto motion = m_tracker.motion().at(stamp);
    if (!motion) return;
    const int frame = m_tracker.motion().frameAt(stamp);
    if (m_begin && frame != m_frame) {
        m_before = m_before * (m_begin->inverse() * m_newest);
        m_begin.reset();
    }
    if (!m_begin) m_begin = motion->baseInOdom;
    m_frame = frame;
    m_newest = motion->baseInOdom;
}

std::optional<RobotPlaceSample> LaserRobot::see(LaserView view, const LiveMapPtr& map, Time now,
                                                std::span<const Disc> others) {
    const Time stamp = view.stamp;
    m_view = std::move(view);
    wasAt(stamp);
    if (!map || map->scans.empty()) return std::nullopt;
    if (m_resumed) return resumed(map, now);
    if (!m_tracker.placed() || !m_localiser.due(stamp, m_tracker.motion())) return std::nullopt;
    const auto predicted = m_tracker.baseInMap(stamp);
    if (!predicted) return std::nullopt;
    leaveOut(*m_view, *predicted, others);
    leaveOutCropped(*m_view, *predicted, m_crop);
    const MapFix fix = m_localiser.follow(*m_view, localAt(map, *predicted), *predicted, m_tracker.motion());
    const auto cause =
        m_localiser.foundAgain() ? RobotPlaceSample::Cause::FoundAgain : RobotPlaceSample::Cause::Tracked;
    return taken(fix, cause, m_localiser.overlap(), now);
}

std::optional<RobotPlaceSample> LaserRobot::placeBeside(const Pose& otherInMap, const LiveMapPtr& map,
                                                        Time now, std::span<const Disc> others) {
    if (!wantsSlot() || !m_view || !map || map->scans.empty()) return std::nullopt;
    // It was reported as not found. As the map grows, it may be found after all.
    const bool grown = map != m_tried && m_tries < MostTries;
    const auto since = m_view->stamp - m_triedAt;  // negative if its clock was set back
    if (!grown && since >= std::chrono::seconds(0) && since < TryAgain) return std::nullopt;
    m_triedAt = m_view->stamp;
    m_tried = map;
    Pose guess = otherInMap * m_settings.placement.slotInOther * m_before;
    if (m_begin) guess = guess * (m_begin->inverse() * m_newest);
    Placement found =
        placeRobot(*m_view, localAt(map, guess), guess, m_settings.placement.slot, m_settings.placement);
    if (found.certain && contradicted(found.baseInMap, others)) {
        found.certain = false;
        found.certainty = 0.0;
        found.how = logged(placement_format::AgainstMap);
    }
    ++m_tries;
    if (!found.certain && m_tries != MostTries) return std::nullopt;
    const MapFix fix{m_view->stamp, found.baseInMap, found.certainty, found.certain, found.how};
    if (found.certain) {
        m_localiser.begin(fix);
        return taken(fix, RobotPlaceSample::Cause::Slot, found.overlap, now);
    }
    // It is not there, so no pose is claimed.
    RobotPlaceSample sample = taken(fix, RobotPlaceSample::Cause::Slot, found.overlap, now);
    m_tracker.lose();
    return sample;
}

bool LaserRobot::contradicted(const Pose& baseInMap, std::span<const Disc> others) const {
    LaserView view = *m_view;
    leaveOut(view, baseInMap, others);
    leaveOutCropped(view, baseInMap, m_crop);
    const WallMap walls = wallMap(m_local, baseInMap, view.low, view.high);
    return contradiction(view, m_local, walls, FlatPose::of(baseInMap)) > m_settings.mostAgainst;
}

bool LaserRobot::wantsSeen() const {
    if (m_resumed || m_put || !m_view) return false;
    return m_tracker.placed() ? m_localiser.lost() : m_tries > 0;
}

std::optional<RobotPlaceSample> LaserRobot::placeSeen(std::span<const SeenBody> seen, const RobotBody& body,
                                                      const std::string& by, const LiveMapPtr& map, Time now,
                                                      std::span<const Disc> others) {
    if (!wantsSeen() || !map || map->scans.empty()) return std::nullopt;
    const double moved = m_tracker.motion().travelled(m_view->stamp - SeenWithin, m_view->stamp).way;
    if (moved > MostMoved) return std::nullopt;
    Placement best, second;
    for (const SeenBody& one : seen) {
        const Pose guess = poseFrom({one.middle.x(), one.middle.y(), one.ground}, 0, 0, 0);
        const Placement found =
            placeRobot(*m_view, localAt(map, guess), guess, {SeenWindow, degrees(180)}, m_settings.placement);
        if (found.certainty < LeastSure || found.overlap < m_settings.sureOverlap) continue;
        // The body must be the robot that would stand there.
        if ((one.middle - found.baseInMap.translation().head<2>()).norm() > MostOff) continue;
        if (shareWithin(one, body, found.baseInMap, BodyMargin) < LeastOfBody) continue;
        if (contradicted(found.baseInMap, others)) continue;
        const bool same =
            best.certain && distanceBetween(found.baseInMap, best.baseInMap) < Correlation::Apart;
        if (found.certainty > best.certainty) {
            if (!same) second = best;
            best = found;
        } else if (!same && found.certainty > second.certainty) {
            second = found;
        }
    }
    if (!best.certain || second.certainty > AsGood * best.certainty) return std::nullopt;
    const MapFix fix{m_view->stamp, best.baseInMap, best.certainty, true,
                     logged(placement_format::SeenBy, by, std::lround(100.0 * best.overlap))};
    m_localiser.begin(fix);
    return taken(fix, RobotPlaceSample::Cause::Seen, best.overlap, now);
}

RobotPlaceSample LaserRobot::place(const Pose& baseInMap, const LiveMapPtr& map, Time now) {
    MapFix fix{m_tracker.now().stamp, baseInMap, 0.0, false, logged(placement_format::PutBlindly)};
    double overlap = 0.0;
    if (m_view && map && !map->scans.empty()) {
        const Placement found = placeRobot(*m_view, localAt(map, baseInMap), baseInMap,
                                           m_settings.placement.dragged, m_settings.placement);
        overlap = found.overlap;
        fix = {m_view->stamp, found.baseInMap, found.certainty, found.certain,
               found.certain ? found.how : logged(placement_format::PutBut, found.how)};
    }
    m_put = true;  // the operator knows better
    m_localiser.begin(fix);
    return taken(fix, RobotPlaceSample::Cause::Operator, overlap, now);
}

RobotPlaceSample LaserRobot::putUntilScan(const Pose& baseInMap, Time measured, Time now) const {
    RobotPlaceSample sample;
    sample.stamp = now;
    sample.station = m_station;
    sample.robot = m_tracker.now().robot;
    sample.cause = RobotPlaceSample::Cause::Operator;
    sample.measured = measured;
    sample.baseInMap = sample.odomInMap = baseInMap;
    if (const auto motion = m_tracker.motion().at(measured))
        sample.odomInMap = baseInMap * motion->baseInOdom.inverse();
    sample.how = logged(placement_format::PutUntilScan);
    return sample;
}

RobotPlaceSample LaserRobot::foundByScan(const Pose& baseInMap, Time measured, double overlap,
                                         Time now) const {
    RobotPlaceSample sample = putUntilScan(baseInMap, measured, now);
    sample.cause = RobotPlaceSample::Cause::FoundAgain;
    sample.overlap = overlap;  // certain once its next scan fits there
    sample.how = logged(placement_format::FoundByScan, std::lround(100.0 * overlap));
    return sample;
}

void LaserRobot::restore(const RobotPlaceSample& place) {
    m_resumed = place;
    m_tracker.correct({place.measured, place.baseInMap, 0.0, false, logged(placement_format::WhereLeft)});
}

void LaserRobot::follow(const RobotPlaceSample& place) {
    if (place.cause == RobotPlaceSample::Cause::Slot && !place.certain) return;  // looked for in vain
    m_resumed = place;  // it is looked for from there, once this station makes the map
    m_tracker.correct({place.measured, place.baseInMap, place.certainty, place.certain, place.how});
}

std::optional<RobotPlaceSample> LaserRobot::resumed(const LiveMapPtr& map, Time now) {
    const auto motion = m_tracker.motion().at(m_view->stamp);
    if (!motion) return std::nullopt;
    // The odometry may have continued, or restarted while the robot stood.
    Placement best;
    for (const Pose& guess : {Pose(m_resumed->odomInMap * motion->baseInOdom), m_resumed->baseInMap}) {
        const Placement one =
            placeRobot(*m_view, localAt(map, guess), guess, ResumedWindow, m_settings.placement);
        if (best.how.empty() || one.certainty > best.certainty) best = one;
    }
    const MapFix fix{m_view->stamp, best.baseInMap, best.certainty, best.certain,
                     best.certain ? best.how : logged(placement_format::WhereLeftBut, best.how)};
    m_localiser.begin(fix);
    return taken(fix, RobotPlaceSample::Cause::FoundAgain, best.overlap, now);
}

}  // namespace leitstand
