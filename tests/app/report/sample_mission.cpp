#include "tests/app/report/sample_mission.h"

#include <chrono>
#include <cmath>
#include <condition_variable>
#include <map>
#include <memory>
#include <mutex>
#include <string>
#include <utility>

#include <gtest/gtest.h>

#include "app/services/log/live_mission.h"
#include "core/event/cloud_sample.h"
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
#include "core/io/robot/shipped_robots.h"
#include "core/mission/state/find_state.h"
#include "core/perception/pictures/coding/picture_png.h"
#include "tests/core/handin/report_scene.h"
#include "tests/support/samples.h"
#include "transport/convert/encode.h"

namespace leitstand::test {
namespace {

Time at(double seconds) {
    return Time(std::chrono::nanoseconds(1'700'000'000'000'000'000LL)) +
           std::chrono::nanoseconds(static_cast<std::int64_t>(seconds * 1e9));
}

/// Kurt3D as it is shipped.
const RobotDescription& kurt() {
    static const RobotDescription robot = [] {
        const auto file = findRobotFile("kurt3d");
        EXPECT_TRUE(file.ok()) << file.error().text;
        const auto read = readRobot(*file);
        EXPECT_TRUE(read.ok()) << read.error().text;
        return *read;
    }();
    return robot;
}

/// A gradient of colours.
Picture colours() {
    Picture picture{.width = 160, .height = 120, .pixel = Picture::Pixel::Rgb8, .bytes = {}};
    for (int i = 0; i < 160 * 120; ++i) {
        for (const int value : {i % 160, i / 160, 90}) picture.bytes.push_back(static_cast<std::byte>(value));
    }
    return picture;
}

/// 20 degrees with a warm spot of 36 degrees, in centikelvin.
Picture warmth() {
    Picture picture{.width = 80, .height = 60, .pixel = Picture::Pixel::Grey16, .bytes = {}};
    for (int i = 0; i < 80 * 60; ++i) {
        const bool warm = std::hypot(i % 80 - 40, i / 80 - 30) < 8;
        const unsigned value = warm ? 30915 : 29315;
        picture.bytes.push_back(static_cast<std::byte>(value & 0xff));
        picture.bytes.push_back(static_cast<std::byte>(value >> 8));
    }
    return picture;
}

/// A station that writes one event after the other.
class Writer {
public:
    explicit Writer(const std::filesystem::path& folder) {
        LiveMissionSettings settings;
        settings.folder = folder;
        settings.robots = {kurt()};
        settings.version = "test";
        settings.title = "Sample";
        LiveMissionListener listener;
        listener.onEvent = [this](const Event& event) {
            const std::lock_guard lock(m_mutex);
            m_newest[event.topic] = event.sequence;
            m_arrived.notify_all();
        };
        auto opened = LiveMission::open(settings, std::move(listener));
        EXPECT_TRUE(opened.ok()) << opened.error().text;
        m_mission = std::move(opened).value();
        for (const StreamDescription& one : kurt().streams) m_mission->addTopic(one.topic, one.type, one.qos);
    }
    ~Writer() { EXPECT_TRUE(m_mission->close().ok()); }
    Writer(const Writer&) = delete;
    Writer& operator=(const Writer&) = delete;

    /// Receives @p sample on the stream of @p topic; its sequence in the mission.
    std::uint64_t receive(const Sample& sample, const std::string& topic) {
        const std::uint64_t before = newestOf(topic);
        for (const StreamDescription& one : kurt().streams) {
            if (one.topic != topic) continue;
            auto cdr = encode(sample, one.type);
            EXPECT_TRUE(cdr.ok()) << cdr.error().text;
            m_mission->receive({0, {}, one.topic, one.type, std::move(cdr).value()});
        }
        return arrived(topic, before);
    }
    std::uint64_t publish(const Sample& sample, std::string_view topic) {
        const std::uint64_t before = newestOf(std::string(topic));
        const auto reported = m_mission->record(sample, topic);
        EXPECT_TRUE(reported.ok()) << reported.error().text;
        return arrived(std::string(topic), before);
    }

private:
    std::uint64_t newestOf(const std::string& topic) {
        const std::lock_guard lock(m_mutex);
        return m_newest[topic];
    }
    /// Waits until there is a newer event of @p topic than @p before: its sequence.
    std::uint64_t arrived(const std::string& topic, std::uint64_t before) {
        std::unique_lock lock(m_mutex);
        EXPECT_TRUE(m_arrived.wait_for(lock, std::chrono::seconds(60), [&] {
            return m_newest[topic] > before;
        })) << topic;
        return m_newest[topic];
    }

    std::mutex m_mutex;
    std::condition_variable m_arrived;
    std::map<std::string, std::uint64_t> m_newest;  ///< sequence by topic
    std::unique_ptr<LiveMission> m_mission;         // last: its threads use the others
};

PictureSample pictureOf(const Picture& picture, const char* frame, double seconds) {
    PictureSample sample;
    sample.header = {at(seconds), frame};
    sample.compressed = true;
    sample.encoding = "png";
    sample.content = sharedBytes(encodePng(picture).value());
    return sample;
}

FindSample find(FindSample::Kind kind, std::uint32_t number, const Eigen::Vector3d& place) {
    FindSample made;
    made.kind = kind;
    made.number = number;
    made.status = FindSample::Status::Confirmed;
    made.found = Time(std::chrono::system_clock::now().time_since_epoch());
    made.robot = "kurt3d";
    made.positionInMap = place;
    made.deviation = 0.05;
    return made;
}

/// What @p scan saw, a point in twenty, as its robot sends it.
CloudSample cloudOf(const ReportScan& scan) {
    CloudSample cloud;
    cloud.header = {scan.scan->end, "kurt3d/laser"};
    for (std::size_t i = 0; i < scan.scan->points.size(); i += 20)
        cloud.points.push_back(scan.scan->points[i]);
    return cloud;
}

/// CO2 that rises for a minute.
void smell(Writer& writer, FindSample& find) {
    for (int i = 0; i <= 20; ++i) {
        const double seconds = 10.2 - 3.0 * (20 - i), ppm = i < 10 ? 420.0 : 420.0 + 79.0 * (i - 10);
        const auto gas = writer.receive(GasSample{{at(seconds), ""}, "co2", ppm}, "/kurt3d/co2");
        find.evidence.push_back({"gas", "/kurt3d/co2", gas, at(seconds)});
    }
}

/// @p odometry: sequence of a sample of it; 0: there is none.
void sayFinds(Writer& writer, const std::vector<ReportScan>& scans, std::uint64_t odometry) {
    using Kind = FindSample::Kind;
    FindSample first = find(Kind::Victim, 1, {1.5, 1.0, 0.4});
    first.autonomous = true;
    first.form = {VictimSign::State::Present, "whole body"};
    first.motion = {VictimSign::State::Present, "waving"};
    first.heat = {VictimSign::State::Present, "", 36.4};
    first.sound = {VictimSign::State::Absent, ""};
    first.co2 = {VictimSign::State::Present, "", 1210.0};
    first.situation = "trapped";
    first.tag = "N17";
    first.area = "orange";
    first.text = "under a table <left> & cold";
    const auto picture =
        writer.receive(pictureOf(colours(), "kurt3d/left", 10.0), "/kurt3d/left/image/compressed");
    writer.receive(pictureOf(warmth(), "kurt3d/ir", 10.1), "/kurt3d/ir/image/compressed");
    first.evidence = {{"picture", "/kurt3d/left/image/compressed", picture, at(10.0)},
                      // As a station tells it that heard the same camera: by topic and stamp.
                      {"thermal", "/kurt3d/ir/image/compressed", 0, at(10.1)},
                      {"picture", "/kurt3d/left/image/compressed", 1'000'000, at(10.0)}};
    smell(writer, first);
    if (scans.size() > 1) {
        const std::string topic = kurt().stream(StreamRole::Points)->topic;
        first.evidence.push_back(
            {"scan", topic, writer.receive(cloudOf(scans[1]), topic), scans[1].scan->end});
    }
    if (odometry != 0) first.evidence.push_back({"odometry", "/kurt3d/odom", odometry, Time()});
    writer.publish(first, station_topic::Victims);
    FindSample second = find(Kind::Victim, 2, {-2.0, -1.5, 0.3});
    second.status = FindSample::Status::Hypothesis;
    writer.publish(second, station_topic::Victims);
    FindSample third = find(Kind::Victim, 3, {1.6, 1.0, 0.4});
    third.status = FindSample::Status::Discarded;
    third.mergedInto = 1;
    writer.publish(third, station_topic::Victims);
    writer.publish(find(Kind::Hazard, 1, {2.5, -1.0, 0.5}), station_topic::Victims);
    FindSample code = find(Kind::Code, 1, {0.5, -2.5, 0.5});
    code.tag = "exit, \"left\"";
    writer.publish(code, station_topic::Victims);
    FindSample object = find(Kind::Object, 1, {-1.0, 2.0, 0.1});
    object.text = "valve";
    writer.publish(object, station_topic::Victims);
}

/// What could be registered is there, but the operator has set every scan aside.
void rejectAll(Writer& writer, const std::vector<ReportScan>& scans) {
    ScanPosesSample poses;
    poses.cause = ScanPosesSample::Cause::Operator;
    for (const ReportScan& scan : scans) {
        CloudSample cloud;
        cloud.header = {scan.scan->end, "kurt3d/laser"};
        cloud.points = scan.scan->points;
        writer.receive(cloud, kurt().stream(StreamRole::Points)->topic);
        ScanPose pose;
        pose.scan = scan.id;
        pose.scanInMap = scan.scanInMap;
        pose.trust = ScanTrust::SetAside;
        poses.poses.push_back(pose);
    }
    writer.publish(poses, station_topic::ScanPoses);
}

}  // namespace

void writeSampleMission(const std::filesystem::path& folder, const SampleMission& what) {
    Writer writer(folder);
    if (what.info) {
        MissionInfoSample info;
        info.competition = "RoboCup2013";
        info.team = "Deutschland1";
        info.country = "Germany";
        info.mission = "Final 1";
        info.area = "yellow";
        info.profile = "2005";
        writer.publish(info, station_topic::Mission);
    }
    writer.receive(ModeSample{{at(100), ""}, "explore", true, "", {"explore"}}, "/kurt3d/mode");
    const auto scans = what.upstairs ? storeyScans(what.scans) : roomScans(what.scans);
    std::uint64_t frozen = 0;  // odometry of the moment of the second scan
    for (int i = 0; i < what.odometry; ++i) {
        OdometrySample odometry;
        // Odometry that begins elsewhere: from 100 s on, a scan every 5 s.
        odometry.header = {Time(std::chrono::milliseconds(100'000 + 250 * i)), "kurt3d/odom"};
        odometry.childFrame = "kurt3d/base_link";
        odometry.baseInOdom = poseFrom({3.0, 4.0 + 0.025 * i, 0.0}, 0, 0, degrees(90));
        const std::uint64_t sequence = writer.receive(odometry, "/kurt3d/odom");
        if (i == 20) frozen = sequence;
    }
    for (const ReportScan& scan : scans) {
        KeyScanSample sample;
        sample.id = scan.id;
        sample.scan = scan.scan;
        sample.sensorInBase = scan.sensorInBase;
        sample.scanInMap = scan.scanInMap;
        writer.publish(sample, station_topic::KeyScans);
    }
    if (what.setAside) rejectAll(writer, scans);
    if (what.finds) sayFinds(writer, scans, frozen);
    if (what.upstairs) {
        writer.publish(find(FindSample::Kind::Victim, 4, {2.5, 1.5, 3.4}), station_topic::Victims);
        writer.publish(find(FindSample::Kind::Code, 2, {1.5, 1.0, 3.6}), station_topic::Victims);
    }
    for (int i = 0; i < what.victims; ++i) {
        const Eigen::Vector3d far(-20.0 + 40.0 * (i % 4) / 3, -20.0 + 20.0 * (i / 4 % 3), 0.3),
            beside(3.0 + 0.15 * i, 2.0 - 0.1 * i, 0.3);
        const auto number = static_cast<std::uint32_t>(i + 1);
        writer.publish(find(FindSample::Kind::Victim, number, i < 3 ? beside : far), station_topic::Victims);
    }
}

}  // namespace leitstand::test
