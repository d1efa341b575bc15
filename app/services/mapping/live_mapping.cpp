#include "app/services/mapping/live_mapping.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <optional>
#include <variant>

#include "app/services/log/sequencer.h"
#include "app/services/mapping/scanner_advice.h"
#include "core/mapping/live/scan_doubts.h"
#include "core/mapping/placement/placement_format.h"

namespace leitstand {

namespace {

bool sameFix(const std::optional<RobotFix>& a, const RobotFix& b) {
    return a && a->stamp == b.stamp && a->doubts == b.doubts && a->certainty == b.certainty &&
           a->part == b.part && a->baseInMap.matrix() == b.baseInMap.matrix();
}

}  // namespace

MapPtr shownMap(const LiveMap& live, const MapPtr& before) {
    auto map = std::make_shared<Map>();
    map->scans.reserve(live.scans.size());
    std::size_t known = 0;  // index in before; both are sorted by id
    for (const LiveKeyScan& one : live.scans) {
        if (one.pose.trust == ScanTrust::SetAside) continue;
        MapScan scan;
        scan.scan = one.scan;
        scan.poseInMap = scan.guessInMap = one.pose.scanInMap;
        scan.pointsUsed = one.reduced ? one.reduced->size().value_or(0) : 0;
        while (before && known < before->scans.size() && before->scans[known].id < one.id) ++known;
        if (before && known < before->scans.size() && before->scans[known].scan == one.scan) {
            scan.labelCounts = before->scans[known].labelCounts;
        } else {
            for (const Label label : one.scan->labels) ++scan.labelCounts[static_cast<std::size_t>(label)];
        }
        scan.registered = one.matched != 0;
        scan.icp.converged = one.pose.converged;
        scan.icp.stop = one.pose.converged ? IcpStop::Converged : IcpStop::IterationLimit;
        scan.icp.rms = one.pose.rms;
        scan.icp.inlierRatio = one.pose.inlierRatio;
        scan.icp.overlap = one.pose.overlap;
        scan.icp.certainty = one.counts() ? one.pose.certainty : 0.0;
        scan.id = one.id;
        scan.entered = one.entered;
        scan.uncertain = one.pose.trust == ScanTrust::Uncertain;
        map->scans.push_back(std::move(scan));
    }
    return map;
}

LiveSettings settingsOf(const std::vector<RobotDescription>& robots, LiveSettings settings) {
    for (const RobotDescription& robot : robots) {
        if (robot.refineTurns) settings.refined.insert(robot.name);
    }
    return settings;
}

void restore(LiveMapper& mapper, const EarlierMap& earlier) {
    for (const KeyScanSample& scan : earlier.scans) mapper.restore(scan);
    if (earlier.scans.empty()) return;
    for (const ScanLinksSample& links : earlier.links) mapper.restore(links);
    mapper.followLoops(earlier.loops);
    mapper.follow(earlier.poses);
    for (const auto& [scan, bodies] : earlier.bodies) mapper.leaveOut(scan, bodies);
}

LiveMapping::Robot::Robot(const RobotDescription& description, const std::string& station)
    : poses(description),
      tracker(description.name),
      laser(tracker, station),
      scanner(onlyScanner(description)) {
    // Cutters must know the motion before the first slice.
    for (const StreamDescription& stream : description.streams) {
        if (stream.role == StreamRole::Points) cutters.try_emplace(stream.topic, description.name);
    }
}

LiveMapping::LiveMapping(const std::vector<RobotDescription>& robots, const std::string& station,
                         const LiveSettings& settings, LiveMappingListener listener,
                         const EarlierMap& earlier)
    : m_descriptions(robots),
      m_listener(std::move(listener)),
      m_settings(settingsOf(robots, settings)),
      m_mapper(station, m_settings),
      m_crop(settings.crop) {
    for (const RobotDescription& robot : m_descriptions) {
        m_robots.try_emplace(robot.name, robot, station).first->second.laser.setCrop(settings.crop);
        m_mapper.setBody(robot.name, {robot.footprint, robot.height});
    }
    restore(m_mapper, earlier);
    if (earlier.asRecorded) m_mapper.takeAsSolved();
    if (!earlier.scans.empty()) {
        if (earlier.shared) m_mapper.beginBlock();
        for (auto& [name, robot] : m_robots) {
            const auto place = earlier.places.find(name);
            if (place != earlier.places.end() && !m_mapper.fix(name)) robot.laser.restore(place->second);
        }
        followFixes();
        publishMap();
        std::vector<MatchedCloudPtr> matched;
        for (const LiveKeyScan& scan : m_map->scans) matched.push_back(scan.reduced);
        makeMatched(std::move(matched));
    }
    publishRobots();
    m_solver = std::jthread([this](const std::stop_token& stop) { m_solving.work(stop); });
    m_thread = std::jthread([this](const std::stop_token& stop) { run(stop); });
}

LiveMapping::~LiveMapping() = default;

void LiveMapping::close() {
    m_thread.request_stop();
    if (m_thread.joinable()) m_thread.join();
    m_solving.cancel();
    m_solver.request_stop();
    if (m_solver.joinable()) m_solver.join();
}

void LiveMapping::onEvent(const Event& event) {
    const bool wanted = std::holds_alternative<OdometrySample>(event.sample) ||
                        std::holds_alternative<ImuSample>(event.sample) ||
                        std::holds_alternative<CloudSample>(event.sample) ||
                        std::holds_alternative<RangesSample>(event.sample) ||
                        event.role == StreamRole::StaticTransforms;
    const auto* clock = std::get_if<ClockOffsetSample>(&event.sample);
    if (clock == nullptr && !wanted) return;
    if (!m_robots.contains(clock != nullptr ? clock->robot : event.robot)) return;
    {
        const std::lock_guard lock(m_mutex);
        m_waiting.emplace_back(event);
    }
    m_came.notify_all();
}

void LiveMapping::post(std::function<void(LiveMapper&)> task) {
    {
        const std::lock_guard lock(m_mutex);
        m_waiting.emplace_back(std::move(task));
    }
    m_came.notify_all();
}

void LiveMapping::setCrop(const MapCrop& crop) {
    post([this, crop](LiveMapper& mapper) {
        mapper.setCrop(crop);
        m_crop = crop;
        for (auto& [name, robot] : m_robots) robot.laser.setCrop(crop);
    });
}

RobotsInMapPtr LiveMapping::robots() const {
    const std::lock_guard lock(m_mutex);
    return m_places;
}

ScanCutter& LiveMapping::cutterOf(Robot& robot, const Event& event) {
    return robot.cutters.try_emplace(event.topic, event.robot).first->second;
}

void LiveMapping::work(const Event& event) {
    if (const auto* clock = std::get_if<ClockOffsetSample>(&event.sample)) {
        m_robots.at(clock->robot).ahead = clock->ahead;
        return;
    }
    Robot& robot = m_robots.at(event.robot);
    if (event.role == StreamRole::StaticTransforms) {
        robot.poses.add(event);
    } else if (const auto* odometry = std::get_if<OdometrySample>(&event.sample)) {
        for (auto& [topic, cutter] : robot.cutters) cutter.add(*odometry, event.received);
        robot.tracker.add(*odometry, event.received);
    } else if (const auto* imu = std::get_if<ImuSample>(&event.sample)) {
        const Pose unit = robot.poses.inBase(event.sensor, imu->header.frame);
        for (auto& [topic, cutter] : robot.cutters) cutter.add(*imu, unit, event.received);
        robot.tracker.add(*imu, unit, event.received);
    } else if (const auto* cloud = std::get_if<CloudSample>(&event.sample)) {
        const Pose sensor = robot.poses.inBase(event.sensor, cloud->header.frame);
        if (!robot.poses.isOfScanner(cloud->header.frame)) robot.scanner.clear();
        CloudSample corrected = *cloud;
        if (corrected.header.stamp == Time{}) corrected.header.stamp = event.received;
        robot.poses.correctionOf(event.sensor, cloud->header.frame).correct(corrected);
        cutterOf(robot, event).add(std::move(corrected), sensor, event.received);
    } else if (const auto* ranges = std::get_if<RangesSample>(&event.sample)) {
        if (m_mapper.fix(event.robot)) return robot.laser.rest();  // its 3D scans show more
        RangesSample stamped = *ranges;
        if (stamped.header.stamp == Time{}) stamped.header.stamp = event.received;
        const Pose laser = robot.poses.inBase(event.sensor, ranges->header.frame);
        seeing(event.robot, robot, laserView(stamped, laser, robot.tracker.motion()), event.received);
    }
}

void LiveMapping::work(const Task& task) {
    task(m_mapper);
    followFixes();
    const LiveMapPtr before = m_map;
    publishRobots();  // before the map: whoever is notified of it asks where they are in it
    publishMap();
    if (scansMoved(before, *m_map)) layTrails();
}

void LiveMapping::registerDone(Time now) {
    for (auto& [name, robot] : m_robots) {
        for (auto& [topic, cutter] : robot.cutters) {
            for (const LiveScan& scan : cutter.take(now)) {
                place(robot, scan, now);
                const LiveMapPtr before = m_map;
                const MapUpdate update = m_mapper.add(scan, now, bodiesIn(*scan.scan));
                if (update.ready) matched(name, now);
                // A scan with too few points, as the rest of an interrupted turn, determines no place.
                if (update.ready && !has(update.localisation.doubts, ScanDoubt::Points))
                    robot.newest = std::make_shared<const SeenScan>(SeenScan{scan, update.ready});
                followFixes();
                seekLost(name, robot, update);
                if (m_listener.onUpdate) m_listener.onUpdate(update);
                // Before the map: whoever is notified of it asks where robots are, and about scanners.
                if (update.keyScan) publishScanner(name, robot);
                if (update.keyScan || update.poses) {
                    publishRobots();
                    publishMap();
                }
                if (update.keyScan && (!m_listener.makesMap || m_listener.makesMap()))
                    m_entered.push_back(update.keyScan->id);
                placeOthers(now);  // also while this one stands: the others' lasers may have come since
                placeSeen(update, before, now);
            }
        }
    }
}

void LiveMapping::publishScanner(const std::string& name, Robot& robot) {
    if (robot.scanner.empty() || !m_listener.onScanner) return;
    const auto more = m_mapper.calibration(name).advised(robot.advised, robot.leftAsIs);
    if (more.has_value() == robot.advised.has_value() && (!more || asksAlike(*more, *robot.advised))) return;
    robot.advised = more;
    m_listener.onScanner(name, {robot.poses.correctionOf(robot.scanner, robot.scanner), more});
}

void LiveMapping::correct(const std::string& name, const ScannerCorrection& correction) {
    post([this, name, correction](LiveMapper& mapper) {
        Robot& robot = m_robots.at(name);
        // A turn gathered with the previous clock does not continue with the new one.
        if (robot.poses.correctionOf(robot.scanner, robot.scanner).clock != correction.clock) {
            for (auto& [topic, cutter] : robot.cutters) cutter.restart();
        }
        robot.poses.setCorrection(robot.scanner, robot.scanner, correction);
        robot.advised.reset();
        mapper.recalibrate(name);
        if (m_listener.onScanner) m_listener.onScanner(name, {correction});
    });
}

void LiveMapping::leaveAsIs(const std::string& name, ScannerFault fault) {
    post([this, name, fault](LiveMapper&) {
        Robot& robot = m_robots.at(name);
        robot.leftAsIs.insert(fault);
        publishScanner(name, robot);
    });
}

void LiveMapping::solveLoops() {
    if (m_solves || (m_listener.makesMap && !m_listener.makesMap())) return;
    auto problem = m_mapper.problem();
    if (!problem) return;
    m_solves = true;
    m_solving.submitFirst([this, problem = std::move(*problem)](const std::stop_token& stop) {
        const MapSolution solution = leitstand::solve(problem, Progress{{}, stop});
        if (stop.stop_requested()) return;
        post([this, solution](LiveMapper&) { settle(solution); });
    });
}

void LiveMapping::meetMore() {
    if (!m_mapper.meetsMore() || m_solves) return;
    if (m_listener.makesMap && !m_listener.makesMap()) return m_mapper.meetNoMore();
    const auto links = m_mapper.meetMore(stationTime());
    if (links && m_listener.onLoop) m_listener.onLoop(*links);
}

void LiveMapping::settle(const MapSolution& solution) {
    m_solves = false;
    if (m_listener.makesMap && !m_listener.makesMap()) return m_mapper.leaveUnsettled();
    const Settled settled = m_mapper.settle(solution, stationTime());
    if (settled.poses) carryAlong();
    if (m_listener.onSettled && (settled.links || settled.poses)) m_listener.onSettled(settled);
}

void LiveMapping::makeMatched(std::vector<MatchedCloudPtr> left) {
    if (left.empty()) return;
    // One after another, so that solving waits for one at most.
    m_solving.submit([this, left = std::move(left)](const std::stop_token& stop) mutable {
        if (stop.stop_requested()) return;
        const MatchedCloudPtr matched = std::move(left.back());
        left.pop_back();
        if (matched && !matched->size()) (void)matched->unpacked();
        makeMatched(std::move(left));
    });
}

void LiveMapping::whenCalm(std::function<void()> done) {
    post([this, done = std::move(done)](LiveMapper&) { m_calmed.push_back(done); });
}

void LiveMapping::look(std::function<void(const LiveMapper&)> look) {
    {
        const std::lock_guard lock(m_mutex);
        m_waiting.emplace_back(Look{std::move(look)});
    }
    m_came.notify_all();
}

void LiveMapping::preview(std::vector<Link> links, std::function<void(LoopPreview)> done) {
    look([this, links = std::move(links), done = std::move(done)](const LiveMapper& mapper) {
        m_solving.submitFirst([this, problem = mapper.problemWith(links), map = mapper.map(),
                               done](const std::stop_token& stop) {
            const MapSolution solution = leitstand::solve(problem, Progress{{}, stop});
            if (!stop.stop_requested()) done(previewOf(*map, solution, m_settings.loops));
        });
    });
}

void LiveMapping::seekPlace() {
    if (m_seeks) return;
    auto sought = m_mapper.sought();  // also when another station makes the map: later it is of no use
    if (!sought || (m_listener.makesMap && !m_listener.makesMap())) return;
    m_seeks = true;
    m_solving.submit([this, sought = std::move(*sought)](const std::stop_token& stop) {
        const auto found = recognise(sought, m_settings, {}, Progress{{}, stop});
        if (stop.stop_requested()) return;
        post([this, sought, found](LiveMapper& mapper) {
            m_seeks = false;
            if (!found || (m_listener.makesMap && !m_listener.makesMap())) return;
            const auto loop = mapper.recognised(sought, *found, stationTime());
            if (loop && m_listener.onLoop) m_listener.onLoop(*loop);
        });
    });
}

void LiveMapping::followFixes() {
    for (auto& [name, robot] : m_robots) {
        const auto fix = m_mapper.fix(name);
        if (!fix || sameFix(robot.followed, *fix)) continue;
        robot.followed = fix;
        const bool certain = fix->doubts == 0;
        robot.tracker.correct({fix->stamp, fix->baseInMap, certain ? fix->certainty : 0.0, certain,
                               !certain         ? inWords(fix->doubts)
                               : fix->part != 0 ? logged(placement_format::OwnPart)
                                                : logged(placement_format::FitsMap)});
    }
}

void LiveMapping::publishMap() {
    m_map = m_mapper.map();
    if (m_listener.onMap) m_listener.onMap(m_map);
}

void LiveMapping::publishRobots() {
    auto places = std::make_shared<RobotsInMap>();
    for (const auto& [name, robot] : m_robots) {
        places->push_back(robot.tracker.now());
        places->back().matched = robot.matched;
        if (robot.followed) places->back().spinning = robot.followed->spinningAt(places->back().stamp);
    }
    const std::lock_guard lock(m_mutex);
    for (RobotInMap& place : *places) {
        const auto scanReceived = m_received.find(place.robot);
        if (scanReceived != m_received.end()) place.matched = scanReceived->second;
    }
    m_places = std::move(places);
}

std::optional<Time> LiveMapping::due() const {
    std::optional<Time> first;
    for (const auto& [name, robot] : m_robots) {
        for (const auto& [topic, cutter] : robot.cutters) {
            const auto one = cutter.due();
            if (one && (!first || *one < *first)) first = one;
        }
    }
    return first;
}

void LiveMapping::run(const std::stop_token& stop) {
    while (!stop.stop_requested()) {
        std::deque<Work> taken;
        {
            std::unique_lock lock(m_mutex);
            const auto came = [this] { return !m_waiting.empty() || (m_mapper.meetsMore() && !m_solves); };
            if (const auto until = due()) {
                m_came.wait_until(lock, stop, *until, came);
            } else {
                m_came.wait(lock, stop, came);
            }
            taken.swap(m_waiting);
        }
        for (const Work& one : taken) {
            if (stop.stop_requested()) return;
            std::visit([this](const auto& content) { work(content); }, one);
        }
        registerDone(stationTime());
        solveLoops();
        meetMore();
        seekPlace();
        lookForPassing();
        if (leaveOutPlaced(stationTime())) publishMap();
        publishRobots();
        if (m_solves || m_mapper.meetsMore()) continue;
        for (const auto& calmed : std::exchange(m_calmed, {})) calmed();
    }
}

}  // namespace leitstand
