#include "core/mapping/placement/laser_robot.h"

#include <chrono>
#include <utility>

namespace leitstand {
namespace {

constexpr double SameLocal = 0.5;  ///< so near the local map is the same [m]
constexpr std::chrono::seconds TryAgain(2);
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

std::optional<RobotPlaceSample> LaserRobot::see(LaserView view, const LiveMapPtr& map, Time now,
                                                std::span<const Disc> others) {
    const Time stamp = view.stamp;
    m_view = std::move(view);
    if (!m_begin) {
        if (const auto motion = m_tracker.motion().at(stamp)) m_begin = motion->baseInOdom;
    }
    if (!map || map->scans.empty()) return std::nullopt;
    if (m_resumed) return resumed(map, now);
    if (!m_tracker.placed() || !m_localiser.due(stamp, m_tracker.motion())) return std::nullopt;
    const auto predicted = m_tracker.baseInMap(stamp);
    if (!predicted) return std::nullopt;
    leaveOut(*m_view, *predicted, others);
    const MapFix fix = m_localiser.follow(*m_view, localAt(map, *predicted), *predicted, m_tracker.motion());
    const auto cause =
        m_localiser.foundAgain() ? RobotPlaceSample::Cause::FoundAgain : RobotPlaceSample::Cause::Tracked;
    return taken(fix, cause, m_localiser.overlap(), now);
}

std::optional<RobotPlaceSample> LaserRobot::placeBeside(const Pose& otherInMap, const LiveMapPtr& map,
                                                        Time now) {
    if (!wantsSlot() || !m_view || !map || map->scans.empty()) return std::nullopt;
    // It was told that it is not there; as the map grows, it may be found after all.
    if (m_tries >= MostTries && m_view->stamp - m_triedAt < TryAgain) return std::nullopt;
    m_triedAt = m_view->stamp;
    const auto here = m_tracker.motion().at(m_view->stamp);
    Pose guess = otherInMap * m_settings.placement.slotInOther;
    if (here && m_begin) guess = guess * (m_begin->inverse() * here->baseInOdom);
    const Placement found =
        placeRobot(*m_view, localAt(map, guess), guess, m_settings.placement.slot, m_settings.placement);
    ++m_tries;
    if (!found.certain && m_tries != MostTries) return std::nullopt;
    const MapFix fix{m_view->stamp, found.baseInMap, found.certainty, found.certain, found.how};
    if (found.certain) {
        m_localiser.begin(fix);
        return taken(fix, RobotPlaceSample::Cause::Slot, found.overlap, now);
    }
    // It is not there: nothing is claimed.
    RobotPlaceSample sample = taken(fix, RobotPlaceSample::Cause::Slot, found.overlap, now);
    m_tracker.lose();
    return sample;
}

RobotPlaceSample LaserRobot::place(const Pose& baseInMap, const LiveMapPtr& map, Time now) {
    MapFix fix{m_tracker.now().stamp, baseInMap, 0.0, false,
               "put there by the operator; its laser says nothing"};
    double overlap = 0.0;
    if (m_view && map && !map->scans.empty()) {
        const Placement found = placeRobot(*m_view, localAt(map, baseInMap), baseInMap,
                                           m_settings.placement.dragged, m_settings.placement);
        overlap = found.overlap;
        fix = {m_view->stamp, found.baseInMap, found.certainty, found.certain,
               found.certain ? found.how : "put there by the operator, but " + found.how};
    }
    m_put = true;  // the operator knows better
    m_localiser.begin(fix);
    return taken(fix, RobotPlaceSample::Cause::Operator, overlap, now);
}

void LaserRobot::restore(const RobotPlaceSample& place) {
    m_resumed = place;
    m_tracker.correct(
        {place.measured, place.baseInMap, 0.0, false, "where it was when the station was left"});
}

std::optional<RobotPlaceSample> LaserRobot::resumed(const LiveMapPtr& map, Time now) {
    const auto motion = m_tracker.motion().at(m_view->stamp);
    if (!motion) return std::nullopt;
    // The odometry may have gone on, or begun anew while the robot stood.
    Placement best;
    for (const Pose& guess : {Pose(m_resumed->odomInMap * motion->baseInOdom), m_resumed->baseInMap}) {
        const Placement one =
            placeRobot(*m_view, localAt(map, guess), guess, ResumedWindow, m_settings.placement);
        if (best.how.empty() || one.certainty > best.certainty) best = one;
    }
    const MapFix fix{m_view->stamp, best.baseInMap, best.certainty, best.certain,
                     best.certain ? best.how : "where it was when the station was left: " + best.how};
    m_localiser.begin(fix);
    return taken(fix, RobotPlaceSample::Cause::FoundAgain, best.overlap, now);
}

}  // namespace leitstand
