#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "core/base/pose.h"
#include "core/base/time.h"
#include "core/event/command_samples.h"
#include "core/event/map_samples.h"
#include "core/event/motion_samples.h"
#include "core/event/station_samples.h"
#include "core/event/status_samples.h"
#include "core/robot/robot_description.h"

namespace leitstand {

/// Number of events on a topic, and the newest of them.
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

/// A hit that a robot's bumpers counted.
struct Contact {
    std::uint64_t sequence = 0;  ///< of the event that reported it
    Time received{};             ///< station's clock
    std::string bumper;
    std::uint32_t hits = 1;            ///< counted since the previous contact
    std::optional<Pose> baseInOdom{};  ///< by the newest odometry at that time
};

/// Mean current of a battery over the last minute.
struct BatteryLoad {
    double current = Unknown;  ///< negative: it discharges [A]
    double seconds = 0.0;      ///< that the mean covers

    static constexpr double AtFirst = 5.0, Longest = 60.0;  ///< [s]
};

/// Newest samples of a robot. Scans and pictures are not kept: StreamState holds where the newest is.
struct RobotState {
    std::optional<Latest<OdometrySample>> odometry;  ///< without its covariances
    std::optional<Latest<ImuSample>> imu;            ///< without its covariances
    std::optional<Latest<ModeSample>> mode;
    std::optional<Latest<BatterySample>> battery;
    BatteryLoad load;  ///< of that battery
    std::optional<Latest<GasSample>> gas;
    std::optional<Latest<BumpSample>> bumps;
    std::vector<Contact> contacts;  ///< all hits of the mission, oldest first; at most MostContacts
    std::optional<Latest<SightingSample>> sightings;
    std::optional<Latest<DiagnosticsSample>>
        diagnostics;  ///< newest of every part, by name; newest part last
    std::optional<Latest<StopStateSample>> stop;
    std::optional<Latest<StopCommandSample>> stopCommand;  ///< newest that a station sent to it
    std::optional<Latest<ClockOffsetSample>> clockOffset;
    std::optional<Latest<RobotPlaceSample>> place;  ///< of robots placed in the map of another robot
    std::map<std::string, StreamState> streams;     ///< by topic

    static constexpr std::size_t MostContacts = 10'000;
};

}  // namespace leitstand
