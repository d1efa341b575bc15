#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <variant>

#include "core/base/time.h"
#include "core/event/candidate_sample.h"
#include "core/event/cloud_sample.h"
#include "core/event/command_samples.h"
#include "core/event/find_sample.h"
#include "core/event/map_samples.h"
#include "core/event/motion_samples.h"
#include "core/event/picture_samples.h"
#include "core/event/scan_links.h"
#include "core/event/station_samples.h"
#include "core/event/status_samples.h"
#include "core/event/stream_role.h"

namespace leitstand {

/// The content of an event, in core's own types.
using Sample =
    std::variant<CloudSample, RangesSample, OdometrySample, ImuSample, JointSample, TransformsSample,
                 PictureSample, CameraInfoSample, GasSample, BatterySample, DiagnosticsSample, ModeSample,
                 BumpSample, SightingSample, StopStateSample, PongSample, TwistSample, StopCommandSample,
                 ModeCommandSample, PoseSample, StreamCommandSample, PingSample, GrantSample, FindSample,
                 KeyScanSample, ScanPosesSample, RobotPlaceSample, ClockSample, ClockOffsetSample, UndoSample,
                 CheckpointSample, NoteSample, SessionSample, AlarmSample, CandidateSample, MissionInfoSample,
                 MapCropSample, ScanLinksSample, ScanBodiesSample>;

/// A RawEvent decoded: what core folds into the state of the mission (docs/design.md, "A mission is its
/// log").
struct Event {
    std::uint64_t sequence = 0;      ///< order of arrival within the mission, from 1
    Time received{};                 ///< station's clock
    std::string robot;               ///< "kurt3d"; empty for the station's own topics
    std::string topic;               ///< ROS name, "/kurt3d/odom", "/leitstand/victims"
    std::optional<StreamRole> role;  ///< what the topic carries; empty for the station's own topics
    std::string sensor;              ///< StreamDescription::sensor
    Sample sample;
};

}  // namespace leitstand
