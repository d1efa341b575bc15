#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "core/base/pose.h"
#include "core/base/time.h"
#include "core/base/unknown.h"

namespace leitstand {

struct BatterySample;
struct BumpSample;
struct ClockOffsetSample;
struct DiagnosticsSample;
struct GasSample;
struct ImuSample;
struct ModeSample;
struct OdometrySample;
struct RobotPlaceSample;
struct SightingSample;
struct StopCommandSample;
struct StopStateSample;
enum class StreamRole : std::uint8_t;

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
/// The newest sample; null: none has come. Code that reads the sample includes the sample's header.
template <class T>
using LatestPtr = std::shared_ptr<const Latest<T>>;
template <class T>
[[nodiscard]] LatestPtr<T> latestPtr(Latest<T> latest) {
    return std::make_shared<const Latest<T>>(std::move(latest));
}

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
    double seconds = 0.0;      ///< time that the mean covers [s]

    static constexpr double AtFirst = 5.0, Longest = 60.0;  ///< [s]
};

/// Newest samples of a robot. Scans and pictures are not kept: StreamState holds where the newest is.
struct RobotState {
    LatestPtr<OdometrySample> odometry;  ///< without its covariances
    LatestPtr<ImuSample> imu;            ///< without its covariances
    LatestPtr<ModeSample> mode;
    LatestPtr<BatterySample> battery;
    BatteryLoad load;  ///< of that battery
    LatestPtr<GasSample> gas;
    LatestPtr<BumpSample> bumps;
    std::vector<Contact> contacts;  ///< all hits of the mission, oldest first; at most MostContacts
    LatestPtr<SightingSample> sightings;
    LatestPtr<DiagnosticsSample> diagnostics;  ///< newest status of each part, the latest updated part last
    LatestPtr<StopStateSample> stop;
    LatestPtr<StopCommandSample> stopCommand;  ///< newest that a station sent to it
    LatestPtr<ClockOffsetSample> clockOffset;
    LatestPtr<RobotPlaceSample> place;           ///< of robots placed in the map of another robot
    std::map<std::string, StreamState> streams;  ///< by topic

    static constexpr std::size_t MostContacts = 10'000;
};

}  // namespace leitstand
