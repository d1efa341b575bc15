#include "app/services/mapping/robots/lost_robots.h"

#include <algorithm>
#include <memory>
#include <utility>

#include "app/services/log/sequencer.h"
#include "app/services/mapping/robots/mapping_context.h"
#include "app/services/mapping/robots/robot_placing.h"
#include "core/mapping/live/map/moved_places.h"
#include "core/mapping/relocalisation/place_recognition.h"

namespace leitstand {
namespace {

constexpr int SoughtEvery = 3;  ///< after so many scans that do not fit it is looked for, by the newest
constexpr int InVain = 3;       ///< after so many failed searches it may map a part of its own

}  // namespace

LostRobots::LostRobots(MappingContext& context, MappedRobots& robots, RobotPlacing& placing)
    : m_context(context), m_robots(robots), m_placing(placing) {
    for (const RobotDescription& robot : robots.descriptions()) m_lost[robot.name];
}

void LostRobots::wasPut(const std::string& name) {
    ++m_lost.at(name).put;
}

void LostRobots::lookFor(const std::string& name) {
    const auto& followed = m_robots.at(name).followed;
    const std::uint64_t part = followed ? followed->part : 0;
    // A robot with a sound fix may be in another part, too; a lost one is looked for in its own.
    part != 0 && followed->doubts == 0 ? lookElsewhere(name) : lookInOwnPart(name, part, Search::Asked);
}

void LostRobots::seek(const std::string& name, const MapUpdate& update) {
    if (!update.ready) return;
    Lost& lost = m_lost.at(name);
    if (update.localisation.trust == ScanTrust::Certain) {
        lost.scans = lost.soughtAt = lost.vain = 0;
        lost.find.reset();
        return;
    }
    // A scan that sees too little determines no place.
    if (has(update.localisation.doubts, ScanDoubt::Points)) return;
    if (++lost.scans < lost.soughtAt + SoughtEvery || lost.sought) return;
    if (!m_context.makesMap()) return;
    lost.soughtAt = lost.scans;
    lost.sought = true;
    const auto& followed = m_robots.at(name).followed;
    lookInOwnPart(name, followed ? followed->part : 0, Search::Unasked);
}

void LostRobots::lookedInVain(const std::string& name, std::size_t alike, Search search) {
    if (search == Search::Asked) {
        if (m_context.listener.onLookedFor) m_context.listener.onLookedFor(name, alike);
        return;
    }
    Lost& lost = m_lost.at(name);
    lost.sought = false;
    lost.find.reset();
    if (++lost.vain >= InVain && m_context.mapper.isAstray(name)) m_context.mapper.beginPart(name);
}

bool LostRobots::findsAgree(const std::string& name, const Pose& baseInMap, Time end) {
    constexpr double FromThere = 0.5;  // from there a scan sees something else [m] ...
    constexpr double Turned = degrees(30);
    constexpr double Within = 0.3;  // [m]
    const MotionBuffer& motion = m_robots.at(name).tracker.motion();
    std::optional<Lost::Find>& before = m_lost.at(name).find;
    const auto then = motion.at(end);
    if (!then) return false;
    const Lost::Find now{baseInMap, then->baseInOdom, motion.frameAt(end)};
    if (!before || before->frame != now.frame) {
        before = now;
        return false;
    }
    const Pose moved = before->baseInOdom.inverse() * now.baseInOdom;
    if (moved.translation().norm() < FromThere && Eigen::AngleAxisd(moved.linear()).angle() < Turned)
        return false;
    const Pose expected = before->baseInMap * moved;
    const bool agree = distanceBetween(expected, baseInMap) < Within + 0.1 * moved.translation().norm() &&
                       angleBetween(expected, baseInMap) < degrees(10);
    before = now;
    return agree;
}

void LostRobots::lookInOwnPart(const std::string& name, std::uint64_t part, Search search) {
    const MappedRobot& robot = m_robots.at(name);
    Lost& lost = m_lost.at(name);
    const std::uint64_t put = search == Search::Asked ? ++lost.put : lost.put;
    if (!robot.newest || !m_context.map) return lookedInVain(name, 0, search);
    m_context.solving.submit([this, name, put, part, search, scan = robot.newest,
                              map = m_context.map](const std::stop_token& stop) {
        const Progress progress{{}, stop};
        const auto own = std::make_shared<LiveMap>(LiveMap{ofPart(map->scans, part)});
        const RelocalisationSettings how =
            search == Search::Asked ? forLostRobots() : RelocalisationSettings{};
        const Relocaliser relocaliser(own, m_context.settings, how, progress);
        const auto found = relocaliser.find(
            *scan->ready, reducedAgain(*scan->ready, m_context.settings.match), scan->live.up, progress);
        if (stop.stop_requested()) return;
        m_context.post([this, name, put, search, scan, map, found](LiveMapper&) {
            Lost& sought = m_lost.at(name);
            if (search == Search::Unasked) sought.sought = false;
            if (sought.put == put) lookedFor(name, *scan, map, found, search);
        });
    });
}

void LostRobots::lookedFor(const std::string& name, const SeenScan& scan, const LiveMapPtr& map,
                           const Relocalisation& found, Search search) {
    if (!m_context.makesMap()) return;
    MappedRobot& robot = m_robots.at(name);
    // A robot whose scans fit again meanwhile is where it is known to be.
    if (search == Search::Unasked && m_lost.at(name).scans == 0) return;
    if (!found.sure) return lookedInVain(name, found.places.size(), search);
    const AlikePlace& place = found.places.front();
    const Pose baseThen = place.scanInMap * scan.live.sensorInBase.inverse();
    if (search == Search::Unasked && !findsAgree(name, baseThen, scan.live.scan->end)) return;
    // The map may have moved meanwhile, and the robot too, by its odometry.
    const Pose then = MovedPlaces(*map, *m_context.map).at(baseThen.translation()) * baseThen;
    const Time end = scan.live.scan->end;
    const auto fix = m_context.mapper.fix(name);
    const Time newest = fix ? fix->stamp : end;
    const MotionBuffer& motion = robot.tracker.motion();
    const auto before = motion.at(end), here = motion.at(newest);
    const bool goesOn = before && here && motion.frameAt(end) == motion.frameAt(newest);
    if (newest != end && !goesOn) {  // its motion since that scan is unknown
        if (search == Search::Asked) lookedInVain(name, found.places.size(), search);
        return;
    }
    m_context.mapper.place(name, goesOn ? then * before->baseInOdom.inverse() * here->baseInOdom : then);
    m_placing.publish(robot.laser.foundByScan(then, end, place.overlap, stationTime()));
}

void LostRobots::lookElsewhere(const std::string& name) {
    const auto newest =
        std::find_if(m_context.map->scans.rbegin(), m_context.map->scans.rend(),
                     [&](const LiveKeyScan& scan) { return scan.scan->robot == name && scan.counts(); });
    if (newest == m_context.map->scans.rend()) {
        if (m_context.listener.onLookedFor) m_context.listener.onLookedFor(name, 0);
        return;
    }
    SoughtPlace sought{newest->id, m_context.map, {}, true};
    m_context.solving.submit([this, name, sought = std::move(sought)](const std::stop_token& stop) {
        const auto found = recognise(sought, m_context.settings, {}, Progress{{}, stop});
        if (stop.stop_requested()) return;
        m_context.post([this, name, id = sought.scan, found](LiveMapper& mapper) {
            if (!m_context.makesMap()) return;
            const auto question =
                found ? mapper.propose(id, *found, stationTime()) : Result<ScanLinksSample>(Error{});
            if (question && m_context.listener.onLoop) m_context.listener.onLoop(*question);
            if (!question && m_context.listener.onLookedFor) m_context.listener.onLookedFor(name, 0);
        });
    });
}

}  // namespace leitstand
