#include <chrono>
#include <condition_variable>
#include <map>
#include <memory>
#include <mutex>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "app/services/handin/writing/report_folder.h"
#include "app/services/log/live_mission.h"
#include "core/event/event.h"
#include "core/event/find_sample.h"
#include "core/event/map_samples.h"
#include "core/event/motion_samples.h"
#include "core/event/picture_samples.h"
#include "core/event/sample.h"
#include "core/event/scan_pose.h"
#include "core/event/station_samples.h"
#include "core/event/station_topics.h"
#include "core/event/status_samples.h"
#include "core/event/stream_role.h"
#include "core/io/robot/robot_file.h"
#include "core/io/settings/comparison_file.h"
#include "core/mapping/comparison/map_comparison.h"
#include "core/perception/pictures/coding/picture_png.h"
#include "core/robot/streams/stream_defaults.h"
#include "core/robot/streams/stream_table.h"
#include "tests/compat/make/fixtures.h"
#include "tests/support/places.h"
#include "tests/support/rooms.h"
#include "tests/support/samples.h"
#include "transport/convert/encode.h"

namespace leitstand::test {
namespace {

constexpr auto Station = "5f6f9a52-7b1c-4f4e-9d0e-2b6f3c1d8a70";

/// On the robots' clock.
Time at(double seconds) {
    return Time(std::chrono::nanoseconds(1'790'000'000'000'000'000LL)) +
           std::chrono::nanoseconds(static_cast<std::int64_t>(seconds * 1e9));
}

Time now() {
    return std::chrono::system_clock::now();
}

RobotDescription kurt() {
    return readRobot(std::filesystem::path(sourceFolder()) / "resources/robots/kurt3d.yaml").value();
}

/// A robot that has each stream there is, as its @p nth type.
RobotDescription every(const std::string& name, const std::string& letter, std::size_t nth) {
    RobotDescription robot = kurt();
    robot.name = name;
    robot.title = "Every stream " + letter;
    robot.letter = letter;
    robot.streams.clear();
    for (const StreamRole role : allStreamRoles()) {
        const auto types = typesOf(role);
        if (nth >= types.size()) continue;
        const char* camera = role == StreamRole::Thermal ? "ir" : "left";
        StreamDescription stream = defaultStream(role, name, streamFacts(role).ofCamera ? camera : "");
        stream.type = types[nth];
        robot.streams.push_back(stream);
    }
    return robot;
}

/// A session of the mission: says one thing after the other.
class Session {
public:
    Session(const std::filesystem::path& folder, std::vector<RobotDescription> robots)
        : m_robots(std::move(robots)) {
        LiveMissionSettings settings;
        settings.folder = folder;
        settings.robots = m_robots;
        settings.station = Station;
        settings.title = "Left desk";
        settings.version = "0.2.0";
        LiveMissionListener listener;
        listener.onEvent = [this](const Event& event) {
            const std::lock_guard lock(m_mutex);
            m_newest[event.topic] = event.sequence;
            m_arrived.notify_all();
        };
        m_mission = LiveMission::open(settings, std::move(listener)).value();
        for (const RobotDescription& robot : m_robots)
            for (const StreamDescription& one : robot.streams)
                m_mission->addTopic(one.topic, one.type, one.qos);
    }
    ~Session() { (void)m_mission->close(); }
    Session(const Session&) = delete;
    Session& operator=(const Session&) = delete;

    /// @p sample comes on @p stream; its sequence.
    std::uint64_t receive(const Sample& sample, const StreamDescription& stream) {
        const std::uint64_t before = newestOf(stream.topic);
        m_mission->receive({0, {}, stream.topic, stream.type, encode(sample, stream.type).value()});
        return arrived(stream.topic, before);
    }
    std::uint64_t receive(const Sample& sample, StreamRole role, const std::string& sensor = {}) {
        return receive(sample, *m_robots.front().stream(role, sensor));
    }
    std::uint64_t publish(const Sample& sample, std::string_view topic) {
        const std::uint64_t before = newestOf(std::string(topic));
        if (const auto reported = m_mission->record(sample, topic); !reported)
            throw std::runtime_error(reported.error().text);
        return arrived(std::string(topic), before);
    }

private:
    std::uint64_t newestOf(const std::string& topic) {
        const std::lock_guard lock(m_mutex);
        return m_newest[topic];
    }
    std::uint64_t arrived(const std::string& topic, std::uint64_t before) {
        std::unique_lock lock(m_mutex);
        if (!m_arrived.wait_for(lock, std::chrono::seconds(10), [&] { return m_newest[topic] > before; }))
            throw std::runtime_error(topic + ": nothing arrived");
        return m_newest[topic];
    }

    const std::vector<RobotDescription> m_robots;
    std::mutex m_mutex;
    std::condition_variable m_arrived;
    std::map<std::string, std::uint64_t> m_newest;  ///< sequence by topic
    std::unique_ptr<LiveMission> m_mission;         // last: its threads use the others
};

KeyScanSample keyScan(int number) {
    RoomSettings room;
    room.sensorInRoom = poseFrom({-1.0 + 0.5 * number, 0, 0.5}, 0, 0, 0);
    room.sweep = Sweep::Yawing;
    room.rows = 30;
    room.columns = 19;
    room.seed = static_cast<unsigned>(number);
    RoomScan seen = scanRoom(room);
    seen.scan.labels = seen.trueLabels;
    seen.scan.robot = "kurt3d";
    seen.scan.end = at(5.0 * number);
    KeyScanSample sample;
    sample.stamp = now();
    sample.id = static_cast<std::uint64_t>(number);
    sample.scan = std::make_shared<const Scan>(seen.scan);
    sample.sensorInBase = poseFrom({0, 0, 0.5}, 0, 0, 0);
    sample.scanInMap = room.sensorInRoom;
    sample.matched = static_cast<std::uint64_t>(number - 1);
    return sample;
}

FindSample find(FindSample::Kind kind, std::uint32_t number, const Eigen::Vector3d& place) {
    FindSample made;
    made.stamp = made.found = now();
    made.station = Station;
    made.kind = kind;
    made.number = number;
    made.robot = "kurt3d";
    made.positionInMap = place;
    made.deviation = 0.05;
    return made;
}

OdometrySample odometry(double seconds) {
    OdometrySample sample;
    sample.header = {at(seconds), "kurt3d/odom"};
    sample.childFrame = "kurt3d/base_link";
    sample.baseInOdom = poseFrom({3.0, 4.0 + 0.1 * seconds, 0.0}, 0, 0, degrees(90));
    sample.linear.x() = 0.1;
    return sample;
}

PictureSample picture(double seconds) {
    Picture grey{.width = 16, .height = 12, .pixel = Picture::Pixel::Rgb8, .bytes = {}};
    for (int i = 0; i < 16 * 12 * 3; ++i) grey.bytes.push_back(static_cast<std::byte>(i % 251));
    PictureSample sample;
    sample.header = {at(seconds), "kurt3d/left"};
    sample.compressed = true;
    sample.encoding = "png";
    sample.content = sharedBytes(encodePng(grey).value());
    return sample;
}

void writeFirst(Session& session) {
    MissionInfoSample info;
    info.stamp = now();
    info.station = Station;
    info.competition = "RoboCup2026";
    info.team = "Deutschland1";
    info.country = "Germany";
    info.mission = "Preliminary 1";
    info.area = "yellow";
    info.profile = "2013";
    session.publish(info, station_topic::Mission);
    session.receive(ModeSample{{at(0), ""}, "teleoperation", false, "", {"teleoperation", "explore"}},
                    StreamRole::Mode);
    for (int i = 0; i < 12; ++i) session.receive(odometry(1.5 * i), StreamRole::Odometry);
    for (const int number : {1, 2, 3}) session.publish(keyScan(number), station_topic::KeyScans);
    FindSample first = find(FindSample::Kind::Victim, 1, {1.5, 1.0, 0.4});
    first.status = FindSample::Status::Confirmed;
    first.scan = 3;
    first.positionInScan = {1.0, 1.0, -0.1};
    first.form = {VictimSign::State::Present, "whole body"};
    first.heat = {VictimSign::State::Present, "", 36.4};
    first.sound = {VictimSign::State::Absent, ""};
    first.situation = "trapped";
    first.tag = "N17";
    first.text = "under a table <left> & cold, \"quoted\"";
    const auto shot = session.receive(picture(10.0), StreamRole::Picture, "left");
    first.evidence = {{"picture", "/kurt3d/left/image/compressed", shot, at(10.0)}};
    session.publish(first, station_topic::Victims);
    session.publish(find(FindSample::Kind::Victim, 2, {-2.0, -1.5, 0.3}), station_topic::Victims);
    session.publish(find(FindSample::Kind::Hazard, 1, {2.5, -1.0, 0.5}), station_topic::Victims);
    FindSample code = find(FindSample::Kind::Code, 1, {0.5, -2.5, 0.5});
    code.tag = "exit, \"left\"";
    code.status = FindSample::Status::Confirmed;
    session.publish(code, station_topic::Victims);
    session.publish(NoteSample{now(), Station, "kurt3d", "door on the left"}, station_topic::Notes);
    session.publish(AlarmSample{now(), Station, "kurt3d", "link_lost", AlarmSample::Severity::Critical,
                                AlarmSample::State::Raised, "link lost, silent for 4 s"},
                    station_topic::Alarms);
}

/// Decisions of a second session on what the first one has, and what takes them back.
void decide(Session& session) {
    FindSample second = find(FindSample::Kind::Victim, 2, {-2.0, -1.5, 0.3});
    second.status = FindSample::Status::Confirmed;
    second.text = "moves";
    session.publish(second, station_topic::Victims);
    second.status = FindSample::Status::Discarded;
    const auto discarded = session.publish(second, station_topic::Victims);
    session.publish(UndoSample{now(), Station, discarded, "victim 2"}, station_topic::Undo);
    const auto note = session.publish(NoteSample{now(), Station, "", "wrong room"}, station_topic::Notes);
    const auto undo = session.publish(UndoSample{now(), Station, note, "note"}, station_topic::Undo);
    session.publish(UndoSample{now(), Station, undo, "undo of the note"}, station_topic::Undo);
    ScanPose pose;
    pose.scan = 3;
    pose.scanInMap = poseFrom({0.55, 0.02, 0.5}, 0, 0, degrees(1));
    pose.overlap = 0.9;
    pose.converged = true;
    session.publish(ScanPosesSample{now(), Station, ScanPosesSample::Cause::Operator, {pose}},
                    station_topic::ScanPoses);
    session.publish(AlarmSample{now(), Station, "kurt3d", "link_lost", AlarmSample::Severity::Critical,
                                AlarmSample::State::Cleared, "link lost, silent for 4 s"},
                    station_topic::Alarms);
}

std::string_view topicOf(const std::string& type) {
    static const std::map<std::string, std::string_view> topics = {
        {"Grant", station_topic::Grants},
        {"Victim", station_topic::Victims},
        {"Candidate", station_topic::Candidates},
        {"KeyScan", station_topic::KeyScans},
        {"ScanPoses", station_topic::ScanPoses},
        {"MapCrop", station_topic::MapCrop},
        {"RobotPlace", station_topic::RobotPlaces},
        {"MissionClock", station_topic::Clock},
        {"ClockOffset", station_topic::ClockOffsets},
        {"Undo", station_topic::Undo},
        {"Note", station_topic::Notes},
        {"MissionInfo", station_topic::Mission},
        {"Session", station_topic::Sessions},
        {"Alarm", station_topic::Alarms}};
    const auto found = topics.find(type.substr(type.rfind('/') + 1));
    return found == topics.end() ? std::string_view() : found->second;
}

/// One event of every kind that a station writes, all fields filled.
void sayEverything(Session& session) {
    for (const SampleCase& one : sampleCases()) {
        const std::string_view topic = one.role ? std::string_view() : topicOf(one.type);
        if (!topic.empty()) session.publish(one.sample, topic);
    }
}

/// One sample on each stream of @p robot.
void receiveEverything(Session& session, const RobotDescription& robot) {
    const auto cases = sampleCases();
    for (const StreamDescription& stream : robot.streams) {
        for (const SampleCase& one : cases) {
            if (!one.role || one.type != stream.type) continue;
            session.receive(one.sample, stream);
            break;
        }
    }
}

/// As "register again" of a review leaves it.
void compare(const std::filesystem::path& folder) {
    std::vector<ComparedScan> scans;
    for (const int number : {1, 2, 3}) {
        const KeyScanSample sample = keyScan(number);
        ComparedScan scan;
        scan.id = sample.id;
        scan.robot = "kurt3d";
        scan.end = sample.scan->end;
        scan.scan = sample.scan;
        scan.sensorInBase = sample.sensorInBase;
        scan.recorded = sample.scanInMap;
        scans.push_back(scan);
    }
    RegistrationSettings settings;
    settings.minimizer = Minimizer::Quaternion;
    settings.maxDistances = {1.0, 0.3};
    const auto made = registeredAgain(std::move(scans), settings);
    if (const auto saved = saveComparison(made.value(), folder / "comparison.yaml"); !saved)
        throw std::runtime_error(saved.error().text);
}

}  // namespace

void makeMission(const std::filesystem::path& folder) {
    {
        Session session(folder, {kurt()});
        writeFirst(session);
    }
    const RobotDescription first = every("alpha", "A", 0), second = every("beta", "B", 1);
    Session session(folder, {kurt(), first, second});
    decide(session);
    receiveEverything(session, first);
    receiveEverything(session, second);
    sayEverything(session);
    if (const auto kept = keepReportFolder(folder, "/media/usb/hand-in"); !kept)
        throw std::runtime_error(kept.error().text);
    compare(folder);
}

}  // namespace leitstand::test
