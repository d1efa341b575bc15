#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>

#include "core/base/time.h"
#include "core/robot/robot_description.h"
#include "core/robot/samples/command_samples.h"
#include "core/robot/samples/map_samples.h"
#include "core/robot/samples/motion_samples.h"
#include "core/robot/samples/station_samples.h"
#include "core/robot/samples/status_samples.h"

namespace leitstand {

/// How much came over a topic, and when last.
struct StreamState {
    std::optional<StreamRole> role;  ///< empty for the station's own topics
    std::string sensor;              ///< StreamDescription::sensor
    std::uint64_t events = 0;
    std::uint64_t sequence = 0;  ///< of the newest
    Time received{};             ///< newest, station's clock
    Time stamp{};                ///< newest, sender's clock; epoch where the sample has none
};

/// A sample and where it stands in the mission.
template <class T>
struct Latest {
    std::uint64_t sequence = 0;
    Time received{};  ///< station's clock
    T sample;
};

/// What a robot said last. Scans and pictures are not kept: StreamState tells where the newest stands.
struct RobotState {
    std::optional<Latest<OdometrySample>> odometry;  ///< without its covariances
    std::optional<Latest<ImuSample>> imu;            ///< without its covariances
    std::optional<Latest<ModeSample>> mode;
    std::optional<Latest<BatterySample>> battery;
    std::optional<Latest<GasSample>> gas;
    std::optional<Latest<BumpSample>> bumps;
    std::optional<Latest<SightingSample>> sightings;
    std::optional<Latest<DiagnosticsSample>>
        diagnostics;  ///< newest of every part, by name; newest part last
    std::optional<Latest<StopStateSample>> stop;
    std::optional<Latest<StopCommandSample>> stopCommand;  ///< newest that a station sent to it
    std::optional<Latest<ClockOffsetSample>> clockOffset;
    std::optional<Latest<RobotPlaceSample>> place;  ///< of robots that another one's map was made for
    std::map<std::string, StreamState> streams;     ///< by topic
};

}  // namespace leitstand
