#include "tests/simulation/mapping/mapped_drive.h"

#include <algorithm>
#include <cmath>
#include <ctime>
#include <functional>

#include <Eigen/Geometry>

#include "core/event/motion_samples.h"
#include "core/mapping/relocalisation/place_recognition.h"

namespace leitstand::simulation::test {
namespace {

/// Of the key scans that count, each where @p scanInArena puts it.
double surfaceErrorOf(const LiveMap& map, const TrueSurfaces& surfaces,
                      const std::function<Pose(const LiveKeyScan&)>& scanInArena) {
    constexpr float Near = 6.0F;
    double squares = 0.0;
    std::size_t count = 0;
    for (const LiveKeyScan& key : map.scans) {
        if (!key.counts()) continue;
        const Pose placed = scanInArena(key);
        for (std::size_t i = 0; i < key.scan->points.size(); i += 7) {
            const Eigen::Vector3f& point = key.scan->points[i];
            if (!(point.norm() < Near)) continue;
            squares += std::pow(surfaces.distance(placed * point.cast<double>()), 2);
            ++count;
        }
    }
    return std::sqrt(squares / static_cast<double>(count));
}

}  // namespace

double processorTime() {
    timespec time{};
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
    return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

std::vector<LiveScan> cutScans(const RecordedDrive& drive, const ScanCutterSettings& settings) {
    ScanCutter cutter(drive.robot.name, settings);
    std::vector<LiveScan> scans;
    const auto keep = [&](std::vector<LiveScan> more) {
        std::move(more.begin(), more.end(), std::back_inserter(scans));
    };
    for (const RecordedDrive::Received& received : drive.received) {
        const auto& sensors = drive.robot.sensors;
        if (const auto* odometry = received.sample.sample.as<OdometrySample>()) {
            cutter.add(*odometry, received.at);
        } else if (const auto* imu = received.sample.sample.as<ImuSample>()) {
            cutter.add(*imu, sensors.at(received.sample.sensor).sensorInBase, received.at);
        } else if (const auto* cloud = received.sample.sample.as<CloudSample>()) {
            cutter.add(*cloud, sensors.at(received.sample.sensor).sensorInBase, received.at);
        }
        keep(cutter.take(received.at));
    }
    keep(cutter.finish());
    return scans;
}

MappedDrive mapped(const RecordedDrive& drive, std::vector<LiveScan> scans, const LiveSettings& settings,
                   const CorrectedScans& corrected) {
    MappedDrive result;
    LiveMapper mapper("test", settings);
    mapper.setBody(drive.robot.name, {drive.robot.footprint, drive.robot.height});
    for (std::size_t next = 0; next < scans.size(); ++next) {
        const LiveScan live = scans[next];
        const double before = processorTime();
        const MapUpdate update = mapper.add(live, live.scan->end);
        result.busy.push_back(processorTime() - before);
        for (const auto* reported : {&update.links, &update.loop}) {
            if (!*reported) continue;
            for (const Link& link : (*reported)->links) result.graph.add(link);
        }
        if (const auto sought = mapper.sought()) {
            const double began = processorTime();
            const auto found = recognise(*sought, settings);
            result.seeking.push_back(processorTime() - began);
            const auto loop =
                found ? mapper.recognised(*sought, *found, live.scan->end) : std::optional<ScanLinksSample>{};
            for (const Link& link : loop ? loop->links : std::vector<Link>{}) result.graph.add(link);
        }
        if (const auto problem = mapper.problem()) {
            const double began = processorTime();
            const MapSolution solution = solve(*problem);
            result.solving.push_back(processorTime() - began);
            const Settled settled = mapper.settle(solution, live.scan->end);
            result.settling.push_back(processorTime() - began - result.solving.back());
            result.contradicted += static_cast<int>(solution.contradicted.size());
            if (settled.poses) ++result.moves;
            if (settled.links) {
                for (const Link& link : settled.links->links) result.graph.add(link);
            }
        }
        const Localisation& here = update.localisation;
        const Pose truth = drive.baseInArena(here.stamp);
        result.live.found.push_back(here.baseInMap);
        result.odometry.found.push_back(live.scan->sensorInOdom * live.sensorInBase.inverse());
        result.live.truth.push_back(truth);
        result.odometry.truth.push_back(truth);
        result.localisations.push_back(here);
        result.longest = std::max(result.longest, here.seconds);
        const auto advised = mapper.calibration(drive.robot.name).advised();
        if (!corrected || !advised) continue;
        result.correction = result.correction.with(*advised);
        ++result.corrections;
        mapper.recalibrate(drive.robot.name);
        std::vector<LiveScan> better = corrected(result.correction);
        std::move(better.begin() + static_cast<std::ptrdiff_t>(next) + 1, better.end(),
                  scans.begin() + static_cast<std::ptrdiff_t>(next) + 1);
    }
    result.map = mapper.map();
    result.calibration = mapper.calibration(drive.robot.name);
    result.scans = std::move(scans);
    return result;
}

double surfaceError(const MappedDrive& drive, const TrueSurfaces& surfaces, bool byOdometry) {
    const Pose mapInArena = errorOf(byOdometry ? drive.odometry : drive.live).mapInArena;
    return surfaceErrorOf(*drive.map, surfaces, [&](const LiveKeyScan& key) -> Pose {
        return mapInArena * (byOdometry ? key.scan->sensorInOdom : key.pose.scanInMap);
    });
}

double surfaceError(const MappedDrive& drive, const TrueSurfaces& surfaces, const Trajectory& trajectory) {
    const Pose mapInArena = errorOf(trajectory).mapInArena;
    return surfaceErrorOf(*drive.map, surfaces, [&](const LiveKeyScan& key) -> Pose {
        std::size_t of = 0;
        while (drive.localisations.at(of).keyScan != key.id) ++of;
        return mapInArena * trajectory.found.at(of) * drive.scans[of].sensorInBase;
    });
}

}  // namespace leitstand::simulation::test
