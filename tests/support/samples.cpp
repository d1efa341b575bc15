#include "tests/support/samples.h"

#include <numeric>

#include "core/event/candidate_sample.h"
#include "core/event/cloud_sample.h"
#include "core/event/command_samples.h"
#include "core/event/find_sample.h"
#include "core/event/map_samples.h"
#include "core/event/motion_samples.h"
#include "core/event/picture_samples.h"
#include "core/event/sample_header.h"
#include "core/event/scan_bodies.h"
#include "core/event/scan_links.h"
#include "core/event/scan_pose.h"
#include "core/event/station_samples.h"
#include "core/event/status_samples.h"
#include "core/event/stream_role.h"
#include "core/perception/pictures/video/video_packet.h"

namespace leitstand::test {
namespace {

using std::chrono::nanoseconds;

Time at(std::int64_t seconds, std::int64_t ns) {
    return Time(std::chrono::seconds(seconds) + nanoseconds(ns));
}

SampleHeader header() {
    return {at(1'700'000'001, 123'456'789), "lidar"};
}

/// Quarter turns about all axes: exact as matrix and as quaternion.
Pose pose(double x) {
    Pose pose = Pose::Identity();
    pose.linear() = Eigen::Quaterniond(0.5, 0.5, 0.5, 0.5).toRotationMatrix();
    pose.translation() = Eigen::Vector3d(x, x + 0.25, x + 0.5);
    return pose;
}

template <std::size_t N>
std::array<double, N> counted(double first) {
    std::array<double, N> values;
    std::iota(values.begin(), values.end(), first);
    return values;
}

SharedBytes countedBytes(std::size_t count) {
    std::vector<std::byte> bytes(count);
    for (std::size_t i = 0; i < count; ++i) bytes[i] = static_cast<std::byte>(i * 7 + 1);
    return sharedBytes(std::move(bytes));
}

CloudSample cloud() {
    CloudSample cloud{header(), 2, 3, {}, {}, {}, {}};
    for (int i = 0; i < 6; ++i) {
        const auto f = static_cast<float>(i);
        cloud.points.push_back({f + 0.5F, f - 2.25F, 0.125F * f});
        cloud.intensities.push_back(f * 10.0F);
        cloud.times.push_back(std::int64_t{i} * 1'000'001);
        cloud.rings.push_back(i / 3 + 100);
    }
    return cloud;
}

ImuSample imu() {
    ImuSample imu;
    imu.header = header();
    imu.orientation = Eigen::Quaterniond(0.5, -0.5, 0.5, -0.5);
    imu.angularVelocity = Eigen::Vector3d(1.0, 2.0, 3.0);
    imu.linearAcceleration = Eigen::Vector3d(4.0, 5.0, 9.81);
    imu.orientationCovariance = counted<9>(1);
    imu.angularVelocityCovariance = counted<9>(11);
    imu.linearAccelerationCovariance = counted<9>(21);
    return imu;
}

PictureSample picture(bool compressed) {
    PictureSample picture;
    picture.header = header();
    picture.compressed = compressed;
    if (compressed) {
        picture.encoding = "jpeg";
        picture.content = sharedBytes({std::byte{0xff}, std::byte{0xd8}, std::byte{0xff}, std::byte{7}});
        return picture;
    }
    picture.encoding = "bgr8";
    picture.width = 4;
    picture.height = 2;
    picture.step = 13;
    picture.content = countedBytes(26);
    return picture;
}

/// A picture of a video; @p sized: with its size.
PictureSample videoPicture(const std::string& encoding, bool sized) {
    PictureSample picture;
    picture.header = header();
    picture.compressed = true;
    picture.encoding = encoding;
    if (sized) picture.width = 640;
    if (sized) picture.height = 480;
    const bool h264 = encoding == "h264";
    const std::byte unit = h264 ? std::byte{0x65} : std::byte{0x26};  // a key picture
    picture.content = sharedBytes({std::byte{0}, std::byte{0}, std::byte{1}, unit, std::byte{7}});
    picture.video = std::make_shared<const VideoPacket>(VideoPacket{
        .codec = h264 ? VideoCodec::H264 : VideoCodec::H265, .key = true, .bytes = picture.content});
    return picture;
}

/// As Livox scanners send it: no grid, lines and intensities of 8 bits.
CloudSample livoxCloud() {
    CloudSample livox = cloud();
    livox.rows = livox.columns = 0;
    for (std::size_t i = 0; i < livox.rings.size(); ++i) livox.rings[i] = static_cast<std::int32_t>(i % 4);
    return livox;
}

BatterySample battery() {
    BatterySample battery;
    battery.header = header();
    battery.voltage = 24.5;
    battery.current = -3.25;
    battery.charge = 7.5;
    battery.capacity = 10.0;
    battery.fraction = 0.75;
    battery.temperature = 31.5;
    battery.status = BatterySample::Status::Discharging;
    battery.location = "rear";
    return battery;
}

FindSample victim() {
    using State = VictimSign::State;
    FindSample victim;
    victim.stamp = at(1'700'000'100, 5);
    victim.station = "station-1";
    victim.number = 3;
    victim.status = FindSample::Status::Confirmed;
    victim.found = at(1'700'000'090, 6);
    victim.robot = "kurt3d";
    victim.autonomous = true;
    victim.scan = 12;
    victim.positionInScan = {1.5, 2.5, -0.5};
    victim.positionInMap = {11.5, 12.5, 0.25};
    victim.deviation = 0.125;
    victim.form = {State::Present, "arm", 1.0};
    victim.motion = {State::Absent, "none", 2.0};
    victim.heat = {State::Present, "hand", 33.5};
    victim.sound = {State::Unknown, "", 4.0};
    victim.co2 = {State::Present, "rising", 1800.0};
    victim.situation = "void";
    victim.tag = "R-17";
    victim.area = "orange";
    victim.text = "beneath the stairs";
    victim.evidence = {{"picture", "/kurt3d/left/image/compressed", 4711, at(1'700'000'089, 7)},
                       {"gas", "/kurt3d/co2", 4712, at(1'700'000'090, 8)}};
    victim.kind = FindSample::Kind::Object;
    victim.mergedInto = 2;
    return victim;
}

CandidateSample candidate() {
    CandidateSample candidate;
    candidate.stamp = at(1'700'000'101, 5);
    candidate.station = "station-1";
    candidate.id = 5;
    candidate.kind = FindSample::Kind::Hazard;
    candidate.scan = 13;
    candidate.positionInScan = {2.5, 3.5, -1.5};
    candidate.positionInMap = {12.5, 13.5, 0.75};
    candidate.deviation = 0.25;
    candidate.confidence = 0.75;
    candidate.victim = 3;
    candidate.dismissed = true;
    candidate.cues = {{"heat", "kurt3d", "ir", "/kurt3d/ir/image", 4713, at(1'700'000'091, 9), 33.5, 0.5, ""},
                      {"code", "kurt3d", "left", "/kurt3d/left/image/compressed", 4714, at(1'700'000'092, 10),
                       1.0, 1.0, "R-17"}};
    return candidate;
}

KeyScanSample keyScan() {
    Scan scan;
    scan.name = "scan007";
    scan.robot = "kurt3d";
    scan.start = at(1'700'000'010, 1);
    scan.end = at(1'700'000'012, 2);
    scan.sensorInOdom = pose(3.0);
    scan.hasOdometry = true;
    scan.rows = 2;
    scan.columns = 2;
    scan.sweep = Sweep::Yawing;
    scan.points = {{1, 2, 3}, {4, 5, 6}, {7, 8, 9}, {10, 11, 12}};
    scan.intensities = {0.5F, 1.5F, 2.5F, 3.5F};
    scan.labels = {Label::Floor, Label::Wall, Label::Ceiling, Label::Unlabelled};
    return {at(1'700'000'013, 3), 7, std::make_shared<const Scan>(scan), pose(0.25), pose(5.0), 6};
}

MarkersSample markers() {
    MarkersSample sample;
    sample.replacesAll = true;
    for (int i = 0; i < 3; ++i) {
        Marker& marker = sample.markers.emplace_back();
        marker.header = header();
        marker.space = "signs";
        marker.id = i;
    }
    Marker& boxes = sample.markers[0];
    boxes.markerInFrame = pose(2.0);
    boxes.size = {0.5, 0.25, 0.125};
    boxes.colour = {0.5F, 0.25F, 0.75F, 1.0F};
    boxes.lifetime = std::chrono::milliseconds(1500);
    boxes.points = {{1, 2, 3}, {4, 5, 6}};
    sample.markers[1].shape = MarkerShape::Text;
    sample.markers[1].text = "exit";
    sample.markers[2].removed = true;
    return sample;
}

/// One by one: in one expression they would be built twice, in a list and in the vector.
void add(std::vector<SampleCase>& cases, const char* type, std::optional<StreamRole> role, Sample sample) {
    cases.push_back({type, role, std::move(sample)});
}

std::vector<SampleCase> robotCases() {
    using R = StreamRole;
    const JointSample joints{header(), {"left", "right"}, {0.5, 1.5}, {2.5, 3.5}, {4.5, 5.5}};
    const TwistSample stamped{at(1'700'000'002, 9), "base_link", {0.25, 0.5, 0.75}, {1.0, 1.25, 1.5}};
    TwistSample twist = stamped;
    twist.stamp.reset();
    twist.frame.clear();
    std::vector<SampleCase> cases;
    add(cases, "sensor_msgs/msg/PointCloud2", R::Points, cloud());
    add(cases, "sensor_msgs/msg/LaserScan", R::Ranges,
        RangesSample{header(), -1.5, 0.5, 0.25, 0.125, 0.0625, 30.0, {1, 2, 3, 4}, {5, 6, 7, 8}});
    add(cases, "nav_msgs/msg/Odometry", R::Odometry,
        OdometrySample{
            header(), "base_link", pose(1.0), {1, 2, 3}, {4, 5, 6}, counted<36>(1), counted<36>(51)});
    add(cases, "sensor_msgs/msg/Imu", R::Imu, imu());
    add(cases, "sensor_msgs/msg/JointState", R::Joints, joints);
    add(cases, "tf2_msgs/msg/TFMessage", R::Transforms,
        TransformsSample{{{header(), "camera", pose(2.0)}, {header(), "arm", pose(4.0)}}});
    add(cases, "sensor_msgs/msg/Image", R::Picture, picture(false));
    add(cases, "sensor_msgs/msg/CompressedImage", R::Picture, picture(true));
    add(cases, "sensor_msgs/msg/CameraInfo", R::CameraInfo,
        CameraInfoSample{header(),
                         640,
                         480,
                         "plumb_bob",
                         {0.1, 0.2, 0.3, 0.4, 0.5},
                         counted<9>(1),
                         counted<9>(11),
                         counted<12>(21),
                         2,
                         3,
                         4,
                         5,
                         320,
                         240});
    add(cases, "leitstand_msgs/msg/GasConcentration", R::Gas, GasSample{header(), "co2", 412.5});
    add(cases, "std_msgs/msg/Float32", R::Gas, GasSample{{}, "co2", 412.5});
    add(cases, "sensor_msgs/msg/BatteryState", R::Battery, battery());
    add(cases, "diagnostic_msgs/msg/DiagnosticArray", R::Diagnostics,
        DiagnosticsSample{header(),
                          {{DiagnosticStatus::Level::Error,
                            "motor",
                            "hot",
                            "kurt3d/motor",
                            {{"celsius", "91"}, {"limit", "80"}}}}});
    add(cases, "leitstand_msgs/msg/Mode", R::Mode,
        ModeSample{header(), "explore", true, "asked", {"teleoperation", "explore"}});
    add(cases, "leitstand_msgs/msg/Bumps", R::Bumps,
        BumpSample{header(), {{"front", true, 3}, {"rear", false, 1}}});
    add(cases, "leitstand_msgs/msg/Sightings", R::Sightings,
        SightingSample{header(), {{4, "heat", {1.5, 2.5, 3.5}, 0.25, 0.75, 34.5, "warm"}}});
    add(cases, "leitstand_msgs/msg/StopState", R::StopState,
        StopStateSample{header(), 17, "station-1", true, true, "no grant", 23});
    add(cases, "leitstand_msgs/msg/Pong", R::Pong,
        PongSample{18, "station-1", at(1'700'000'003, 1), at(1'700'000'004, 2), at(1'700'000'005, 3)});
    add(cases, "geometry_msgs/msg/Twist", R::DriveCommand, twist);
    add(cases, "geometry_msgs/msg/TwistStamped", R::DriveCommand, stamped);
    add(cases, "leitstand_msgs/msg/StopCommand", R::StopCommand,
        StopCommandSample{at(1'700'000'006, 4), "station-1", 19, true, 21});
    add(cases, "leitstand_msgs/msg/ModeCommand", R::ModeCommand,
        ModeCommandSample{at(1'700'000'007, 5), "station-1", "explore"});
    add(cases, "geometry_msgs/msg/PoseStamped", R::GoalPose, PoseSample{header(), pose(6.0)});
    add(cases, "leitstand_msgs/msg/StreamCommand", R::StreamCommand,
        StreamCommandSample{at(1'700'000'008, 6), "station-1", "/kurt3d/left", true, 7.5, 60, 640});
    add(cases, "leitstand_msgs/msg/Ping", R::Ping, PingSample{20, "station-1", at(1'700'000'009, 7)});
    add(cases, "std_msgs/msg/Bool", R::StopLock, DriveLockSample{true});
    add(cases, "trajectory_msgs/msg/JointTrajectory", R::JointCommand,
        JointTrajectorySample{header(),
                              {"a", "b"},
                              {{{0.5, 1.5}, {2.5, 3.5}, std::chrono::milliseconds(250)},
                               {{4.5, 5.5}, {}, std::chrono::seconds(2)}}});
    add(cases, "std_msgs/msg/Float64MultiArray", R::JointCommand, NumbersSample{{0.25, -1.5, 7.0}});
    add(cases, "nav_msgs/msg/OccupancyGrid", R::Grid,
        OccupancyGridSample{header(), at(1'700'000'010, 2), 0.25, 3, 2, pose(7.0), {0, 100, -1, 50, 1, 99}});
    add(cases, "map_msgs/msg/OccupancyGridUpdate", R::GridUpdate,
        GridUpdateSample{header(), 4, 5, 2, 1, {100, -1}});
    add(cases, "ffmpeg_image_transport_msgs/msg/FFMPEGPacket", R::Picture, videoPicture("libx265", true));
    add(cases, "foxglove_msgs/msg/CompressedVideo", R::Picture, videoPicture("h264", false));
    add(cases, "livox_ros_driver2/msg/CustomMsg", R::Points, livoxCloud());
    add(cases, "visualization_msgs/msg/MarkerArray", R::Markers, markers());
    add(cases, "sensor_msgs/msg/Temperature", R::Reading, ReadingSample{header(), {23.5}});
    add(cases, "sensor_msgs/msg/RelativeHumidity", R::Reading, ReadingSample{header(), {50.0}});
    add(cases, "sensor_msgs/msg/FluidPressure", R::Reading, ReadingSample{header(), {1024.0}});
    add(cases, "sensor_msgs/msg/MagneticField", R::Reading, ReadingSample{header(), {50.0}});
    add(cases, "sensor_msgs/msg/Range", R::Reading, ReadingSample{header(), {0.75}});
    add(cases, "sensor_msgs/msg/Illuminance", R::Reading, ReadingSample{header(), {300.0}});
    add(cases, "sensor_msgs/msg/NavSatFix", R::Reading, ReadingSample{header(), {51.5, -8.25, 110.0}});
    add(cases, "std_msgs/msg/String", R::Model, RobotModelSample{"<robot name=\"rover\"/>"});
    add(cases, "vision_msgs/msg/Detection2DArray", R::Detections,
        DetectionsSample{header(), {{{320.5, 240.0}, {64.0, 128.0}, 0.25, "person", 0.875}}});
    add(cases, "nav_msgs/msg/Path", R::Path, PathSample{header(), {pose(8.0), pose(9.0)}});
    return cases;
}

Link scanLink() {
    Link link;
    link.id = 1001;
    link.from = 7;
    link.to = 90;
    link.pose = pose(11.0);
    link.information = Information::Constant(2.0);
    link.information.diagonal() << 1e4, 2e4, 3e4, 9e4, 8e4, 7e4;
    link.kind = LinkKind::Loop;
    link.station = "station-1";
    link.active = false;
    return link;
}

std::vector<SampleCase> stationCases() {
    using std::nullopt;
    const Time now = at(1'700'000'020, 8);
    std::vector<SampleCase> cases;
    add(cases, "leitstand_msgs/msg/Grant", nullopt,
        GrantSample{now, "station-1", "Left desk", GrantSample::Kind::Camera, GrantSample::Action::Consent,
                    "kurt3d", "station-2", 21});
    add(cases, "leitstand_msgs/msg/Victim", nullopt, victim());
    add(cases, "leitstand_msgs/msg/Candidate", nullopt, candidate());
    add(cases, "leitstand_msgs/msg/KeyScan", nullopt, keyScan());
    add(cases, "leitstand_msgs/msg/ScanPoses", nullopt,
        ScanPosesSample{now,
                        "station-1",
                        ScanPosesSample::Cause::LoopClosure,
                        {{7, pose(7.0), 0.01, 0.9, 0.8, 0.7, true, ScanTrust::Certain, 0},
                         {8, pose(8.0), 0.02, 0.6, 0.5, 0.4, false, ScanTrust::Uncertain, 0x15}}});
    add(cases, "leitstand_msgs/msg/ScanLinks", nullopt, ScanLinksSample{now, "station-1", {scanLink()}});
    add(cases, "leitstand_msgs/msg/ScanBodies", nullopt,
        ScanBodiesSample{now,
                         "station-1",
                         {{7,
                           {{"crawler", {{0.3, 0.2}, {-0.3, 0.2}, {-0.3, -0.2}}, 0.4, pose(11.0), 0.1},
                            {"spot", {{0.5, 0.2}, {-0.5, 0.2}, {-0.5, -0.2}}, 0.6, pose(12.0), 0.3}}},
                          {8, {}}}});
    add(cases, "leitstand_msgs/msg/MapCrop", nullopt,
        MapCropSample{now, "station-1", {{-1.0, -2.0}, {4.0, -2.0}, {4.0, 3.5}}, 2.1});
    add(cases, "leitstand_msgs/msg/RobotPlace", nullopt,
        RobotPlaceSample{now, "station-1", "crawler", RobotPlaceSample::Cause::Seen, at(1'700'000'019, 7),
                         pose(9.0), pose(10.0), 0.6, 0.7, true, "70 % of what it sees"});
    add(cases, "leitstand_msgs/msg/MissionClock", nullopt,
        ClockSample{now, "station-1", true, nanoseconds(61'000'000'001), nanoseconds(1'200'000'000'000)});
    add(cases, "leitstand_msgs/msg/MissionInfo", nullopt,
        MissionInfoSample{now, "station-1", "RoboCup2013", "Kurt", "Germany", "Final", 2, "orange", "2013"});
    add(cases, "leitstand_msgs/msg/ClockOffset", nullopt,
        ClockOffsetSample{now, "kurt3d", nanoseconds(-5'000'000'001), nanoseconds(1'000),
                          nanoseconds(20'000)});
    add(cases, "leitstand_msgs/msg/Undo", nullopt, UndoSample{now, "station-1", 22, "victim 3"});
    add(cases, "leitstand_msgs/msg/Checkpoint", nullopt, CheckpointSample{now, 23, 2, countedBytes(37)});
    add(cases, "leitstand_msgs/msg/Note", nullopt, NoteSample{now, "station-1", "kurt3d", "smoke"});
    add(cases, "leitstand_msgs/msg/Session", nullopt,
        SessionSample{now, "station-1", "Left desk", true, "final", "0.1.0", 2});
    add(cases, "leitstand_msgs/msg/Alarm", nullopt,
        AlarmSample{now, "station-1", "kurt3d", "link_lost", AlarmSample::Severity::Critical,
                    AlarmSample::State::Acknowledged, "no odometry for 3 s"});
    return cases;
}

}  // namespace

SharedBytes sharedBytes(std::vector<std::byte> bytes) {
    const auto owner = std::make_shared<const std::vector<std::byte>>(std::move(bytes));
    return {owner, *owner};
}

StreamDescription SampleCase::stream() const {
    StreamDescription stream;
    stream.role = role.value();
    stream.topic = "/kurt3d/" + toString(*role);
    stream.type = type;
    if (*role == StreamRole::Reading) stream.readings = usualReadings(type);
    return stream;
}

std::vector<SampleCase> sampleCases() {
    std::vector<SampleCase> cases = robotCases();
    for (SampleCase& one : stationCases()) cases.push_back(std::move(one));
    return cases;
}

}  // namespace leitstand::test
