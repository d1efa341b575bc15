#include "tests/transport/convert/conversion.h"

#include <gtest/gtest.h>

#include "core/event/sample.h"
#include "messages/diagnostic_msgs.h"
#include "messages/ffmpeg_image_transport_msgs.h"
#include "messages/foxglove_msgs.h"
#include "messages/leitstand_msgs.h"
#include "messages/livox_ros_driver2.h"
#include "messages/map_msgs.h"
#include "messages/nav_msgs.h"
#include "messages/sensor_msgs.h"
#include "messages/std_msgs.h"
#include "messages/tf2_msgs.h"
#include "messages/trajectory_msgs.h"
#include "messages/vision_msgs.h"
#include "messages/visualization_msgs.h"

namespace leitstand::test {
namespace {

template <class Message>
Result<std::vector<std::byte>> recodedAs(std::span<const std::byte> bytes, std::endian order) {
    CdrReader in(bytes);
    Message message;
    decode(in, message);
    if (const auto end = in.finish(); !end) return end.error();
    CdrWriter out(order);
    encode(out, message);
    return std::move(out).finish();
}

using Recoder = Result<std::vector<std::byte>> (*)(std::span<const std::byte>, std::endian);
struct Entry {
    std::string_view type;
    Recoder recode;
};

template <class... Messages>
std::vector<Entry> entries() {
    return {{Messages::RosName, &recodedAs<Messages>}...};
}

const std::vector<Entry>& allEntries() {
    using namespace wire;
    namespace lm = wire::leitstand_msgs;
    static const auto all = entries<
        builtin_interfaces::Time, builtin_interfaces::Duration, std_msgs::Header, std_msgs::Bool,
        std_msgs::Empty, std_msgs::Float32, std_msgs::Float64, std_msgs::Int32, std_msgs::String,
        std_msgs::ColorRGBA, geometry_msgs::PoseWithCovarianceStamped, geometry_msgs::Point32,
        geometry_msgs::Polygon, geometry_msgs::PolygonStamped, visualization_msgs::UVCoordinate,
        visualization_msgs::MeshFile, visualization_msgs::Marker, visualization_msgs::MarkerArray,
        vision_msgs::ObjectHypothesis, vision_msgs::ObjectHypothesisWithPose, vision_msgs::BoundingBox3D,
        vision_msgs::Detection3D, vision_msgs::Detection3DArray, vision_msgs::Point2D, vision_msgs::Pose2D,
        vision_msgs::BoundingBox2D, vision_msgs::Detection2D, vision_msgs::Detection2DArray, std_msgs::UInt32,
        std_msgs::Int8, std_msgs::Int16, std_msgs::Int64, std_msgs::UInt8, std_msgs::UInt16, std_msgs::UInt64,
        sensor_msgs::Temperature, sensor_msgs::RelativeHumidity, sensor_msgs::FluidPressure,
        sensor_msgs::MagneticField, sensor_msgs::Range, sensor_msgs::Illuminance, sensor_msgs::NavSatStatus,
        sensor_msgs::NavSatFix, std_msgs::MultiArrayDimension, std_msgs::MultiArrayLayout,
        std_msgs::Float64MultiArray, trajectory_msgs::JointTrajectoryPoint, trajectory_msgs::JointTrajectory,
        geometry_msgs::Vector3, geometry_msgs::Point, geometry_msgs::Quaternion, geometry_msgs::Pose,
        geometry_msgs::PoseStamped, geometry_msgs::PoseWithCovariance, geometry_msgs::Twist,
        geometry_msgs::TwistStamped, geometry_msgs::TwistWithCovariance, geometry_msgs::Transform,
        geometry_msgs::TransformStamped, nav_msgs::Odometry, nav_msgs::MapMetaData, nav_msgs::OccupancyGrid,
        nav_msgs::Path, map_msgs::OccupancyGridUpdate, tf2_msgs::TFMessage, diagnostic_msgs::KeyValue,
        diagnostic_msgs::DiagnosticStatus, diagnostic_msgs::DiagnosticArray, sensor_msgs::PointField,
        sensor_msgs::PointCloud2, sensor_msgs::LaserScan, sensor_msgs::Image, sensor_msgs::CompressedImage,
        sensor_msgs::RegionOfInterest, sensor_msgs::CameraInfo, sensor_msgs::Imu, sensor_msgs::JointState,
        sensor_msgs::BatteryState, lm::GasConcentration, lm::Mode, lm::Bumper, lm::Bumps, lm::Sighting,
        lm::Sightings, lm::StopState, lm::Pong, lm::StopCommand, lm::ModeCommand, lm::StreamCommand, lm::Ping,
        lm::Grant, lm::VictimSign, lm::VictimEvidence, lm::Victim, lm::Cue, lm::Candidate, lm::MissionInfo,
        lm::KeyScan, lm::ScanPose, lm::ScanPoses, lm::ScanLink, lm::ScanLinks, lm::BodyInScan,
        lm::BodiesOfScan, lm::ScanBodies, lm::MapCrop, lm::RobotPlace, lm::MissionClock, lm::ClockOffset,
        lm::Undo, lm::Checkpoint, lm::Note, lm::Session, lm::Alarm, ffmpeg_image_transport_msgs::FFMPEGPacket,
        foxglove_msgs::CompressedVideo, livox_ros_driver2::CustomPoint, livox_ros_driver2::CustomMsg>();
    return all;
}

}  // namespace

RawEvent rawEvent(const SampleCase& one, std::vector<std::byte> bytes) {
    RawEvent event;
    event.sequence = 5;
    event.topic = one.role ? one.stream().topic : "/leitstand/test";
    event.type = one.type;
    event.cdr = std::make_shared<const std::vector<std::byte>>(std::move(bytes));
    return event;
}

Result<Sample> decodeCase(const SampleCase& one, const RawEvent& event) {
    if (one.role) return decode(event, one.stream());
    auto station = decodeStationEvent(event);
    if (!station) return station.error();
    return std::move(station).value().sample;
}

std::vector<std::byte> encoded(const SampleCase& one) {
    const auto payload = encode(one.sample, one.type);
    if (!payload) {
        ADD_FAILURE() << payload.error().text;
        return {};
    }
    return **payload;
}

Result<std::vector<std::byte>> recoded(std::string_view type, std::span<const std::byte> bytes,
                                       std::endian order) {
    for (const Entry& entry : allEntries()) {
        if (entry.type == type) return entry.recode(bytes, order);
    }
    return Error{std::string(type) + ": the tests do not know it"};
}

}  // namespace leitstand::test
