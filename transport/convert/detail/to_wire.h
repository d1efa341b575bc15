#pragma once

#include <vector>

#include "core/event/event.h"
#include "messages/diagnostic_msgs.h"
#include "messages/leitstand_msgs.h"
#include "messages/nav_msgs.h"
#include "messages/sensor_msgs.h"
#include "messages/std_msgs.h"
#include "messages/tf2_msgs.h"
#include "transport/convert/detail/checks.h"

namespace leitstand::detail {

/// Holds bytes that a message only points at, until it is written.
using Buffer = std::vector<std::byte>;

// Convert core's types to messages. @p checks keeps the first error; the message is valid only without one.
void toWire(const CloudSample& from, wire::sensor_msgs::PointCloud2& to, Buffer& buffer, Checks& checks);
void toWire(const RangesSample& from, wire::sensor_msgs::LaserScan& to, Buffer&, Checks& checks);
void toWire(const OdometrySample& from, wire::nav_msgs::Odometry& to, Buffer&, Checks& checks);
void toWire(const ImuSample& from, wire::sensor_msgs::Imu& to, Buffer&, Checks& checks);
void toWire(const JointSample& from, wire::sensor_msgs::JointState& to, Buffer&, Checks& checks);
void toWire(const TransformsSample& from, wire::tf2_msgs::TFMessage& to, Buffer&, Checks& checks);
void toWire(const PoseSample& from, wire::geometry_msgs::PoseStamped& to, Buffer&, Checks& checks);
void toWire(const TwistSample& from, wire::geometry_msgs::Twist& to, Buffer&, Checks& checks);
void toWire(const TwistSample& from, wire::geometry_msgs::TwistStamped& to, Buffer&, Checks& checks);
void toWire(const PictureSample& from, wire::sensor_msgs::Image& to, Buffer&, Checks& checks);
void toWire(const PictureSample& from, wire::sensor_msgs::CompressedImage& to, Buffer&, Checks& checks);
void toWire(const CameraInfoSample& from, wire::sensor_msgs::CameraInfo& to, Buffer&, Checks& checks);
void toWire(const GasSample& from, wire::leitstand_msgs::GasConcentration& to, Buffer&, Checks& checks);
void toWire(const GasSample& from, wire::std_msgs::Float32& to, Buffer&, Checks& checks);
void toWire(const BatterySample& from, wire::sensor_msgs::BatteryState& to, Buffer&, Checks& checks);
void toWire(const DiagnosticsSample& from, wire::diagnostic_msgs::DiagnosticArray& to, Buffer&,
            Checks& checks);
void toWire(const ModeSample& from, wire::leitstand_msgs::Mode& to, Buffer&, Checks& checks);
void toWire(const BumpSample& from, wire::leitstand_msgs::Bumps& to, Buffer&, Checks& checks);
void toWire(const SightingSample& from, wire::leitstand_msgs::Sightings& to, Buffer&, Checks& checks);
void toWire(const StopStateSample& from, wire::leitstand_msgs::StopState& to, Buffer&, Checks& checks);
void toWire(const PongSample& from, wire::leitstand_msgs::Pong& to, Buffer&, Checks& checks);
void toWire(const StopCommandSample& from, wire::leitstand_msgs::StopCommand& to, Buffer&, Checks& checks);
void toWire(const ModeCommandSample& from, wire::leitstand_msgs::ModeCommand& to, Buffer&, Checks& checks);
void toWire(const StreamCommandSample& from, wire::leitstand_msgs::StreamCommand& to, Buffer&,
            Checks& checks);
void toWire(const PingSample& from, wire::leitstand_msgs::Ping& to, Buffer&, Checks& checks);
void toWire(const GrantSample& from, wire::leitstand_msgs::Grant& to, Buffer&, Checks& checks);
void toWire(const CandidateSample& from, wire::leitstand_msgs::Candidate& to, Buffer&, Checks& checks);
void toWire(const MissionInfoSample& from, wire::leitstand_msgs::MissionInfo& to, Buffer&, Checks& checks);
void toWire(const FindSample& from, wire::leitstand_msgs::Victim& to, Buffer&, Checks& checks);
void toWire(const KeyScanSample& from, wire::leitstand_msgs::KeyScan& to, Buffer&, Checks& checks);
void toWire(const MapCropSample& from, wire::leitstand_msgs::MapCrop& to, Buffer&, Checks& checks);
void toWire(const RobotPlaceSample& from, wire::leitstand_msgs::RobotPlace& to, Buffer&, Checks& checks);
void toWire(const ScanPosesSample& from, wire::leitstand_msgs::ScanPoses& to, Buffer&, Checks& checks);
void toWire(const ScanLinksSample& from, wire::leitstand_msgs::ScanLinks& to, Buffer&, Checks& checks);
void toWire(const ScanBodiesSample& from, wire::leitstand_msgs::ScanBodies& to, Buffer&, Checks& checks);
void toWire(const ClockSample& from, wire::leitstand_msgs::MissionClock& to, Buffer&, Checks& checks);
void toWire(const ClockOffsetSample& from, wire::leitstand_msgs::ClockOffset& to, Buffer&, Checks& checks);
void toWire(const UndoSample& from, wire::leitstand_msgs::Undo& to, Buffer&, Checks& checks);
void toWire(const CheckpointSample& from, wire::leitstand_msgs::Checkpoint& to, Buffer&, Checks& checks);
void toWire(const NoteSample& from, wire::leitstand_msgs::Note& to, Buffer&, Checks& checks);
void toWire(const SessionSample& from, wire::leitstand_msgs::Session& to, Buffer&, Checks& checks);
void toWire(const AlarmSample& from, wire::leitstand_msgs::Alarm& to, Buffer&, Checks& checks);

}  // namespace leitstand::detail
