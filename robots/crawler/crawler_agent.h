#pragma once

#include <optional>

#include "core/base/pose.h"
#include "robots/agent/robot_agent.h"

namespace leitstand {

/// How the Crawler warns of rolling over.
struct CrawlerSettings {
    AgentSettings agent = {.geometry = {.trackWidth = 0.20 / 0.7, .maxSpeed = 0.6},  // turns slip by 30 %
                           .motors = {.fullSpeed = 0.7, .proportional = 7.0, .integral = 60.0},
                           .modes = {DriveMode::Teleoperation},
                           .hasRemote = true};
    double warnFrom = 0.7;      ///< share of the tip-over limits
    double lies = degrees(65);  ///< tilted so far, it lies on its side or back [rad]
    double lookAhead = 0.5;     ///< turn rates of the gyro are carried on for so long [s]
};

/// What drives the Crawler: chains, radio remote, warning of rolling over (paper, section 3). One thread.
class CrawlerAgent final : public RobotAgent {
public:
    CrawlerAgent(RobotHardware& hardware, const RobotDescription& robot,
                 const CrawlerSettings& settings = {});

private:
    void sense(HardwareSample& sample) override;
    void feel(const ImuSample& imu);
    [[nodiscard]] DiagnosticStatus::Level danger(const Eigen::Vector3d& rate) const;
    [[nodiscard]] DiagnosticStatus warning() const;

    CrawlerSettings m_settings;
    double m_roll = 0.0, m_pitch = 0.0;  ///< [rad]
    std::optional<Time> m_felt;
    DiagnosticStatus::Level m_danger = DiagnosticStatus::Level::Ok;
};

}  // namespace leitstand
