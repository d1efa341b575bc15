#include "app/services/mapping/robots/left_out_bodies.h"

#include <cstddef>
#include <utility>

#include "app/services/log/sequencer.h"
#include "app/services/mapping/robots/mapping_context.h"
#include "app/services/places/mission_map.h"

namespace leitstand {
namespace {

constexpr std::size_t MostBodies = 500;  ///< in a scan
constexpr double Jumped = 0.5,
                 JumpedAngle = degrees(15);  ///< more than odometry errs between two fixes [m], [rad]

/// Whether a robot at @p baseInMap, whose odometry frame lies at @p after in the map, is elsewhere than with
/// the frame at @p before.
bool jumped(const Pose& before, const Pose& after, const Pose& baseInMap) {
    const Pose was = before * after.inverse() * baseInMap;
    return distanceBetween(was, baseInMap) > Jumped || angleBetween(was, baseInMap) > JumpedAngle;
}

}  // namespace

std::vector<PlacedBody> LeftOutBodies::in(const Scan& scan, const std::string& only) {
    std::vector<PlacedBody> bodies;
    const MappedRobot& seeing = m_robots.at(scan.robot);
    for (const RobotDescription& description : m_robots.descriptions()) {
        const MappedRobot& other = m_robots.at(description.name);
        if (&other == &seeing || (!only.empty() && description.name != only)) continue;
        const auto later = other.ahead - seeing.ahead;
        addBodies(bodies, other.tracker, {description.footprint, description.height}, scan.start + later,
                  scan.end + later);
    }
    return bodies;
}

bool LeftOutBodies::leaveOutPlaced(Time now) {
    const bool ours = m_context.makesMap();  // else its maker publishes this
    std::map<std::uint64_t, std::vector<BodyInScan>> found;
    for (auto& [name, robot] : m_robots.byName()) {
        // For a robot in another part of the map, nobody knows where it was in this one.
        const bool certain = robot.tracker.now().certain && !(robot.followed && robot.followed->part != 0);
        const auto& odomInMap = robot.tracker.odomInMap();
        Sure& sure = m_sure[name];
        if (certain && !sure.now && ours && m_context.map) {
            // A robot placed by its laser alone that now stands elsewhere than its odometry had it was placed
            // wrongly. One with its own scans was carried.
            const bool goesOn = sure.last && odomInMap && sure.inFrame &&
                                (m_context.mapper.fix(name) ||
                                 !jumped(*sure.inFrame, *odomInMap, robot.tracker.now().baseInMap));
            leaveOut(name, goesOn ? sure.last : std::nullopt, found);
        }
        sure.now = certain;
        if (!certain) continue;
        sure.last = now;
        sure.inFrame = odomInMap;
    }
    if (found.empty()) return false;
    publish(std::move(found), now);
    return true;
}

void LeftOutBodies::publish(std::map<std::uint64_t, std::vector<BodyInScan>> found, Time now) const {
    if (!m_context.listener.onBodies) return;
    for (ScanBodiesSample& sample : inSamples(std::move(found), now))
        m_context.listener.onBodies(std::move(sample));
}

void LeftOutBodies::lookForPassing() {
    if (m_looks || m_entered.empty() || !m_context.map) return;
    m_looks = true;
    // One after another, so that solving waits for one at most.
    const std::uint64_t id = m_entered.front();
    m_entered.erase(m_entered.begin());
    m_context.solving.submit([this, id, map = m_context.map,
                              together = m_context.mapper.together(id)](const std::stop_token& stop) {
        if (stop.stop_requested()) return;
        const auto found = m_passing.add(*map, id, together);
        m_looks = false;
        if (found.empty()) return m_wake();  // starts the next one
        m_context.post([this, found](LiveMapper&) { leaveOutPassing(found); });
    });
}

void LeftOutBodies::leaveOutPassing(std::map<std::uint64_t, std::vector<BodyInScan>> found) {
    if (!m_context.makesMap()) return;  // the station that makes it publishes this
    std::map<std::uint64_t, std::vector<BodyInScan>> changed;
    for (auto& [id, passing] : found) {
        std::vector<BodyInScan> bodies = m_context.mapper.bodiesIn(id);
        std::erase_if(bodies, [](const BodyInScan& body) { return body.robot == PassingBodies::Name; });
        if (bodies.size() + passing.size() > MostBodies) continue;
        bodies.insert(bodies.end(), passing.begin(), passing.end());
        if (m_context.mapper.leaveOut(id, bodies)) changed[id] = std::move(bodies);
    }
    if (!changed.empty()) publish(std::move(changed), stationTime());
}

void LeftOutBodies::leaveOut(const std::string& name, const std::optional<Time>& since,
                             std::map<std::uint64_t, std::vector<BodyInScan>>& found) {
    for (const LiveKeyScan& one : m_context.map->scans) {
        const bool ofThisRun = one.odometryFrame >= 0 && m_robots.contains(one.scan->robot);
        if (!ofThisRun || one.scan->robot == name || (since && one.entered < *since)) continue;
        const auto here = inScan(name, in(*one.scan, name), one.pose.scanInMap);
        std::vector<BodyInScan> bodies = m_context.mapper.bodiesIn(one.id);
        if (here.empty() || bodies.size() + here.size() > MostBodies) continue;
        bodies.insert(bodies.end(), here.begin(), here.end());  // beside other possible places
        if (m_context.mapper.leaveOut(one.id, bodies)) found[one.id] = std::move(bodies);
    }
}

void LeftOutBodies::entered(std::uint64_t scan) {
    if (m_context.makesMap()) m_entered.push_back(scan);
}

}  // namespace leitstand
