#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/mapping/live/live_map.h"
#include "core/mapping/live/live_scan.h"
#include "core/mapping/live/live_settings.h"
#include "core/registration/icp.h"
#include "core/robot/samples/map_samples.h"

namespace leitstand {

/// Where a robot is in the map, as its newest scan tells.
struct Localisation {
    std::string robot;
    Time stamp{};                        ///< end of the scan, robot's clock
    Pose baseInMap = Pose::Identity();   ///< then
    Pose guessInMap = Pose::Identity();  ///< of base_link, by odometry alone since the scan before
    Pose odomInMap = Pose::Identity();   ///< where odometry's poses lie in the map from then on
    ScanTrust trust = ScanTrust::Certain;
    std::uint8_t doubts = 0;    ///< bits of ScanDoubt
    std::uint64_t keyScan = 0;  ///< the scan's id where it entered the map; 0: it only localised
    IcpResult icp;              ///< meaningless for the first scan
    double seconds = 0.0;       ///< of computing [s]
};

/// What came of a scan or of a decision: what the log keeps, in this order.
struct MapUpdate {
    std::optional<KeyScanSample> keyScan;
    std::optional<ScanPosesSample> poses;
    std::optional<Localisation> localisation;
};

/// Registers scans of robots while they drive into one map that is level: each against the key scans near it.
/// Results are samples for the log, from which the same map comes about again (restore(), follow()). Without
/// clock and thread: the caller tells what time it is, on the station's clock. One thread at a time.
class LiveMapper {
public:
    LiveMapper(std::string station, LiveSettings settings);
    ~LiveMapper();
    LiveMapper(LiveMapper&&) noexcept;
    LiveMapper& operator=(LiveMapper&&) noexcept;

    /// What a robot's scans are cleaned of.
    void setBody(const std::string& robot, RobotBody body);
    void setCrop(MapCrop crop);  ///< from the next scan on

    /// Registers @p scan.
    [[nodiscard]] MapUpdate add(const LiveScan& scan, Time now);

    /// A snapshot.
    [[nodiscard]] LiveMapPtr map() const;

private:
    struct State;
    std::unique_ptr<State> m_state;
};

}  // namespace leitstand
