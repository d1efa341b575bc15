#include "tests/app/review/written_mission.h"

#include <cmath>
#include <utility>
#include <vector>

#include <gtest/gtest.h>
#include <opencv2/imgcodecs.hpp>

#include "app/services/log/event_decoder.h"
#include "app/services/log/mission_robots.h"
#include "core/event/cloud_sample.h"
#include "core/event/find_sample.h"
#include "core/event/map_samples.h"
#include "core/event/motion_samples.h"
#include "core/event/picture_samples.h"
#include "core/event/scan_pose.h"
#include "core/event/station_samples.h"
#include "core/event/station_topics.h"
#include "core/event/status_samples.h"
#include "core/event/stream_role.h"
#include "core/io/robot/robot_file.h"
#include "core/mission/state/checkpoint/checkpoint.h"
#include "tests/support/places.h"
#include "transport/convert/encode.h"

namespace leitstand::test {
namespace {

constexpr int Headings = 25, Elevations = 31;  ///< of a slice of the 3D scanner

std::shared_ptr<const Scan> smallScan(double x) {
    auto scan = std::make_shared<Scan>();
    scan->robot = "kurt3d";
    scan->sensorInOdom = poseFrom({x, 0, 0.4}, 0, 0, 0);
    scan->hasOdometry = true;
    for (int i = 0; i < 200; ++i) {
        const auto angle = static_cast<float>(i) * 0.0314F;
        scan->points.emplace_back(3.0F * std::cos(angle), 3.0F * std::sin(angle),
                                  0.01F * static_cast<float>(i));
        scan->labels.push_back(Label::Wall);
    }
    return scan;
}

}  // namespace

Time WrittenMission::begin() {
    return Time(std::chrono::seconds(1'750'000'000));
}

Time WrittenMission::at(double seconds) {
    return begin() + std::chrono::nanoseconds(std::llround(seconds * 1e9));
}

const RobotDescription& WrittenMission::robot() {
    static const RobotDescription kurt = readRobot(sourceFolder() + "/resources/robots/kurt3d.yaml").value();
    return kurt;
}

WrittenMission::WrittenMission(std::filesystem::path folder, double checkpoints)
    : m_folder(std::move(folder)), m_interval(checkpoints) {
    EXPECT_TRUE(keepRobots(m_folder, {robot()}));
}

WrittenMission::~WrittenMission() {
    close();
}

void WrittenMission::close() {
    if (!m_writer) return;
    EXPECT_TRUE(m_writer->close());
    m_writer.reset();
}

void WrittenMission::write(double seconds, const std::string& topic, const Sample& sample) {
    if (!m_writer) {
        auto opened = BagWriter::open(m_folder);
        ASSERT_TRUE(opened) << opened.error().text;
        m_writer = std::move(opened).value();
    }
    const std::string type(typeOf(sample));
    auto payload = encode(sample, type);
    ASSERT_TRUE(payload) << topic << ": " << payload.error().text;
    m_writer->addTopic({topic, type, qosProfilesOf({}), "", "", false, false, "cdr"});
    const RawEvent raw{++m_sequence, at(seconds), topic, type, std::move(payload).value()};
    EventDecoder({robot()}).decode(raw, [this](const Event& event) { m_fold.add(event); });
    m_writer->write(raw);
}

void WrittenMission::publish(double seconds, const std::string& topic, const Sample& sample) {
    write(seconds, topic, sample);
    if (m_interval <= 0.0 || seconds < m_checkpointed + m_interval) return;
    m_checkpointed = seconds;
    write(seconds, std::string(station_topic::Checkpoints), checkpointOf(m_fold.state(), at(seconds)));
}

void WrittenMission::sayOdometry(double seconds, double x) {
    OdometrySample odometry;
    odometry.header = {at(seconds), "kurt3d/odom"};
    odometry.childFrame = "kurt3d/base_link";
    odometry.baseInOdom = poseFrom({x, 0, 0}, 0, 0, 0);
    odometry.linear.x() = 0.1;
    publish(seconds, "/kurt3d/odom", odometry);
}

void WrittenMission::sayPlace(double seconds, double x) {
    sayOdometry(seconds, x);
    CloudSample wall;  // 2 m ahead and to both sides
    wall.header = {at(seconds), "kurt3d/laser"};
    wall.rows = Headings;
    wall.columns = Elevations;
    for (int row = 0; row < Headings; ++row) {
        const float heading = -0.6F + 0.05F * static_cast<float>(row);
        for (int column = 0; column < Elevations; ++column)
            wall.points.emplace_back(2.0F * std::cos(heading), 2.0F * std::sin(heading),
                                     -0.4F + 0.05F * static_cast<float>(column));
    }
    publish(seconds, robot().stream(StreamRole::Points)->topic, wall);
}

void WrittenMission::sayPicture(double seconds, int grey) {
    std::vector<unsigned char> png;
    cv::imencode(".png", cv::Mat(24, 32, CV_8UC3, cv::Scalar(grey, grey, grey)), png);
    const auto bytes = std::make_shared<std::vector<std::byte>>();
    for (const unsigned char one : png) bytes->push_back(std::byte(one));
    PictureSample picture;
    picture.header = {at(seconds), "kurt3d/left"};
    picture.compressed = true;
    picture.encoding = "png";
    picture.content = {bytes, *bytes};
    publish(seconds, robot().stream(StreamRole::Picture, "left")->topic, picture);
}

void WrittenMission::sayKeyScan(double seconds, std::uint64_t id, double x) {
    KeyScanSample scan;
    scan.stamp = at(seconds);
    scan.id = id;
    scan.scan = smallScan(x);
    scan.sensorInBase = poseFrom({0, 0, 0.4}, 0, 0, 0);
    scan.scanInMap = poseFrom({x, 0, 0.4}, 0, 0, 0);
    scan.matched = id - 1;
    publish(seconds, std::string(station_topic::KeyScans), scan);
}

void WrittenMission::moveKeyScan(double seconds, std::uint64_t id, double x) {
    ScanPosesSample poses;
    poses.stamp = at(seconds);
    poses.station = "test";
    poses.cause = ScanPosesSample::Cause::LoopClosure;
    ScanPose pose;
    pose.scan = id;
    pose.scanInMap = poseFrom({x, 0, 0.4}, 0, 0, 0);
    pose.converged = true;
    poses.poses = {pose};
    publish(seconds, std::string(station_topic::ScanPoses), poses);
}

void WrittenMission::sayUndo(double seconds, std::uint64_t sequence) {
    UndoSample undo;
    undo.stamp = at(seconds);
    undo.station = "test";
    undo.event = sequence;
    publish(seconds, std::string(station_topic::Undo), undo);
}

void WrittenMission::sayCamera(double seconds) {
    CameraInfoSample info;
    info.header = {at(seconds), "kurt3d/left"};
    info.width = 320;
    info.height = 240;
    info.intrinsics = {320, 0, 160, 0, 320, 120, 0, 0, 1};
    publish(seconds, robot().stream(StreamRole::CameraInfo, "left")->topic, info);
}

void WrittenMission::sayVictim(double seconds, std::uint32_t number, FindSample::Status status) {
    FindSample victim;
    victim.stamp = victim.found = at(seconds);
    victim.station = "test";
    victim.number = number;
    victim.status = status;
    victim.robot = "kurt3d";
    victim.positionInMap = {1.0, 0.5, 0.3};
    publish(seconds, std::string(station_topic::Victims), victim);
}

void writeMinute(WrittenMission& mission) {
    mission.publish(0.0, std::string(station_topic::Sessions),
                    SessionSample{.stamp = WrittenMission::at(0.0),
                                  .station = "test",
                                  .title = "Test desk",
                                  .start = true,
                                  .mission = "minute",
                                  .version = "test"});
    const auto mode = [&](double seconds, const std::string& name) {
        ModeSample sample;
        sample.header = {WrittenMission::at(seconds), ""};
        sample.mode = name;
        sample.autonomous = name == "explore";
        sample.available = {"teleoperation", "explore"};
        mission.publish(seconds, WrittenMission::robot().stream(StreamRole::Mode)->topic, sample);
    };
    const auto bump = [&](double seconds, std::uint32_t hits) {
        BumpSample sample;
        sample.header = {WrittenMission::at(seconds), ""};
        sample.bumpers = {{"front_left", false, hits}};
        mission.publish(seconds, WrittenMission::robot().stream(StreamRole::Bumps)->topic, sample);
    };
    const auto alarm = [&](double seconds, AlarmSample::State state) {
        mission.publish(seconds, std::string(station_topic::Alarms),
                        AlarmSample{.stamp = WrittenMission::at(seconds),
                                    .station = "test",
                                    .robot = "kurt3d",
                                    .key = "link_lost",
                                    .severity = AlarmSample::Severity::Critical,
                                    .state = state,
                                    .text = "link lost, silent for 4 s"});
    };
    for (int i = 0; i <= 600; ++i) {
        const double t = 0.1 * i;
        mission.sayPlace(t, 0.1 * t);
        if (i == 1) mode(t, "teleoperation"), bump(t, 3);
        if (i % 5 == 0) mission.sayPicture(t, 20 + i / 5);
        if (i % 50 == 0) mission.sayKeyScan(t, static_cast<std::uint64_t>(i / 50 + 1), 0.1 * t);
        if (i == 200) mission.sayVictim(t, 1, FindSample::Status::Hypothesis);
        if (i == 250) alarm(t, AlarmSample::State::Raised);
        if (i == 280) alarm(t, AlarmSample::State::Cleared);
        if (i == 300) mode(t, "explore");
        if (i == 400)
            mission.publish(t, std::string(station_topic::Notes),
                            NoteSample{.stamp = WrittenMission::at(t),
                                       .station = "test",
                                       .robot = "kurt3d",
                                       .text = "door on the left"});
        if (i == 450) mission.sayVictim(t, 1, FindSample::Status::Confirmed);
        if (i == 500) bump(t, 4);
        if (i == 580) mission.moveKeyScan(t, 3, 1.5);
    }
}

}  // namespace leitstand::test
