#include "tests/core/mission/event_stream.h"

#include <cmath>

#include "core/event/candidate_sample.h"
#include "core/event/find_sample.h"
#include "core/event/map_samples.h"
#include "core/event/motion_samples.h"
#include "core/event/scan_bodies.h"
#include "core/event/scan_links.h"
#include "core/event/station_samples.h"
#include "core/event/status_samples.h"

namespace leitstand::test {

Time at(std::int64_t milliseconds) {
    return Time(std::chrono::milliseconds(1'767'225'600'000 + milliseconds));
}

Event event(std::uint64_t sequence, Sample sample, const std::string& robot) {
    Event made;
    made.sequence = sequence;
    made.received = at(static_cast<std::int64_t>(sequence) * 10);
    made.robot = robot;
    made.topic = (robot.empty() ? "/leitstand/" : "/" + robot + "/") + std::to_string(sample.index());
    made.sample = std::move(sample);
    return made;
}

FindSample victim(std::uint32_t number, const std::string& text) {
    FindSample made;
    made.number = number;
    made.text = text;
    made.heat.value = 36.5;
    made.evidence = {{"picture", "/kurt3d/left", 7, at(70)}};
    return made;
}

namespace {

Pose shifted(double x) {
    Pose pose = Pose::Identity();
    pose.translation().x() = x;
    pose.linear() = Eigen::AngleAxisd(x, Eigen::Vector3d::UnitZ()).toRotationMatrix();
    return pose;
}

}  // namespace

ScanPosesSample moved(std::uint64_t scan, double x) {
    ScanPosesSample made;
    made.poses = {{.scan = scan, .scanInMap = shifted(x), .rms = 0.06}};
    return made;
}

ScanLinksSample linked(std::uint64_t id, LinkKind kind, bool active) {
    Link link;
    link.id = id;
    link.from = 1;
    link.to = 2;
    link.pose = shifted(0.5);
    link.kind = kind;
    link.station = "us";
    link.active = active;
    return {.stamp = at(1), .station = "us", .links = {link}};
}

KeyScanSample keyScan(std::uint64_t id, double x) {
    auto scan = std::make_shared<Scan>();
    scan->robot = "kurt3d";
    scan->points.resize(100);
    KeyScanSample made;
    made.id = id;
    made.scan = scan;
    made.scanInMap = shifted(x);
    return made;
}

UndoSample undo(std::uint64_t sequence) {
    UndoSample made;
    made.event = sequence;
    return made;
}

std::vector<Event> randomMission(unsigned seed, std::size_t events) {
    std::mt19937 random(seed);
    const auto below = [&](std::uint32_t bound) { return static_cast<std::uint32_t>(random() % bound); };
    const char* robots[] = {"kurt3d", "crawler"};
    std::vector<Event> mission;
    std::uint64_t sequence = 0;
    while (mission.size() < events) {
        sequence += 1 + below(3) / 2;  // pictures that were dropped leave gaps
        const std::string robot = robots[below(2)];
        const double x = below(1'000) * 0.01;
        const auto text = std::to_string(below(100));
        Sample sample;
        switch (below(25)) {
            case 0:
                sample = victim(1 + below(5), text);
                break;
            case 1:
                sample = keyScan(1 + below(10), x);
                break;
            case 2:
                sample = moved(1 + below(12), x);
                break;
            case 3:
                sample = NoteSample{.stamp = at(1), .station = "s", .robot = robot, .text = text};
                break;
            case 4:
            case 5:
            case 6:
                sample = undo(below(static_cast<std::uint32_t>(sequence) + 3));
                break;
            case 7:
                sample = GrantSample{.stamp = {},
                                     .station = "s" + text,
                                     .title = "t",
                                     .kind = static_cast<GrantSample::Kind>(below(3)),
                                     .action = static_cast<GrantSample::Action>(below(5)),
                                     .robot = robot,
                                     .other = "s1",
                                     .term = below(4)};
                break;
            case 8:
                sample = AlarmSample{.stamp = {},
                                     .station = "s",
                                     .robot = robot,
                                     .key = "k" + text,
                                     .severity = AlarmSample::Severity::Critical,
                                     .state = static_cast<AlarmSample::State>(below(3)),
                                     .text = text};
                break;
            case 9:
                sample = SessionSample{.stamp = {},
                                       .station = "s",
                                       .title = "t",
                                       .start = below(2) == 0,
                                       .mission = "m",
                                       .version = "1",
                                       .operators = 2};
                break;
            case 10:
                sample =
                    ClockSample{.stamp = {}, .station = "s", .running = true, .elapsed = {}, .limit = {}};
                break;
            case 11: {
                ImuSample imu;
                imu.orientation = Eigen::Quaterniond(shifted(x).linear());
                sample = imu;
                break;
            }
            case 12: {
                BatterySample battery;
                battery.voltage = x;
                battery.current = -1.0 - std::abs(x);
                sample = battery;
                break;
            } break;
            case 13:
                sample = DiagnosticsSample{
                    .header = {},
                    .statuses = {{DiagnosticStatus::Level::Warning, text, "m", "h", {{"a", "b"}}}}};
                break;
            case 14:
                sample = StopStateSample{.header = {},
                                         .number = below(9),
                                         .station = "s",
                                         .stopped = true,
                                         .standing = false,
                                         .refused = ""};
                break;
            case 15:
                sample = ModeSample{.header = {},
                                    .mode = "explore",
                                    .autonomous = true,
                                    .reason = "",
                                    .available = {"explore", text}};
                break;
            case 16:
                sample = ClockOffsetSample{
                    .stamp = {}, .robot = robot, .ahead = {}, .uncertainty = {}, .roundTrip = {}};
                break;
            case 17:
                sample = BumpSample{.header = {}, .bumpers = {{"front", true, 3}}};
                break;
            case 19: {
                CandidateSample candidate;
                candidate.id = 1 + below(4);
                candidate.positionInMap.x() = x;
                candidate.cues = {
                    {.kind = "heat", .robot = robot, .sensor = "ir", .topic = "/ir", .value = x}};
                sample = candidate;
                break;
            }
            case 21:
                sample = MapCropSample{.stamp = at(1),
                                       .station = "s",
                                       .polygon = {{x, 0.0}, {4.0, x}, {0.0, 3.0}},
                                       .ceiling = 0.1 * x};
                break;
            case 22:
                sample = linked(1 + below(20), static_cast<LinkKind>(below(LinkKindCount)), below(3) != 0);
                break;
            case 23:
                sample = ScanBodiesSample{
                    .stamp = at(1),
                    .station = "s",
                    .scans = {{1 + below(5),
                               {{robot, {{x, 0.0}, {0.0, 1.0}, {-1.0, 0.0}}, 0.4, shifted(x), 0.1}}}}};
                break;
            case 20:
                sample = MissionInfoSample{.stamp = at(1), .team = text};
                break;
            case 18:
                sample = RobotPlaceSample{.stamp = at(1),
                                          .station = "s",
                                          .robot = robot,
                                          .cause = static_cast<RobotPlaceSample::Cause>(below(5)),
                                          .measured = {},
                                          .baseInMap = shifted(x),
                                          .odomInMap = shifted(2.0 * x),
                                          .certainty = 0.1 * x,
                                          .overlap = 0.5,
                                          .certain = below(2) == 0,
                                          .how = text};
                break;
            default: {
                OdometrySample odometry;
                odometry.baseInOdom = shifted(x);
                odometry.poseCovariance[0] = 1.0;
                sample = odometry;
            }
        }
        const bool own = sample.is<FindSample>() || sample.is<UndoSample>();
        mission.push_back(event(sequence, std::move(sample), own ? "" : robot));
    }
    return mission;
}

std::optional<MissionHistory::StoredCheckpoint> MemoryHistory::checkpointUpTo(std::uint64_t sequence) {
    for (auto event = m_events.rbegin(); event != m_events.rend(); ++event) {
        if (event->sequence > sequence) continue;
        if (const auto* checkpoint = event->sample.as<CheckpointSample>()) {
            return StoredCheckpoint{event->sequence, *checkpoint};
        }
    }
    return std::nullopt;
}

void MemoryHistory::events(std::uint64_t after, std::uint64_t upTo,
                           const std::function<void(const Event&)>& take) {
    for (const Event& event : m_events) {
        if (event.sequence <= after || event.sequence > upTo) continue;
        ++m_given;
        take(event);
    }
}

}  // namespace leitstand::test
