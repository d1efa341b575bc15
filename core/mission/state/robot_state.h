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
struct DetectionsSample;
struct DiagnosticsSample;
struct GasSample;
struct ImuSample;
struct MarkerBoard;
struct ModeSample;
struct OccupancyGridSample;
struct OdometrySample;
struct PathSample;
struct ReadingSample;
struct RobotModelSample;
struct RobotPlaceSample;
struct SightingSample;
struct StopCommandSample;
struct StopStateSample;
enum class StreamRole : std::uint8_t;

/// The number of events on a topic, and facts about the newest one.
struct StreamState {
    std::optional<StreamRole> role;  ///< empty for the station's own topics
    std::string sensor;              ///< StreamDescription::sensor
    std::uint64_t events = 0;
    std::uint64_t sequence = 0;  ///< sequence of the newest event
    Time received{};             ///< when the newest event was received, station's clock
    Time stamp{};                ///< stamp of the newest sample, sender's clock; epoch if it has no stamp
};

/// A sample and its place in the mission.
template <class T>
struct Latest {
    std::uint64_t sequence = 0;
    Time received{};  ///< when it was received, station's clock
    T sample;
};
/// The newest sample; null: none was received. Code that reads the sample includes the sample's header.
template <class T>
using LatestPtr = std::shared_ptr<const Latest<T>>;
template <class T>
[[nodiscard]] LatestPtr<T> latestPtr(Latest<T> latest) {
    return std::make_shared<const Latest<T>>(std::move(latest));
}

/// A hit that a robot's bumpers counted.
struct Contact {
    std::uint64_t sequence = 0;  ///< sequence of the event that reported it
    Time received{};             ///< when it was received, station's clock
    std::string bumper;
    std::uint32_t hits = 1;            ///< counted since the previous contact
    std::optional<Pose> baseInOdom{};  ///< from the newest odometry at that time
};

/// Mean current of a battery over the last minute.
struct BatteryLoad {
    double current = Unknown;  ///< negative: the battery discharges [A]
    double seconds = 0.0;      ///< time that the mean covers [s]

    /// Times that the mean covers: at first, and at most [s].
    static constexpr double AtFirst = 5.0, Longest = 60.0;
};

/// Where a frame lies in its parent.
struct FrameInParent {
    std::string parent;
    Pose inParent = Pose::Identity();
};

/// The newest samples of a robot. Scans and pictures are not kept; StreamState says which event has the
/// newest.
struct RobotState {
    LatestPtr<OdometrySample> odometry;  ///< without its covariances
    LatestPtr<ImuSample> imu;            ///< without its covariances
    LatestPtr<ModeSample> mode;
    LatestPtr<BatterySample> battery;
    BatteryLoad load;  ///< load of the battery above
    LatestPtr<GasSample> gas;
    LatestPtr<BumpSample> bumps;
    std::vector<Contact> contacts;  ///< all hits of the mission, oldest first; at most MostContacts
    LatestPtr<SightingSample> sightings;
    /// Newest status of each part; the part that was updated last is the last one.
    LatestPtr<DiagnosticsSample> diagnostics;
    LatestPtr<StopStateSample> stop;
    LatestPtr<StopCommandSample> stopCommand;  ///< newest stop that a station sent to it
    LatestPtr<ClockOffsetSample> clockOffset;
    LatestPtr<RobotPlaceSample> place;           ///< of robots that were placed in another robot's map
    std::map<std::string, StreamState> streams;  ///< by topic
    /// The frames above that of the odometry, as its localisation knows them: of each but the highest, where
    /// it lies in its parent. At most MostFramesAbove.
    std::map<std::string, FrameInParent> framesAbove;
    std::map<std::string, LatestPtr<OccupancyGridSample>> grids;  ///< by topic, with their updates
    std::map<std::string, LatestPtr<PathSample>> paths;           ///< by topic
    std::map<std::string, LatestPtr<ReadingSample>> readings;     ///< by topic
    std::map<std::string, LatestPtr<MarkerBoard>> markers;        ///< by topic
    LatestPtr<RobotModelSample> model;
    std::map<std::string, LatestPtr<DetectionsSample>> detections;  ///< by topic

    static constexpr std::size_t MostContacts = 10'000;
    static constexpr std::size_t MostFramesAbove = 8;
};

}  // namespace leitstand
