#pragma once

#include "core/event/event.h"
#include "core/event/raw_event.h"
#include "core/robot/robot_description.h"
#include "messages/diagnostic_msgs.h"
#include "messages/leitstand_msgs.h"
#include "messages/nav_msgs.h"
#include "messages/sensor_msgs.h"
#include "messages/std_msgs.h"
#include "messages/tf2_msgs.h"
#include "transport/convert/detail/checks.h"

namespace leitstand::detail {

/// Where a message comes from.
struct Source {
    const Payload& cdr;
    const StreamDescription* stream = nullptr;  ///< null for the stations' own topics
};

// Convert messages to core's types. @p checks keeps the first error; the result is valid only without one.
CloudSample fromWire(const wire::sensor_msgs::PointCloud2& from, const Source&, Checks& checks);
RangesSample fromWire(const wire::sensor_msgs::LaserScan& from, const Source&, Checks& checks);
OdometrySample fromWire(const wire::nav_msgs::Odometry& from, const Source&, Checks& checks);
ImuSample fromWire(const wire::sensor_msgs::Imu& from, const Source&, Checks& checks);
JointSample fromWire(const wire::sensor_msgs::JointState& from, const Source&, Checks& checks);
TransformsSample fromWire(const wire::tf2_msgs::TFMessage& from, const Source&, Checks& checks);
PoseSample fromWire(const wire::geometry_msgs::PoseStamped& from, const Source&, Checks& checks);
TwistSample fromWire(const wire::geometry_msgs::Twist& from, const Source&, Checks& checks);
TwistSample fromWire(const wire::geometry_msgs::TwistStamped& from, const Source&, Checks& checks);
PictureSample fromWire(const wire::sensor_msgs::Image& from, const Source& source, Checks& checks);
PictureSample fromWire(const wire::sensor_msgs::CompressedImage& from, const Source& source, Checks& checks);
CameraInfoSample fromWire(const wire::sensor_msgs::CameraInfo& from, const Source&, Checks& checks);
GasSample fromWire(const wire::leitstand_msgs::GasConcentration& from, const Source& source, Checks& checks);
GasSample fromWire(const wire::std_msgs::Float32& from, const Source& source, Checks& checks);
GasSample fromWire(const wire::std_msgs::Float64& from, const Source& source, Checks& checks);
BatterySample fromWire(const wire::sensor_msgs::BatteryState& from, const Source&, Checks& checks);
DiagnosticsSample fromWire(const wire::diagnostic_msgs::DiagnosticArray& from, const Source& source,
                           Checks& checks);
ModeSample fromWire(const wire::leitstand_msgs::Mode& from, const Source&, Checks& checks);
BumpSample fromWire(const wire::leitstand_msgs::Bumps& from, const Source&, Checks& checks);
SightingSample fromWire(const wire::leitstand_msgs::Sightings& from, const Source&, Checks& checks);
StopStateSample fromWire(const wire::leitstand_msgs::StopState& from, const Source&, Checks& checks);
PongSample fromWire(const wire::leitstand_msgs::Pong& from, const Source&, Checks& checks);
StopCommandSample fromWire(const wire::leitstand_msgs::StopCommand& from, const Source&, Checks& checks);
ModeCommandSample fromWire(const wire::leitstand_msgs::ModeCommand& from, const Source&, Checks& checks);
StreamCommandSample fromWire(const wire::leitstand_msgs::StreamCommand& from, const Source&, Checks& checks);
PingSample fromWire(const wire::leitstand_msgs::Ping& from, const Source&, Checks& checks);
GrantSample fromWire(const wire::leitstand_msgs::Grant& from, const Source&, Checks& checks);
CandidateSample fromWire(const wire::leitstand_msgs::Candidate& from, const Source&, Checks& checks);
MissionInfoSample fromWire(const wire::leitstand_msgs::MissionInfo& from, const Source&, Checks& checks);
FindSample fromWire(const wire::leitstand_msgs::Victim& from, const Source&, Checks& checks);
KeyScanSample fromWire(const wire::leitstand_msgs::KeyScan& from, const Source&, Checks& checks);
MapCropSample fromWire(const wire::leitstand_msgs::MapCrop& from, const Source&, Checks& checks);
RobotPlaceSample fromWire(const wire::leitstand_msgs::RobotPlace& from, const Source&, Checks& checks);
ScanPosesSample fromWire(const wire::leitstand_msgs::ScanPoses& from, const Source&, Checks& checks);
ScanLinksSample fromWire(const wire::leitstand_msgs::ScanLinks& from, const Source&, Checks& checks);
ScanBodiesSample fromWire(const wire::leitstand_msgs::ScanBodies& from, const Source&, Checks& checks);
ClockSample fromWire(const wire::leitstand_msgs::MissionClock& from, const Source&, Checks& checks);
ClockOffsetSample fromWire(const wire::leitstand_msgs::ClockOffset& from, const Source&, Checks& checks);
UndoSample fromWire(const wire::leitstand_msgs::Undo& from, const Source&, Checks& checks);
CheckpointSample fromWire(const wire::leitstand_msgs::Checkpoint& from, const Source& source, Checks& checks);
NoteSample fromWire(const wire::leitstand_msgs::Note& from, const Source&, Checks& checks);
SessionSample fromWire(const wire::leitstand_msgs::Session& from, const Source&, Checks& checks);
AlarmSample fromWire(const wire::leitstand_msgs::Alarm& from, const Source&, Checks& checks);

}  // namespace leitstand::detail
