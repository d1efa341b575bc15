#include "app/services/mapping/live_mapping.h"

#include <utility>

#include "app/services/log/sequencer.h"
#include "core/mapping/relocalisation/place_recognition.h"

namespace leitstand {

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

LiveMapping::LiveMapping(const std::vector<RobotDescription>& robots, const std::string& station,
                         const LiveSettings& settings, LiveMappingListener listener,
                         const EarlierMap& earlier)
    : m_context(station, settingsOf(robots, settings), std::move(listener),
                [this](Task task) { post(std::move(task)); }),
      m_robots(m_context, robots, station,
               [this](const std::string& name, MappedRobot& robot, LaserView view, Time now) {
                   m_placing.seeing(name, robot, std::move(view), now);
               }),
      m_placing(m_context, m_robots),
      m_lost(m_context, m_robots, m_placing),
      m_bodies(m_context, m_robots, [this] { look([](const LiveMapper&) {}); }) {
    restore(m_context.mapper, earlier);
    if (earlier.asRecorded) m_context.mapper.takeAsSolved();
    if (!earlier.scans.empty()) {
        if (earlier.shared) m_context.mapper.beginBlock();
        for (const auto& [name, place] : earlier.places) {
            if (m_robots.contains(name) && !m_context.mapper.fix(name))
                m_robots.at(name).laser.restore(place);
        }
        m_robots.followFixes();
        publishMap();
        std::vector<MatchedCloudPtr> matched;
        for (const LiveKeyScan& scan : m_context.map->scans) matched.push_back(scan.reduced);
        makeMatched(std::move(matched));
    }
    m_robots.publish();
    m_solver = std::jthread([this](const std::stop_token& stop) { m_context.solving.work(stop); });
    m_thread = std::jthread([this](const std::stop_token& stop) { run(stop); });
}

LiveMapping::~LiveMapping() = default;

void LiveMapping::close() {
    m_thread.request_stop();
    if (m_thread.joinable()) m_thread.join();
    m_context.solving.cancel();
    m_solver.request_stop();
    if (m_solver.joinable()) m_solver.join();
}

void LiveMapping::wait(Work work) {
    {
        const std::lock_guard lock(m_mutex);
        m_waiting.push_back(std::move(work));
    }
    m_came.notify_all();
}

void LiveMapping::onEvent(const Event& event) {
    if (m_robots.isOfOurs(event)) wait(event);
}

void LiveMapping::post(std::function<void(LiveMapper&)> task) {
    wait(std::move(task));
}

void LiveMapping::look(std::function<void(const LiveMapper&)> look) {
    wait(Look{std::move(look)});
}

void LiveMapping::setCrop(const MapCrop& crop) {
    post([this, crop](LiveMapper& mapper) {
        mapper.setCrop(crop);
        m_context.crop = crop;
        for (auto& [name, robot] : m_robots.byName()) robot.laser.setCrop(crop);
    });
}

RobotsInMapPtr LiveMapping::robots() const {
    return m_robots.inMap();
}

void LiveMapping::adopt(const KeyScanSample& keyScan) {
    post([this, keyScan](LiveMapper& mapper) {
        mapper.adopt(keyScan);
        m_robots.matchedElsewhere();
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

void LiveMapping::follow(std::vector<ScanPose> poses) {
    post([poses = std::move(poses)](LiveMapper& mapper) { mapper.follow(poses); });
}

void LiveMapping::follow(const RobotPlaceSample& place) {
    post([this, place](LiveMapper&) { m_placing.follow(place); });
}

void LiveMapping::scanReceived(const std::string& robot, Time received) {
    m_robots.scanReceived(robot, received);
}

void LiveMapping::place(const std::string& robot, const Pose& baseInMap) {
    post([this, robot, baseInMap](LiveMapper&) {
        m_lost.wasPut(robot);
        m_placing.put(robot, baseInMap);
    });
}

void LiveMapping::lookFor(const std::string& robot) {
    post([this, robot](LiveMapper&) { m_lost.lookFor(robot); });
}

void LiveMapping::mapWith(const std::string& robot, const std::string& topic) {
    post([this, robot, topic](LiveMapper& mapper) {
        m_scanners.erase(robot);  // what was found and left as it is was about another scanner
        mapper.recalibrate(robot);
        m_robots.mapWith(robot, topic);
    });
}

void LiveMapping::work(const Event& event) {
    m_robots.add(event);
}

void LiveMapping::work(const Look& look) {
    look.look(m_context.mapper);
}

void LiveMapping::work(const Task& task) {
    task(m_context.mapper);
    m_robots.followFixes();
    const LiveMapPtr before = m_context.map;
    m_robots.publish();  // before the map: whoever is notified of it asks where they are in it
    publishMap();
    if (scansMoved(before, *m_context.map)) m_robots.layTrails();
}

void LiveMapping::registerDone(Time now) {
    for (auto& [name, robot] : m_robots.byName()) {
        for (auto& [topic, cutter] : robot.cutters) {
            for (const LiveScan& scan : cutter.take(now)) {
                m_placing.place(robot, scan, now);
                const LiveMapPtr before = m_context.map;
                const MapUpdate update = m_context.mapper.add(scan, now, m_bodies.in(*scan.scan));
                if (update.ready) m_robots.matched(name, now);
                // A scan with too few points, as the rest of an interrupted turn, determines no place.
                if (update.ready && !has(update.localisation.doubts, ScanDoubt::Points))
                    robot.newest = std::make_shared<const SeenScan>(SeenScan{scan, update.ready});
                m_robots.followFixes();
                m_lost.seek(name, update);
                if (m_context.listener.onUpdate) m_context.listener.onUpdate(update);
                // Before the map: whoever is notified of it asks where robots are, and about scanners.
                if (update.keyScan) publishScanner(name);
                if (update.keyScan || update.poses) {
                    m_robots.publish();
                    publishMap();
                }
                if (update.keyScan) m_bodies.entered(update.keyScan->id);
                m_placing.placeOthers(
                    now);  // also while this one stands: the others' lasers may have come since
                m_placing.placeSeen(update, before, now);
            }
        }
    }
}

void LiveMapping::publishScanner(const std::string& name) {
    const MappedRobot& robot = m_robots.at(name);
    if (robot.scanner.empty() || !m_context.listener.onScanner) return;
    ScannerReport& report = m_scanners[name];
    const auto more = m_context.mapper.calibration(name).advised(report.advised, report.leftAsIs);
    if (more.has_value() == report.advised.has_value() && (!more || asksAlike(*more, *report.advised)))
        return;
    report.advised = more;
    m_context.listener.onScanner(name, {robot.poses.correctionOf(robot.scanner, robot.scanner), more});
}

void LiveMapping::correct(const std::string& name, const ScannerCorrection& correction) {
    post([this, name, correction](LiveMapper& mapper) {
        MappedRobot& robot = m_robots.at(name);
        // A turn gathered with the previous clock does not continue with the new one.
        if (robot.poses.correctionOf(robot.scanner, robot.scanner).clock != correction.clock) {
            for (auto& [topic, cutter] : robot.cutters) cutter.restart();
        }
        robot.poses.setCorrection(robot.scanner, robot.scanner, correction);
        m_scanners[name].advised.reset();
        mapper.recalibrate(name);
        if (m_context.listener.onScanner) m_context.listener.onScanner(name, {correction});
    });
}

void LiveMapping::leaveAsIs(const std::string& name, ScannerFault fault) {
    post([this, name, fault](LiveMapper&) {
        m_scanners[name].leftAsIs.insert(fault);
        publishScanner(name);
    });
}

void LiveMapping::solveLoops() {
    if (m_solves || !m_context.makesMap()) return;
    auto problem = m_context.mapper.problem();
    if (!problem) return;
    m_solves = true;
    m_context.solving.submitFirst([this, problem = std::move(*problem)](const std::stop_token& stop) {
        const MapSolution solution = leitstand::solve(problem, Progress{{}, stop});
        if (stop.stop_requested()) return;
        post([this, solution](LiveMapper&) { settle(solution); });
    });
}

void LiveMapping::meetMore() {
    if (!m_context.mapper.meetsMore() || m_solves) return;
    if (!m_context.makesMap()) return m_context.mapper.meetNoMore();
    const auto links = m_context.mapper.meetMore(stationTime());
    if (links && m_context.listener.onLoop) m_context.listener.onLoop(*links);
}

void LiveMapping::settle(const MapSolution& solution) {
    m_solves = false;
    if (!m_context.makesMap()) return m_context.mapper.leaveUnsettled();
    const Settled settled = m_context.mapper.settle(solution, stationTime());
    if (settled.poses) m_robots.carryAlong();
    if (m_context.listener.onSettled && (settled.links || settled.poses))
        m_context.listener.onSettled(settled);
}

void LiveMapping::makeMatched(std::vector<MatchedCloudPtr> left) {
    if (left.empty()) return;
    // One after another, so that solving waits for one at most.
    m_context.solving.submit([this, left = std::move(left)](const std::stop_token& stop) mutable {
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

void LiveMapping::preview(std::vector<Link> links, std::function<void(LoopPreview)> done) {
    look([this, links = std::move(links), done = std::move(done)](const LiveMapper& mapper) {
        m_context.solving.submitFirst([this, problem = mapper.problemWith(links), map = mapper.map(),
                                       done](const std::stop_token& stop) {
            const MapSolution solution = leitstand::solve(problem, Progress{{}, stop});
            if (!stop.stop_requested()) done(previewOf(*map, solution, m_context.settings.loops));
        });
    });
}

void LiveMapping::seekPlace() {
    if (m_seeks) return;
    auto sought =
        m_context.mapper.sought();  // also when another station makes the map: later it is of no use
    if (!sought || !m_context.makesMap()) return;
    m_seeks = true;
    m_context.solving.submit([this, sought = std::move(*sought)](const std::stop_token& stop) {
        const auto found = recognise(sought, m_context.settings, {}, Progress{{}, stop});
        if (stop.stop_requested()) return;
        post([this, sought, found](LiveMapper& mapper) {
            m_seeks = false;
            if (!found || !m_context.makesMap()) return;
            const auto loop = mapper.recognised(sought, *found, stationTime());
            if (loop && m_context.listener.onLoop) m_context.listener.onLoop(*loop);
        });
    });
}

void LiveMapping::publishMap() {
    m_context.map = m_context.mapper.map();
    if (m_context.listener.onMap) m_context.listener.onMap(m_context.map);
}

void LiveMapping::run(const std::stop_token& stop) {
    while (!stop.stop_requested()) {
        std::deque<Work> taken;
        {
            std::unique_lock lock(m_mutex);
            const auto came = [this] {
                return !m_waiting.empty() || (m_context.mapper.meetsMore() && !m_solves);
            };
            if (const auto until = m_robots.due()) {
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
        m_bodies.lookForPassing();
        if (m_bodies.leaveOutPlaced(stationTime())) publishMap();
        m_robots.publish();
        if (m_solves || m_context.mapper.meetsMore()) continue;
        for (const auto& calmed : std::exchange(m_calmed, {})) calmed();
    }
}

}  // namespace leitstand
