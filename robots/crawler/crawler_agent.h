#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <optional>

#include "core/base/pose.h"
#include "robots/agent/self_driving_agent.h"
#include "robots/control/driving/evasion.h"
#include "robots/control/driving/felt_obstacles.h"

namespace leitstand {

struct ImuSample;

/// How the Crawler drives and how it warns before it rolls over.
struct CrawlerSettings {
    CrawlerSettings();  ///< sets the values of the real robot

    AgentSettings agent;
    /// It drives by a plane laser, which sees neither low things nor what is behind.
    SelfDrivingSettings driving;
    EvasionSettings evasion;
    double warnFrom = 0.7;      ///< share of the tip-over limits at which it warns
    double lies = degrees(65);  ///< with this tilt it lies on its side or back [rad]
    double lookAhead = 0.5;     ///< turn rates of the gyro are extrapolated for this time [s]
};

/// Drives the Crawler: chains, radio remote, warning before it rolls over (paper, section 3). Also drives by
/// itself as Kurt3D does, by its plane laser and by what it feels. One thread.
class CrawlerAgent final : public SelfDrivingAgent {
public:
    /// @p fuzzy: rules in resources/control/fuzzy_drive.yaml. Errors are those of FuzzyDrive::create().
    [[nodiscard]] static Result<std::unique_ptr<CrawlerAgent>> create(RobotHardware& hardware,
                                                                      const RobotDescription& robot,
                                                                      const FuzzySystem& fuzzy,
                                                                      const CrawlerSettings& settings = {});

private:
    CrawlerAgent(RobotHardware& hardware, const RobotDescription& robot, const FuzzyDrive& drive,
                 const CrawlerSettings& settings);
    void sense(HardwareSample& sample) override;
    void consider(VirtualScanView& view, const Pose& here, Time now) override;
    DriveVelocity think(const ModeDecision& decision, const Pose& here, Time now) override;
    [[nodiscard]] double caution() const override;

    void feel(const ImuSample& imu);
    void feel(const BumpSample& bumps);
    void remember(const EvasionStep& felt, const Pose& here, Time now);
    [[nodiscard]] double lean(const Eigen::Vector3d& rate) const;
    [[nodiscard]] DiagnosticStatus::Level danger(const Eigen::Vector3d& rate) const;
    [[nodiscard]] DiagnosticStatus warning() const;

    CrawlerSettings m_settings;
    Evasion m_evasion;
    FeltObstacles m_felts;
    std::array<std::uint32_t, 4> m_hits{};  ///< number of hits of the bumpers on each BodySide
    double m_roll = 0.0, m_pitch = 0.0;     ///< [rad]
    std::optional<Time> m_felt;
    DiagnosticStatus::Level m_danger = DiagnosticStatus::Level::Ok;
};

}  // namespace leitstand
