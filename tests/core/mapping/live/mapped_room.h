#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "core/mapping/live/live_mapper.h"
#include "core/mission/state/fold.h"
#include "tests/support/rooms.h"

namespace leitstand::test {

/// The scan of a turning scanner in the furnished room, as ScanCutter gives it; @p drift: of the odometry.
[[nodiscard]] LiveScan scanAt(const Pose& sensorInRoom, unsigned seed, const Pose& drift = Pose::Identity());

/// A mission that keeps what a mapper says, and can take back what was decided.
class MapLog {
public:
    /// Returns its sequence in the mission.
    std::uint64_t publish(Sample sample, std::string topic = "/leitstand/scan_poses");
    void publish(const MapUpdate& update);
    /// Takes back the event of @p sequence; the mapper follows.
    std::uint64_t undo(std::uint64_t sequence, LiveMapper& mapper);
    [[nodiscard]] std::vector<ScanPose> poses() const;  ///< as the mission has them now
    /// What a station that starts again makes of the log.
    [[nodiscard]] LiveMapper readAgain(const LiveSettings& settings = {}) const;

private:
    Fold m_fold;
    std::vector<KeyScanSample> m_keyScans;
    std::vector<ScanLinksSample> m_links;
    std::uint64_t m_sequence = 0;
};

/// A station that maps a room: scans get into the map and the log.
struct MappedRoom {
    explicit MappedRoom(LiveSettings settings = {}) : mapper("station", std::move(settings)) {}

    LiveMapper mapper;
    MapLog log;
    Time now = Time(std::chrono::seconds(5000));
    unsigned seed = 1;
    Pose last = Pose::Identity();  ///< sensor in room

    MapUpdate add(const Pose& sensorInRoom, const Pose& drift = Pose::Identity());
    MapUpdate add(const LiveScan& scan);
    /// Steps of 0.4 m along the room.
    void drive(int scans);
    /// Solves what is to be solved; what came of it is in the log.
    std::optional<ScanPosesSample> solveAll();
    /// Where the map has its key scans and how far they count.
    [[nodiscard]] std::vector<ScanPose> poses() const;
};

/// How far @p a and @p b differ in what counts: ids, trust; poses to within a millimetre.
[[nodiscard]] bool alike(const std::vector<ScanPose>& a, const std::vector<ScanPose>& b);

}  // namespace leitstand::test
