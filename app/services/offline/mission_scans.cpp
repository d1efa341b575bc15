#include "app/services/offline/mission_scans.h"

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <map>
#include <memory>
#include <optional>
#include <stop_token>
#include <string_view>
#include <utility>

#include <fmt/format.h>

#include "app/services/log/decoded_log.h"
#include "app/services/log/event_decoder.h"
#include "app/services/log/mission_robots.h"
#include "app/services/places/sensor_poses.h"
#include "core/base/words.h"
#include "core/event/event.h"
#include "core/event/stream_role.h"
#include "core/io/bag/bag_conversion.h"
#include "core/io/bag/bag_reader.h"
#include "core/mapping/motion/mapping_scanner.h"
#include "core/mapping/motion/turn_assembler.h"
#include "core/mapping/plane/plane_scan.h"

namespace leitstand {
namespace {

namespace fs = std::filesystem;

/// Turns of a plane laser are added where it moved or turned so far since the last one: it makes many a
/// second.
constexpr std::chrono::seconds WithoutOdometry(1);  ///< ... or so long after it, where nobody knows
constexpr double LaserStep = 0.15;                  ///< [m]
constexpr double LaserTurn = degrees(5);            ///< [rad]

/// Topics of @p robots with one of @p roles.
std::vector<std::string> topicsOf(const std::vector<RobotDescription>& robots,
                                  std::initializer_list<StreamRole> roles) {
    std::vector<std::string> topics;
    for (const RobotDescription& robot : robots) {
        for (const StreamDescription& stream : robot.streams) {
            if (std::find(roles.begin(), roles.end(), stream.role) != roles.end())
                topics.push_back(stream.topic);
        }
    }
    return topics;
}

/// Returns the part of @p progress from @p begin to @p end.
Progress part(const Progress& progress, double begin, double end) {
    return {[&progress, begin, end](double fraction) { progress.done(begin + (end - begin) * fraction); },
            progress.stop};
}

/// Returns @p robots without the streams of which @p bag has no messages.
std::vector<RobotDescription> withoutSilent(std::vector<RobotDescription> robots, const BagReader& bag) {
    for (RobotDescription& robot : robots) {
        std::erase_if(robot.streams, [&](const StreamDescription& stream) {
            return std::none_of(bag.topics().begin(), bag.topics().end(), [&](const BagTopic& topic) {
                return topic.info.name == stream.topic && topic.messages != 0U;
            });
        });
    }
    return robots;
}

/// State of the clouds of one topic.
struct CloudLane {
    TurnAssembler assembler;
    std::string sensor, frame;
    ScanArrival newest;  ///< of its clouds
};

/// State of one robot.
struct RobotScans {
    SensorPoses poses;
    MappingScanner mapping;                  ///< which of its scanners makes the map
    std::map<std::string, CloudLane> lanes;  ///< by topic
    std::string planeLaser = {};             ///< planeScanner() of the topics that were recorded
    std::optional<Time> lastEnd = {};        ///< of the plane laser's newest turn that was looked at
    std::optional<Pose> lastTurn = {};       ///< in odom, where the plane laser's newest scan was taken
    int scans = 0, withoutPose = 0;
};

class Reading {
public:
    Reading(BagReader& bag, std::vector<RobotDescription> robots) : m_bag(bag), m_decoder(std::move(robots)) {
        const std::vector<RobotDescription> recorded = withoutSilent(m_decoder.robots(), bag);
        for (const RobotDescription& robot : m_decoder.robots()) {
            RobotScans& of = m_robots
                                 .emplace(robot.name, RobotScans{.poses = SensorPoses(robot),
                                                                 .mapping = MappingScanner(robot),
                                                                 .lanes = {}})
                                 .first->second;
            for (const RobotDescription& one : recorded)
                if (one.name == robot.name) of.planeLaser = planeScanner(one, recorded);
        }
    }
    void readPoses(const Progress& progress);
    /// Compares the scanners of robots that have several, by their first clouds.
    void chooseScanners(const Progress& progress, MissionScans& result);
    void readClouds(const Progress& progress, MissionScans& result);

private:
    void forEach(std::vector<std::string> topics, const Progress& progress,
                 const std::function<void(const Event&)>& take);
    void addCloud(const Event& event, CloudSample cloud);
    /// Adds a turn of a plane laser if its robot moved since the last one that was added.
    void addTurn(const Event& event, const RangesSample& turn);
    void keep(std::optional<Scan> scan, const std::string& robot, const CloudLane& lane);

    BagReader& m_bag;
    EventDecoder m_decoder;
    std::map<std::string, RobotScans> m_robots;
    struct Kept {
        ScanPtr scan;
        Pose sensorInBase;
        ScanArrival arrival;
    };
    std::vector<Kept> m_scans;
};

void Reading::forEach(std::vector<std::string> topics, const Progress& progress,
                      const std::function<void(const Event&)>& take) {
    BagQuery query;
    query.topics = std::move(topics);
    forEachEvent(m_bag, m_decoder, query, take, progress);
}

void Reading::readPoses(const Progress& progress) {
    forEach(topicsOf(m_decoder.robots(), {StreamRole::Odometry, StreamRole::StaticTransforms}), progress,
            [this](const Event& event) { m_robots.at(event.robot).poses.add(event); });
}

void Reading::keep(std::optional<Scan> scan, const std::string& robot, const CloudLane& lane) {
    if (!scan) return;
    RobotScans& of = m_robots.at(robot);
    // From odometry, which has both: right for sensors that turn, and for clouds in the odometry frame.
    const auto base = scan->hasOdometry ? of.poses.baseInOdom(scan->end) : std::nullopt;
    const Pose sensorInBase =
        base ? base->inverse() * scan->sensorInOdom : of.poses.inBase(lane.sensor, lane.frame);
    scan->robot = robot;
    scan->name = fmt::format("{} {:03}", robot, of.scans++);
    if (!scan->hasOdometry) ++of.withoutPose;
    m_scans.push_back({std::make_shared<const Scan>(std::move(*scan)), sensorInBase, lane.newest});
}

void Reading::chooseScanners(const Progress& progress, MissionScans& result) {
    const auto isOpen = [](const auto& one) {
        return one.second.mapping.hasChoice() && one.second.mapping.chosen().empty();
    };
    EventDecoder decoder(m_decoder.robots());  // of its own: its errors are not those of the scans
    std::stop_source decided;
    std::optional<Time> newest;
    const auto take = [&](const Event& event) {
        RobotScans& robot = m_robots.at(event.robot);
        const auto* turn = event.sample.as<RangesSample>();
        if (const auto* cloud = event.sample.as<CloudSample>())
            (void)robot.mapping.takes(event.topic, *cloud, event.received);
        else if (turn != nullptr && robot.mapping.compares(event.topic))
            (void)robot.mapping.takes(event.topic, cloudOf(*turn, Pose::Identity()), event.received);
        newest = event.received;
        if (progress.cancelled() || std::none_of(m_robots.begin(), m_robots.end(), isOpen))
            decided.request_stop();
    };
    if (std::any_of(m_robots.begin(), m_robots.end(), isOpen)) {
        BagQuery query;
        query.topics = topicsOf(m_decoder.robots(), {StreamRole::Points, StreamRole::Ranges});
        forEachEvent(m_bag, decoder, query, take, {.report = {}, .stop = decided.get_token()});
    }
    for (auto& [name, robot] : m_robots) {
        if (!robot.mapping.hasChoice()) continue;
        if (newest) robot.mapping.decide(*newest);
        for (const RobotDescription& one : m_decoder.robots()) {
            for (const StreamDescription& stream : one.streams) {
                if (one.name == name && stream.role == StreamRole::Ranges &&
                    stream.topic == robot.mapping.chosen())
                    robot.planeLaser = stream.topic;
            }
        }
        if (!robot.mapping.chosen().empty())
            result.warnings.push_back(
                leitstand::fill(translate("leitstand::Error",
                                          "{}: has several scanners; scans of {} are taken (`maps: true` in "
                                          "its file names another)"),
                                name, robot.mapping.chosen()));
    }
}

void Reading::addCloud(const Event& event, CloudSample cloud) {
    RobotScans& robot = m_robots.at(event.robot);
    CloudLane& lane = robot.lanes[event.topic];
    lane.sensor = event.sensor;
    lane.frame = cloud.header.frame;
    lane.newest = {event.sequence, event.received};
    // Clouds without a stamp count as taken when they came.
    if (cloud.header.stamp == Time{}) cloud.header.stamp = event.received;
    robot.poses.correctionOf(event.sensor, cloud.header.frame).correct(cloud);
    const SampleHeader header = cloud.header;
    const auto track = [&](Time at) { return robot.poses.sensorInOdom(event, header, at); };
    keep(lane.assembler.add(std::move(cloud), track), event.robot, lane);
}

void Reading::addTurn(const Event& event, const RangesSample& turn) {
    RobotScans& robot = m_robots.at(event.robot);
    const Pose laser = robot.poses.inBase(event.sensor, turn.header.frame);
    CloudSample cloud = cloudOf(turn, laser);
    if (cloud.header.stamp == Time{}) cloud.header.stamp = event.received;
    const SampleHeader header = cloud.header;
    const Pose upright = laser.inverse() * uprightLaser(laser);
    const auto track = [&](Time at) -> std::optional<Pose> {
        const auto inOdom = robot.poses.sensorInOdom(event, header, at);
        return inOdom ? std::optional(*inOdom * upright) : std::nullopt;
    };
    if (!isLevel(laser)) return;
    const Time end = endOf(cloud);
    const auto now = track(end);
    if (!now && robot.lastEnd && end - *robot.lastEnd < WithoutOdometry) return;
    robot.lastEnd = end;
    if (now && robot.lastTurn && distanceBetween(*now, *robot.lastTurn) < LaserStep &&
        angleBetween(*now, *robot.lastTurn) < LaserTurn)
        return;
    robot.lastTurn = now;
    CloudLane& lane = robot.lanes[event.topic];
    lane.sensor = event.sensor;
    lane.frame = header.frame;
    lane.newest = {event.sequence, event.received};
    keep(lane.assembler.add(std::move(cloud), track), event.robot, lane);
}

void Reading::readClouds(const Progress& progress, MissionScans& result) {
    forEach(topicsOf(m_decoder.robots(), {StreamRole::Points, StreamRole::Ranges}), progress,
            [&](const Event& event) {
                const RobotScans& robot = m_robots.at(event.robot);
                if (const auto* turn = event.sample.as<RangesSample>()) {
                    if (event.topic == robot.planeLaser) addTurn(event, *turn);
                } else if (const auto* cloud = event.sample.as<CloudSample>()) {
                    const bool other = robot.mapping.hasChoice() && event.topic != robot.mapping.chosen();
                    if (!other && robot.planeLaser.empty()) addCloud(event, *cloud);
                }
            });
    for (auto& [name, robot] : m_robots) {
        for (auto& [topic, lane] : robot.lanes) keep(lane.assembler.finish(), name, lane);
        if (robot.withoutPose > 0) {
            result.warnings.push_back(leitstand::fill(
                translate("leitstand::Error",
                          "{}: {} of {} scans have no odometry within half a second of their stamp"),
                name, robot.withoutPose, robot.scans));
        }
        for (const std::string& remark : robot.poses.remarks()) result.warnings.push_back(remark);
    }
    for (const auto& [topic, errors] : m_decoder.errors()) {
        result.warnings.push_back(leitstand::fill(
            translate("leitstand::ReportText", "{} samples of {} make no sense, the last one: {}"),
            errors.count, topic, errors.last));
    }
    result.warnings.insert(result.warnings.end(), m_bag.problems().begin(), m_bag.problems().end());
    std::stable_sort(m_scans.begin(), m_scans.end(),
                     [](const auto& a, const auto& b) { return a.scan->end < b.scan->end; });
    for (Kept& one : m_scans) {
        result.scans.push_back(std::move(one.scan));
        result.sensorsInBase.push_back(one.sensorInBase);
        result.arrivals.push_back(one.arrival);
    }
}

}  // namespace

bool isMission(const fs::path& path) {
    const auto isBag = [](const fs::path& file) {
        constexpr auto Endings =
            std::to_array<std::string_view>({".db3", ".mcap", ".bag", ".db3.zstd", ".mcap.zstd"});
        return std::any_of(Endings.begin(), Endings.end(), [&](std::string_view ending) {
            return file.filename().string().ends_with(ending);
        });
    };
    std::error_code problem;
    if (!fs::is_directory(path, problem)) return isBag(path) && fs::exists(path, problem);
    if (fs::exists(path / "metadata.yaml", problem)) return true;
    return std::any_of(fs::directory_iterator(path, problem), fs::directory_iterator(),
                       [&](const fs::directory_entry& entry) { return isBag(entry.path()); });
}

Result<MissionScans> readMissionScans(const fs::path& mission, const Progress& progress) {
    const auto bag = BagReader::open(mission);
    if (!bag) return bag.error();
    MissionScans result;
    Reading reading(**bag, robotsOf(mission, **bag, result.warnings));
    reading.readPoses(part(progress, 0.0, 0.3));
    reading.chooseScanners(progress, result);
    reading.readClouds(part(progress, 0.3, 1.0), result);
    if (result.scans.empty() && !progress.cancelled() && isCopyOfMission(**bag))
        return Error{leitstand::fill(
            translate("leitstand::Error",
                      "{}: is a copy of a mission in MCAP, for other programs: expected the mission itself"),
            mission.string())};
    if (result.scans.empty() && !progress.cancelled()) {
        return Error{leitstand::fill(
            translate("leitstand::Error",
                      "{}: no scans in it, expected a topic of sensor_msgs/msg/PointCloud2, or of "
                      "sensor_msgs/msg/LaserScan with odometry{}"),
            mission.string(), result.warnings.empty() ? "" : "; " + result.warnings.front())};
    }
    return result;
}

}  // namespace leitstand
