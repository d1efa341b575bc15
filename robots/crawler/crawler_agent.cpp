#include "robots/crawler/crawler_agent.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <numbers>
#include <variant>

#include <fmt/format.h>

#include "core/robot/robot_says.h"

namespace leitstand {

CrawlerAgent::CrawlerAgent(RobotHardware& hardware, const RobotDescription& robot,
                           const CrawlerSettings& settings)
    : RobotAgent(hardware, robot, settings.agent), m_settings(settings) {}

void CrawlerAgent::sense(HardwareSample& sample) {
    if (const auto* imu = std::get_if<ImuSample>(&sample.sample)) feel(*imu);
    if (auto* diagnostics = std::get_if<DiagnosticsSample>(&sample.sample))
        diagnostics->statuses.push_back(warning());
}

void CrawlerAgent::feel(const ImuSample& imu) {
    const Eigen::Vector3d rate = imu.angularVelocity.value_or(Eigen::Vector3d::Zero());
    if (imu.orientation) {
        const Eigen::Matrix3d level = imu.orientation->toRotationMatrix();
        m_roll = std::atan2(level(2, 1), level(2, 2));
        m_pitch = std::asin(std::clamp(-level(2, 0), -1.0, 1.0));
    } else if (m_felt) {
        const double seconds = std::chrono::duration<double>(imu.header.stamp - *m_felt).count();
        m_roll += rate.x() * seconds;
        m_pitch += rate.y() * seconds;
    }
    m_felt = imu.header.stamp;
    const DiagnosticStatus::Level now = danger(rate);
    if (now == m_danger) return;
    m_danger = now;
    say(StreamRole::Diagnostics, DiagnosticsSample{header(), {warning()}});
}

DiagnosticStatus::Level CrawlerAgent::danger(const Eigen::Vector3d& rate) const {
    if (std::cos(m_roll) * std::cos(m_pitch) < std::cos(m_settings.lies))
        return DiagnosticStatus::Level::Error;
    const auto share = [this](double angle, double turning, double limit) {
        if (limit <= 0.0) return 0.0;
        return std::max(std::abs(angle), std::abs(angle + m_settings.lookAhead * turning)) / limit;
    };
    const double nearest =
        std::max(share(m_roll, rate.x(), robot().maxRoll), share(m_pitch, rate.y(), robot().maxPitch));
    // Let go of later than it begins, so that it does not flicker.
    const double from = (m_danger == DiagnosticStatus::Level::Ok ? 1.0 : 0.85) * m_settings.warnFrom;
    return nearest > from ? DiagnosticStatus::Level::Warning : DiagnosticStatus::Level::Ok;
}

DiagnosticStatus CrawlerAgent::warning() const {
    const StreamDescription* stream = robot().stream(StreamRole::Diagnostics);
    const auto inDegrees = [](double angle) { return fmt::format("{:.0f}", angle * 180 / std::numbers::pi); };
    DiagnosticStatus status;
    status.level = m_danger;
    status.name = robot_says::RollOver;
    status.message = m_danger == DiagnosticStatus::Level::Ok        ? robot_says::Upright
                     : m_danger == DiagnosticStatus::Level::Warning ? robot_says::AboutToRollOver
                                                                    : robot_says::RolledOver;
    status.hardwareId = stream != nullptr && !stream->hardwareId.empty() ? stream->hardwareId : robot().name;
    status.values = {{"roll", inDegrees(m_roll)}, {"pitch", inDegrees(m_pitch)}};
    return status;
}

}  // namespace leitstand
