#include "tests/app/report/driven_mission.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <memory>
#include <random>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "app/services/log/event_decoder.h"
#include "app/services/log/mission_robots.h"
#include "core/event/find_sample.h"
#include "core/event/map_samples.h"
#include "core/event/motion_samples.h"
#include "core/event/picture_samples.h"
#include "core/event/station_samples.h"
#include "core/event/station_topics.h"
#include "core/event/status_samples.h"
#include "core/event/stream_role.h"
#include "core/io/bag/bag_writer.h"
#include "core/io/robot/robot_file.h"
#include "core/mission/state/checkpoint/checkpoint.h"
#include "core/mission/state/fold.h"
#include "core/mission/state/scan_state.h"
#include "core/perception/pictures/coding/picture_png.h"
#include "tests/support/places.h"
#include "tests/support/rooms.h"
#include "tests/support/samples.h"
#include "transport/convert/encode.h"

namespace leitstand::test {
namespace {

constexpr double Length = 1200.0;                    ///< [s]
constexpr int Ticks = 20;                            ///< of odometry a second
constexpr double Speed = 0.095;                      ///< [m/s]
constexpr double RoomLength = 8.0, RoomWidth = 6.0;  ///< [m]
constexpr double Row = 2 * RoomLength;               ///< from the first room's middle to the third's [m]
constexpr double Way = 2 * Row + RoomWidth;          ///< through all six [m]
constexpr double Behind = 15.0;                      ///< so much later the Crawler is there [s]
constexpr int KeyScanEvery = 3, CheckpointEvery = 20, VictimEvery = 190;  ///< [s]
constexpr double ScannerHeight = 0.5;                                     ///< [m]

Time at(double seconds) {
    return Time(std::chrono::seconds(1'750'000'000)) + std::chrono::nanoseconds(std::llround(seconds * 1e9));
}

/// Where a robot's base is after @p seconds: along one row of rooms, back along the other, and so on.
Pose baseAt(double seconds) {
    const double driven = std::fmod(Speed * std::max(seconds, 0.0), 2.0 * Way);
    const bool back = driven > Way;
    const double s = back ? 2.0 * Way - driven : driven;
    Eigen::Vector3d place(s, 0.0, 0.0);
    double heading = 0.0;
    if (s > Row) place = {Row, s - Row, 0.0}, heading = degrees(90);
    if (s > Row + RoomWidth) place = {Row - (s - Row - RoomWidth), RoomWidth, 0.0}, heading = degrees(180);
    return poseFrom(place, 0, 0, heading + (back ? degrees(180) : 0.0) + 0.2 * std::sin(0.5 * seconds));
}

/// Where the middle of the room is that has @p place; on the floor.
Eigen::Vector3d roomOf(const Eigen::Vector3d& place) {
    return {RoomLength * std::round(place.x() / RoomLength), RoomWidth * std::round(place.y() / RoomWidth),
            0.0};
}

/// What the scanner saw around itself in a turn that ended at @p seconds, reduced as key scans are.
ScanPtr scanAt(double seconds, const Pose& sensorInMap, unsigned seed) {
    RoomSettings settings;
    settings.sensorInRoom = sensorInMap;
    settings.sensorInRoom.translation() -= roomOf(sensorInMap.translation());
    settings.sweep = Sweep::Yawing;
    settings.rows = 90;
    settings.columns = 116;
    settings.seed = seed;
    const RoomScan seen = scanRoom(settings);
    auto scan = std::make_shared<Scan>();
    scan->robot = "kurt3d";
    scan->start = at(seconds - 2.3);
    scan->end = at(seconds);
    scan->sensorInOdom = sensorInMap;
    scan->hasOdometry = true;
    for (std::size_t i = 0; i < seen.scan.points.size(); ++i) {
        if (!seen.scan.points[i].allFinite()) continue;
        scan->points.push_back(seen.scan.points[i]);
        scan->labels.push_back(seen.trueLabels[i]);
    }
    return scan;
}

/// A picture of some noise, whose file is as large as a camera's.
SharedBytes cameraPicture(unsigned seed) {
    Picture picture{.width = 320, .height = 240, .pixel = Picture::Pixel::Rgb8, .bytes = {}};
    std::mt19937 random(seed);
    for (int i = 0; i < 320 * 240; ++i) {
        const auto noise = static_cast<int>(random() % 4);
        for (const int value : {i % 320 / 2, i / 320, 90})
            picture.bytes.push_back(static_cast<std::byte>(value + noise));
    }
    return sharedBytes(encodePng(picture).value());
}

/// 20 degrees with a warm spot of 36 degrees, in centikelvin.
SharedBytes warmth() {
    Picture picture{.width = 160, .height = 120, .pixel = Picture::Pixel::Grey16, .bytes = {}};
    for (int i = 0; i < 160 * 120; ++i) {
        const unsigned value = std::hypot(i % 160 - 80, i / 160 - 60) < 16 ? 30915 : 29315;
        picture.bytes.push_back(static_cast<std::byte>(value & 0xff));
        picture.bytes.push_back(static_cast<std::byte>(value >> 8));
    }
    return sharedBytes(encodePng(picture).value());
}

/// Writes a log at times of its own, with checkpoints.
class Log {
public:
    Log(const std::filesystem::path& folder, const std::vector<RobotDescription>& robots)
        : m_decoder(robots) {
        EXPECT_TRUE(keepRobots(folder, robots));
        m_bag = BagWriter::open(folder).value();
    }
    /// The event's number.
    std::uint64_t write(double seconds, const std::string& topic, const Sample& sample) {
        const std::string type(typeOf(sample));
        if (m_announced.insert(topic).second)
            m_bag->addTopic({topic, type, qosProfilesOf({}), "", "", false, false, "cdr"});
        auto payload = encode(sample, type);
        EXPECT_TRUE(payload) << topic << ": " << payload.error().text;
        const RawEvent raw{++m_sequence, at(seconds), topic, type, std::move(payload).value()};
        m_decoder.decode(raw, [this](const Event& event) { m_fold.add(event); });
        m_bag->write(raw);
        return m_sequence;
    }
    void checkpoint(double seconds) {
        write(seconds, std::string(station_topic::Checkpoints), checkpointOf(m_fold.state(), at(seconds)));
    }
    void close() {
        const auto closed = m_bag->close();
        EXPECT_TRUE(closed) << closed.error().text;
        EXPECT_TRUE(m_bag->statistics().dropped.empty());
    }

private:
    EventDecoder m_decoder;
    Fold m_fold;
    std::set<std::string> m_announced;
    std::unique_ptr<BagWriter> m_bag;
    std::uint64_t m_sequence = 0;
};

/// Twenty minutes of both robots.
class Drive {
public:
    explicit Drive(const std::filesystem::path& folder)
        : m_kurt(file("kurt3d")), m_crawler(file("crawler")), m_log(folder, {m_kurt, m_crawler}) {}

    DrivenMission write() {
        begin();
        for (int tick = 0; tick < static_cast<int>(Length) * Ticks; ++tick) {
            const double t = static_cast<double>(tick) / Ticks;
            const auto every = [&](double seconds) {
                return tick % static_cast<int>(std::lround(seconds * Ticks)) == 0;
            };
            odometry(t, m_kurt, baseAt(t));
            odometry(t, m_crawler, baseAt(t - Behind));
            if (every(0.2)) m_picture = look(t, StreamRole::Picture, "left", m_pictures[tick / 4 % 8]);
            if (every(0.5)) m_heat = look(t, StreamRole::Thermal, "ir", m_warmth);
            if (every(1.0)) second(t);
            if (tick > 0 && every(KeyScanEvery)) keyScan(t);
            if (tick > 0 && every(VictimEvery)) victim(t);
            if (tick > 0 && every(CheckpointEvery)) m_log.checkpoint(t);
        }
        publish(Length, station_topic::Sessions, session(Length, false));
        m_log.checkpoint(Length);
        m_log.close();
        return m_made;
    }

private:
    static RobotDescription file(const std::string& name) {
        return readRobot(sourceFolder() + "/resources/robots/" + name + ".yaml").value();
    }
    std::uint64_t publish(double t, std::string_view topic, const Sample& sample) {
        ++m_made.events;
        return m_log.write(t, std::string(topic), sample);
    }
    static SessionSample session(double t, bool start) {
        return {.stamp = at(t),
                .station = "test",
                .title = "Test desk",
                .start = start,
                .mission = "Final 2",
                .version = "test"};
    }
    void begin() {
        for (unsigned i = 0; i < 8; ++i) m_pictures.push_back(cameraPicture(i + 1));
        m_warmth = warmth();
        publish(0.0, station_topic::Sessions, session(0.0, true));
        MissionInfoSample info;
        info.stamp = at(0.0);
        info.competition = "RoboCup2013";
        info.team = "Deutschland1";
        info.mission = "Final 2";
        info.area = "yellow";
        publish(0.0, station_topic::Mission, info);
        publish(0.0, m_kurt.stream(StreamRole::Mode)->topic,
                ModeSample{{at(0.0), ""}, "teleoperation", false, "", {"teleoperation", "explore"}});
    }
    void odometry(double t, const RobotDescription& robot, const Pose& base) {
        OdometrySample odometry;
        odometry.header = {at(t), robot.odomFrame};
        odometry.childFrame = robot.baseFrame;
        odometry.baseInOdom = base;
        odometry.linear.x() = Speed;
        publish(t, robot.stream(StreamRole::Odometry)->topic, odometry);
    }
    /// A picture that Kurt3D's camera @p sensor took; the event's number.
    std::uint64_t look(double t, StreamRole role, const std::string& sensor, const SharedBytes& content) {
        PictureSample picture;
        picture.header = {at(t), m_kurt.sensors.at(sensor).frame};
        picture.compressed = true;
        picture.encoding = "png";
        picture.content = content;
        return publish(t, m_kurt.stream(role, sensor)->topic, picture);
    }
    /// What is said once a second.
    void second(double t) {
        CameraInfoSample info;
        info.header = {at(t), m_kurt.sensors.at("left").frame};
        info.width = 320;
        info.height = 240;
        info.distortionModel = "plumb_bob";
        info.intrinsics = {280, 0, 160, 0, 280, 120, 0, 0, 1};
        publish(t, m_kurt.stream(StreamRole::CameraInfo, "left")->topic, info);
        m_gas = publish(t, m_kurt.stream(StreamRole::Gas)->topic, GasSample{{at(t), ""}, "co2", 1210.0});
        RobotPlaceSample place;
        place.stamp = place.measured = at(t);
        place.station = "test";
        place.robot = m_crawler.name;
        place.baseInMap = baseAt(t - Behind);
        place.certainty = 1.0;
        place.overlap = 0.9;
        place.certain = true;
        publish(t, station_topic::RobotPlaces, place);
    }
    void keyScan(double t) {
        KeyScanSample scan;
        scan.stamp = at(t);
        scan.id = ++m_made.keyScans;
        scan.matched = scan.id - 1;
        scan.sensorInBase = poseFrom({0, 0, ScannerHeight}, 0, 0, 0);
        scan.scanInMap = baseAt(t) * scan.sensorInBase;
        scan.scan = scanAt(t, scan.scanInMap, static_cast<unsigned>(scan.id));
        m_made.points += scan.scan->points.size();
        publish(t, station_topic::KeyScans, scan);
    }
    /// One of the room where Kurt3D is, seen a moment ago.
    void victim(double t) {
        FindSample victim;
        victim.stamp = victim.found = at(t);
        victim.station = "test";
        victim.number = static_cast<std::uint32_t>(++m_made.victims);
        victim.status = FindSample::Status::Confirmed;
        victim.robot = m_kurt.name;
        victim.positionInMap = roomOf(baseAt(t).translation()) + Eigen::Vector3d(-1.0, 1.5, 0.4);
        victim.deviation = 0.05;
        victim.form = {VictimSign::State::Present, "whole body"};
        victim.heat = {VictimSign::State::Present, "", 36.0};
        victim.co2 = {VictimSign::State::Present, "", 1210.0};
        victim.situation = "void";
        victim.tag = "N" + std::to_string(victim.number);
        const auto shows = [&](const char* kind, StreamRole role, const char* sensor, std::uint64_t event) {
            victim.evidence.push_back({kind, m_kurt.stream(role, sensor)->topic, event, at(t)});
        };
        shows("picture", StreamRole::Picture, "left", m_picture);
        shows("thermal", StreamRole::Thermal, "ir", m_heat);
        shows("gas", StreamRole::Gas, "", m_gas);
        publish(t, station_topic::Victims, victim);
    }

    const RobotDescription m_kurt, m_crawler;
    Log m_log;
    std::vector<SharedBytes> m_pictures;
    SharedBytes m_warmth;
    std::uint64_t m_picture = 0, m_heat = 0, m_gas = 0;  ///< newest
    DrivenMission m_made;
};

}  // namespace

DrivenMission writeDrivenMission(const std::filesystem::path& folder) {
    return Drive(folder).write();
}

}  // namespace leitstand::test
