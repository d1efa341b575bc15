#include <algorithm>
#include <optional>
#include <utility>

#include "app/services/log/sequencer.h"
#include "app/services/mapping/live_mapping.h"
#include "app/services/places/mission_map.h"
#include "core/mapping/sighting/other_bodies.h"
#include "core/mapping/sighting/seen_bodies.h"

namespace leitstand {
namespace {

constexpr double AboutARobot = 0.1;      ///< points this close to its corners may be of a robot, too [m]
constexpr std::size_t MostBodies = 500;  ///< in a scan
constexpr int Unplaced = 3;              ///< after so many 3D scans a robot maps a part of its own
constexpr int SoughtEvery = 3;  ///< after so many scans that do not fit it is looked for, by the newest
constexpr int InVain = 3;       ///< after so many failed searches it may do so, too
constexpr double Jumped = 0.5,
                 JumpedAngle = degrees(15);  ///< more than odometry errs between two fixes [m], [rad]

/// Whether a robot at @p baseInMap, whose odometry frame lies at @p after in the map, is elsewhere than with
/// the frame at @p before.
bool jumped(const Pose& before, const Pose& after, const Pose& baseInMap) {
    const Pose was = before * after.inverse() * baseInMap;
    return distanceBetween(was, baseInMap) > Jumped || angleBetween(was, baseInMap) > JumpedAngle;
}

}  // namespace

std::vector<Disc> LiveMapping::othersThan(const Robot& robot, bool certain) const {
    std::vector<Disc> others;
    for (const RobotDescription& description : m_descriptions) {
        const Robot& other = m_robots.at(description.name);
        if (&other == &robot || !other.tracker.placed() || (certain && !other.tracker.now().certain))
            continue;
        Disc disc{other.tracker.now().baseInMap.translation().head<2>(), 0.0};
        for (const Eigen::Vector2d& corner : description.footprint)
            disc.radius = std::max(disc.radius, corner.norm() + AboutARobot);
        others.push_back(disc);
    }
    return others;
}

std::vector<PlacedBody> LiveMapping::bodiesIn(const Scan& scan, const std::string& only) const {
    std::vector<PlacedBody> bodies;
    const Robot& seeing = m_robots.at(scan.robot);
    for (const RobotDescription& description : m_descriptions) {
        const Robot& other = m_robots.at(description.name);
        if (&other == &seeing || (!only.empty() && description.name != only)) continue;
        const auto later = other.ahead - seeing.ahead;
        addBodies(bodies, other.tracker, {description.footprint, description.height}, scan.start + later,
                  scan.end + later);
    }
    return bodies;
}

bool LiveMapping::leaveOutPlaced(Time now) {
    const bool ours = !m_listener.makesMap || m_listener.makesMap();  // else its maker publishes this
    std::map<std::uint64_t, std::vector<BodyInScan>> found;
    for (auto& [name, robot] : m_robots) {
        // For a robot in another part of the map, nobody knows where it was in this one.
        const bool certain = robot.tracker.now().certain && !(robot.followed && robot.followed->part != 0);
        const auto& odomInMap = robot.tracker.odomInMap();
        if (certain && !robot.certain && ours && m_map) {
            // A robot placed by its laser alone that now stands elsewhere than its odometry had it was placed
            // wrongly. One with its own scans was carried.
            const bool goesOn =
                robot.wasSure && odomInMap && robot.wasSureBy &&
                (m_mapper.fix(name) || !jumped(*robot.wasSureBy, *odomInMap, robot.tracker.now().baseInMap));
            leaveOut(name, goesOn ? robot.wasSure : std::nullopt, found);
        }
        robot.certain = certain;
        if (!certain) continue;
        robot.wasSure = now;
        robot.wasSureBy = odomInMap;
    }
    if (found.empty()) return false;
    publishBodies(std::move(found), now);
    return true;
}

void LiveMapping::publishBodies(std::map<std::uint64_t, std::vector<BodyInScan>> found, Time now) {
    if (!m_listener.onBodies) return;
    for (ScanBodiesSample& sample : inSamples(std::move(found), now)) m_listener.onBodies(std::move(sample));
}

void LiveMapping::lookForPassing() {
    if (m_looksForPassing || m_entered.empty() || !m_map) return;
    m_looksForPassing = true;
    // One after another, so that solving waits for one at most.
    const std::uint64_t id = m_entered.front();
    m_entered.erase(m_entered.begin());
    m_solving.submit([this, id, map = m_map, together = m_mapper.together(id)](const std::stop_token& stop) {
        if (stop.stop_requested()) return;
        const auto found = m_passing.add(*map, id, together);
        m_looksForPassing = false;
        if (found.empty()) return look([](const LiveMapper&) {});  // starts the next one
        post([this, found](LiveMapper&) { leaveOutPassing(found); });
    });
}

void LiveMapping::leaveOutPassing(std::map<std::uint64_t, std::vector<BodyInScan>> found) {
    if (m_listener.makesMap && !m_listener.makesMap()) return;  // the station that makes it publishes this
    std::map<std::uint64_t, std::vector<BodyInScan>> changed;
    for (auto& [id, passing] : found) {
        std::vector<BodyInScan> bodies = m_mapper.bodiesIn(id);
        std::erase_if(bodies, [](const BodyInScan& body) { return body.robot == PassingBodies::Name; });
        if (bodies.size() + passing.size() > MostBodies) continue;
        bodies.insert(bodies.end(), passing.begin(), passing.end());
        if (m_mapper.leaveOut(id, bodies)) changed[id] = std::move(bodies);
    }
    if (!changed.empty()) publishBodies(std::move(changed), stationTime());
}

void LiveMapping::leaveOut(const std::string& name, const std::optional<Time>& since,
                           std::map<std::uint64_t, std::vector<BodyInScan>>& found) {
    for (const LiveKeyScan& one : m_map->scans) {
        const bool ofThisRun = one.odometryFrame >= 0 && m_robots.contains(one.scan->robot);
        if (!ofThisRun || one.scan->robot == name || (since && one.entered < *since)) continue;
        const auto here = inScan(name, bodiesIn(*one.scan, name), one.pose.scanInMap);
        std::vector<BodyInScan> bodies = m_mapper.bodiesIn(one.id);
        if (here.empty() || bodies.size() + here.size() > MostBodies) continue;
        bodies.insert(bodies.end(), here.begin(), here.end());  // beside other possible places
        if (m_mapper.leaveOut(one.id, bodies)) found[one.id] = std::move(bodies);
    }
}

void LiveMapping::lookFor(const std::string& name) {
    post([this, name](LiveMapper&) {
        const auto& followed = m_robots.at(name).followed;
        const std::uint64_t part = followed ? followed->part : 0;
        // A robot with a sound fix may be in another part, too; a lost one is looked for in its own.
        part != 0 && followed->doubts == 0 ? lookElsewhere(name) : lookInOwnPart(name, part, Search::Asked);
    });
}

void LiveMapping::seekLost(const std::string& name, Robot& robot, const MapUpdate& update) {
    if (!update.ready) return;
    if (update.localisation.trust == ScanTrust::Certain) {
        robot.lost = robot.soughtAt = robot.vain = 0;
        robot.find.reset();
        return;
    }
    // A scan that sees too little determines no place.
    if (has(update.localisation.doubts, ScanDoubt::Points)) return;
    if (++robot.lost < robot.soughtAt + SoughtEvery || robot.sought) return;
    if (m_listener.makesMap && !m_listener.makesMap()) return;
    robot.soughtAt = robot.lost;
    robot.sought = true;
    lookInOwnPart(name, robot.followed ? robot.followed->part : 0, Search::Unasked);
}

void LiveMapping::lookedInVain(const std::string& name, std::size_t alike, Search search) {
    if (search == Search::Asked) {
        if (m_listener.onLookedFor) m_listener.onLookedFor(name, alike);
        return;
    }
    Robot& robot = m_robots.at(name);
    robot.sought = false;
    robot.find.reset();
    if (++robot.vain >= InVain && m_mapper.isAstray(name)) m_mapper.beginPart(name);
}

bool LiveMapping::findsAgree(Robot& robot, const Pose& baseInMap, Time end) {
    constexpr double FromThere = 0.5;  // from there a scan sees something else [m] ...
    constexpr double Turned = degrees(30);
    constexpr double Within = 0.3;  // [m]
    const MotionBuffer& motion = robot.tracker.motion();
    const auto then = motion.at(end);
    if (!then) return false;
    const Robot::Find now{baseInMap, then->baseInOdom, motion.frameAt(end)};
    if (!robot.find || robot.find->frame != now.frame) {
        robot.find = now;
        return false;
    }
    const Pose moved = robot.find->baseInOdom.inverse() * now.baseInOdom;
    if (moved.translation().norm() < FromThere && Eigen::AngleAxisd(moved.linear()).angle() < Turned)
        return false;
    const Pose expected = robot.find->baseInMap * moved;
    const bool agree = distanceBetween(expected, baseInMap) < Within + 0.1 * moved.translation().norm() &&
                       angleBetween(expected, baseInMap) < degrees(10);
    robot.find = now;
    return agree;
}

void LiveMapping::lookInOwnPart(const std::string& name, std::uint64_t part, Search search) {
    Robot& robot = m_robots.at(name);
    const std::uint64_t put = search == Search::Asked ? ++robot.put : robot.put;
    if (!robot.newest || !m_map) return lookedInVain(name, 0, search);
    m_solving.submit(
        [this, name, put, part, search, scan = robot.newest, map = m_map](const std::stop_token& stop) {
            const Progress progress{{}, stop};
            const auto own = std::make_shared<LiveMap>(LiveMap{ofPart(map->scans, part)});
            const RelocalisationSettings how =
                search == Search::Asked ? forLostRobots() : RelocalisationSettings{};
            const Relocaliser relocaliser(own, m_settings, how, progress);
            const auto found = relocaliser.find(*scan->ready, reducedAgain(*scan->ready, m_settings.match),
                                                scan->live.up, progress);
            if (stop.stop_requested()) return;
            post([this, name, put, search, scan, map, found](LiveMapper&) {
                Robot& sought = m_robots.at(name);
                if (search == Search::Unasked) sought.sought = false;
                if (sought.put == put) lookedFor(name, *scan, map, found, search);
            });
        });
}

void LiveMapping::lookedFor(const std::string& name, const SeenScan& scan, const LiveMapPtr& map,
                            const Relocalisation& found, Search search) {
    if (m_listener.makesMap && !m_listener.makesMap()) return;
    Robot& robot = m_robots.at(name);
    // A robot whose scans fit again meanwhile is where it is known to be.
    if (search == Search::Unasked && robot.lost == 0) return;
    if (!found.sure) return lookedInVain(name, found.places.size(), search);
    const AlikePlace& place = found.places.front();
    const Pose baseThen = place.scanInMap * scan.live.sensorInBase.inverse();
    if (search == Search::Unasked && !findsAgree(robot, baseThen, scan.live.scan->end)) return;
    // The map may have moved meanwhile, and the robot too, by its odometry.
    const Pose then = MovedPlaces(*map, *m_map).at(baseThen.translation()) * baseThen;
    const Time end = scan.live.scan->end;
    const auto fix = m_mapper.fix(name);
    const Time newest = fix ? fix->stamp : end;
    const MotionBuffer& motion = robot.tracker.motion();
    const auto before = motion.at(end), here = motion.at(newest);
    const bool goesOn = before && here && motion.frameAt(end) == motion.frameAt(newest);
    if (newest != end && !goesOn) {  // its motion since that scan is unknown
        if (search == Search::Asked) lookedInVain(name, found.places.size(), search);
        return;
    }
    m_mapper.place(name, goesOn ? then * before->baseInOdom.inverse() * here->baseInOdom : then);
    publishPlace(robot.laser.foundByScan(then, end, place.overlap, stationTime()));
}

void LiveMapping::seeing(const std::string& name, Robot& robot, LaserView view, Time now) {
    if (const LiveKeyScan* const first = firstOfOurs()) {
        // Nobody knows how the area lies relative to another part of the map.
        const Pose here = robot.tracker.placed() ? robot.tracker.now().baseInMap : first->pose.scanInMap;
        robot.laser.setCrop(partAt(m_map->scans, here) == 0 ? m_crop : MapCrop{});
    }
    publishPlace(robot.laser.see(std::move(view), m_map, now, othersThan(robot, false)));
    placeBeside(name, robot, now);
}

void LiveMapping::publishPlace(const std::optional<RobotPlaceSample>& place) {
    if (place && m_listener.onPlace) m_listener.onPlace(*place);
}

const LiveKeyScan* LiveMapping::firstOfOurs() const {
    if (!m_map || m_map->scans.empty()) return nullptr;
    const auto ours = std::find_if(m_map->scans.begin(), m_map->scans.end(), [&](const LiveKeyScan& scan) {
        return m_robots.contains(scan.scan->robot);
    });
    return ours != m_map->scans.end() ? &*ours : &m_map->scans.front();
}

void LiveMapping::placeBeside(const std::string& name, Robot& robot, Time now) {
    if (!m_map || m_map->scans.empty()) return;
    const LiveKeyScan& first = *firstOfOurs();
    if (name == first.scan->robot || m_mapper.fix(name)) return;
    publishPlace(robot.laser.placeBeside(first.pose.scanInMap * first.sensorInBase.inverse(), m_map, now,
                                         othersThan(robot, false)));
}

void LiveMapping::placeOthers(Time now) {
    for (auto& [name, robot] : m_robots) placeBeside(name, robot, now);
}

void LiveMapping::placeSeen(const MapUpdate& update, const LiveMapPtr& before, Time now) {
    if (!update.ready || update.localisation.trust != ScanTrust::Certain) return;
    const std::string& name = update.localisation.robot;
    const auto by = std::find_if(m_descriptions.begin(), m_descriptions.end(),
                                 [&](const RobotDescription& one) { return one.name == name; });
    for (const RobotDescription& description : m_descriptions) {
        Robot& robot = m_robots.at(description.name);
        if (description.name == name || m_mapper.fix(description.name) || !robot.laser.wantsSeen()) continue;
        const RobotBody body{description.footprint, description.height};
        const LocalMap earlier = before ? localMap(before->scans, update.scanInMap) : LocalMap{};
        const auto seen = seenBodies(*update.ready, update.scanInMap, body, earlier, othersThan(robot, true));
        publishPlace(robot.laser.placeSeen(seen, body, by->title, m_map, now, othersThan(robot, false)));
    }
}

void LiveMapping::place(Robot& robot, const LiveScan& scan, Time now) {
    const std::string& name = scan.scan->robot;
    if (!m_map || m_map->scans.empty() || m_mapper.fix(name)) return;
    // Without a plane laser its 3D scans serve as well.
    if (!robot.tracker.placed() || robot.laser.resumes()) seeing(name, robot, laserView(scan), now);
    if (const auto there = robot.tracker.baseInMap(scan.scan->end)) return m_mapper.place(name, *there);
    if (++robot.unplaced >= Unplaced) m_mapper.beginPart(name);
}

void LiveMapping::lookElsewhere(const std::string& name) {
    const auto newest =
        std::find_if(m_map->scans.rbegin(), m_map->scans.rend(),
                     [&](const LiveKeyScan& scan) { return scan.scan->robot == name && scan.counts(); });
    if (newest == m_map->scans.rend()) {
        if (m_listener.onLookedFor) m_listener.onLookedFor(name, 0);
        return;
    }
    SoughtPlace sought{newest->id, m_map, {}, true};
    m_solving.submit([this, name, sought = std::move(sought)](const std::stop_token& stop) {
        const auto found = recognise(sought, m_settings, {}, Progress{{}, stop});
        if (stop.stop_requested()) return;
        post([this, name, id = sought.scan, found](LiveMapper& mapper) {
            if (m_listener.makesMap && !m_listener.makesMap()) return;
            const auto question =
                found ? mapper.propose(id, *found, stationTime()) : Result<ScanLinksSample>(Error{});
            if (question && m_listener.onLoop) m_listener.onLoop(*question);
            if (!question && m_listener.onLookedFor) m_listener.onLookedFor(name, 0);
        });
    });
}

void LiveMapping::adopt(const KeyScanSample& keyScan) {
    post([this, keyScan](LiveMapper& mapper) {
        mapper.adopt(keyScan);
        for (auto& [name, robot] : m_robots) robot.matched.reset();  // the other station matches it now
    });
}

void LiveMapping::adopt(const ScanLinksSample& links) {
    post([links](LiveMapper& mapper) { mapper.restore(links); });
}

void LiveMapping::adopt(const ScanBodiesSample& bodies) {
    post([bodies](LiveMapper& mapper) {
        for (const BodiesOfScan& one : bodies.scans) mapper.leaveOut(one.scan, one.bodies);
    });
}

void LiveMapping::scanReceived(const std::string& robot, Time received) {
    const std::lock_guard lock(m_mutex);
    m_received[robot] = received;
}

void LiveMapping::matched(const std::string& name, Time now) {
    m_robots.at(name).matched = now;
    const std::lock_guard lock(m_mutex);
    m_received.erase(name);
}

void LiveMapping::follow(std::vector<ScanPose> poses) {
    post([poses = std::move(poses)](LiveMapper& mapper) { mapper.follow(poses); });
}

void LiveMapping::follow(const RobotPlaceSample& place) {
    post([this, place](LiveMapper& mapper) {
        const auto robot = m_robots.find(place.robot);
        if (robot != m_robots.end() && !mapper.fix(place.robot)) robot->second.laser.follow(place);
    });
}

void LiveMapping::place(const std::string& name, const Pose& baseInMap) {
    post([this, name, baseInMap](LiveMapper& mapper) {
        Robot& robot = m_robots.at(name);
        ++robot.put;
        if (const auto fix = mapper.fix(name)) {
            mapper.place(name, baseInMap);
            return publishPlace(robot.laser.putUntilScan(baseInMap, fix->stamp, stationTime()));
        }
        publishPlace(robot.laser.place(baseInMap, m_map, stationTime()));
    });
}

}  // namespace leitstand
