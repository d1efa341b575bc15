#include "app/services/handin/frozen_traces.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <map>
#include <optional>
#include <utility>

#include "app/services/handin/report_source.h"
#include "app/services/handin/scan_picture.h"
#include "core/event/cloud_sample.h"
#include "core/event/event.h"
#include "core/event/map_samples.h"
#include "core/event/motion_samples.h"
#include "core/event/sample_header.h"
#include "core/event/station_samples.h"
#include "core/event/status_samples.h"

namespace leitstand {
namespace {

constexpr std::chrono::seconds GasPause{60};  ///< after which another trace begins
constexpr std::chrono::seconds Beyond{2};     ///< a robot stands still this long before and after its path

/// Returns when the sample of @p event with @p header was taken, by the station's clock.
Time takenAt(const Event& event, const SampleHeader& header, const ReportSource& source) {
    if (header.stamp == Time{}) return event.received;
    const auto& robots = source.input().state.robots;
    const auto robot = robots.find(event.robot);
    if (robot == robots.end() || !robot->second->clockOffset) return header.stamp;
    return header.stamp - robot->second->clockOffset->sample.ahead;
}

/// Returns where @p robot was at @p time of the station's clock, along its path.
std::optional<Pose> baseInMap(const ReportModel& model, const std::string& robot, Time time) {
    for (const ReportRobot& one : model.robots) {
        const auto& way = one.path.poses;
        if (one.name != robot || way.empty()) continue;
        const auto after = std::lower_bound(way.begin(), way.end(), time,
                                            [](const PathPose& pose, Time at) { return pose.time < at; });
        if (after == way.begin())
            return after->time - time <= Beyond ? std::optional(after->baseInMap) : std::nullopt;
        const PathPose& before = *std::prev(after);
        if (after == way.end())
            return time - before.time <= Beyond ? std::optional(before.baseInMap) : std::nullopt;
        const double share = std::chrono::duration<double>(time - before.time) /
                             std::chrono::duration<double>(after->time - before.time);
        return interpolated(before.baseInMap, after->baseInMap, share);
    }
    return std::nullopt;
}

/// The echoes of @p ranges in the laser's frame.
std::vector<Eigen::Vector3f> pointsOf(const RangesSample& ranges) {
    std::vector<Eigen::Vector3f> points;
    for (std::size_t i = 0; i < ranges.ranges.size(); ++i) {
        const double range = ranges.ranges[i];
        if (!(range >= ranges.rangeMin && range <= ranges.rangeMax)) continue;
        const double angle = ranges.angleMin + ranges.angleStep * static_cast<double>(i);
        points.emplace_back(static_cast<float>(range * std::cos(angle)),
                            static_cast<float>(range * std::sin(angle)), 0.0F);
    }
    return points;
}

std::vector<Eigen::Vector3d> placed(const std::vector<Eigen::Vector3f>& points, const Pose& inMap) {
    std::vector<Eigen::Vector3d> moved;
    for (const Eigen::Vector3f& point : points) {
        if (point.allFinite()) moved.emplace_back(inMap * point.cast<double>());
    }
    return moved;
}

/// Returns the key scan of @p robot whose sweep contains @p stamp, by the robot's clock; null: none.
const ReportScan* keyScanAt(const ReportSource& source, const std::string& robot, Time stamp) {
    for (const ReportScan& scan : source.input().scans) {
        const Time start = scan.scan->start == Time{} ? scan.scan->end : scan.scan->start;
        if (scan.scan->robot == robot && stamp != Time{} && start <= stamp && stamp <= scan.scan->end)
            return &scan;
    }
    return nullptr;
}

/// Whether the robot's pose was frozen with @p find.
bool hasPose(const ReportFind& find) {
    const auto& all = find.sample.evidence;
    return std::any_of(all.begin(), all.end(), [](const auto& one) { return one.kind == "odometry"; });
}

void addKeyScan(FrozenScan& made, const ReportScan& scan, ScanPictureMarks marks) {
    marks.baseInMap = scan.baseInMap();
    const auto points = placed(scan.scan->points, scan.scanInMap);
    made.keyScan = scan.id;
    made.points = points.size();
    made.picture = scanPicture(points, marks);
}

void addScan(FindPages& pages, const Event& event, const SampleHeader& header,
             const std::vector<Eigen::Vector3f>& points, ScanPictureMarks marks, const ReportModel& model,
             ReportSource& source) {
    FrozenScan made{.robot = event.robot, .at = event.received, .keyScan = 0, .points = 0, .picture = {}};
    if (const ReportScan* scan = keyScanAt(source, event.robot, header.stamp)) {
        addKeyScan(made, *scan, marks);  // it is complete, and follows the corrections of the map
    } else {
        made.points = placed(points, Pose::Identity()).size();
        const auto base = baseInMap(model, event.robot, takenAt(event, header, source));
        const auto sensor = base ? source.sensorInBase(event) : std::nullopt;
        if (base && sensor) {
            marks.baseInMap = *base;
            made.picture = scanPicture(placed(points, *base * *sensor), marks);
        }
    }
    pages.scans.push_back(std::move(made));
}

}  // namespace

void addTrace(FindPages& pages, const Event& event, const ReportFind& find, const ReportModel& model,
              ReportSource& source) {
    ScanPictureMarks marks;
    if (find.position.allFinite()) marks.find = find.position;
    if (const auto* gas = event.sample.as<GasSample>()) {
        if (std::isfinite(gas->ppm)) pages.gas.push_back({event.robot, {{event.received, gas->ppm}}});
    } else if (const auto* cloud = event.sample.as<CloudSample>()) {
        addScan(pages, event, cloud->header, cloud->points, marks, model, source);
    } else if (const auto* ranges = event.sample.as<RangesSample>()) {
        addScan(pages, event, ranges->header, pointsOf(*ranges), marks, model, source);
    } else if (const auto* key = event.sample.as<KeyScanSample>()) {
        FrozenScan made{.robot = key->scan ? key->scan->robot : event.robot,
                        .at = event.received,
                        .keyScan = key->id,
                        .points = key->scan ? placed(key->scan->points, Pose::Identity()).size() : 0,
                        .picture = {}};
        for (const ReportScan& scan : source.input().scans) {
            if (scan.id != key->id) continue;
            addKeyScan(made, scan, marks);
            if (!hasPose(find)) pages.poses.push_back({made.robot, made.at, scan.baseInMap()});
        }
        pages.scans.push_back(std::move(made));
    } else if (const auto* odometry = event.sample.as<OdometrySample>()) {
        pages.poses.push_back({event.robot, event.received,
                               baseInMap(model, event.robot, takenAt(event, odometry->header, source)),
                               odometry->baseInOdom});
    }
}

void joinGas(FindPages& pages) {
    std::map<std::string, std::vector<GasTrace::Reading>> all;  // by robot
    for (const GasTrace& trace : pages.gas) {
        auto& readings = all[trace.robot];
        readings.insert(readings.end(), trace.readings.begin(), trace.readings.end());
    }
    pages.gas.clear();
    for (auto& [robot, readings] : all) {
        std::stable_sort(readings.begin(), readings.end(),
                         [](const auto& a, const auto& b) { return a.at < b.at; });
        for (std::size_t i = 0; i < readings.size(); ++i) {
            if (i == 0 || readings[i].at - readings[i - 1].at > GasPause) pages.gas.push_back({robot, {}});
            pages.gas.back().readings.push_back(readings[i]);
        }
    }
}

}  // namespace leitstand
