#include "robots/crawler/crawler_agent.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <string_view>

#include <fmt/format.h>

#include "core/base/time.h"
#include "core/event/motion_samples.h"
#include "core/event/stream_role.h"
#include "core/robot/robot_format.h"

namespace leitstand {
namespace {

/// Names of bumpers begin with these; in the order of BodySide.
constexpr std::array<std::string_view, 4> Bumpers = {"front", "left", "rear", "right"};

bool isOwn(Driver driver) {
    return driver == Driver::Explorer || driver == Driver::Returner;
}

/// Returns places on the outside of @p side of @p body, where what it ran into stands; base_link [m].
std::array<Eigen::Vector2d, 3> placesBeside(const BodyBox& body, BodySide side) {
    constexpr double Out = 0.04, Share = 0.8;
    const double front = body.front + Out, back = -body.back - Out, left = body.left + Out,
                 right = -body.right - Out;
    const auto across = [&](double x) {
        return std::array<Eigen::Vector2d, 3>{{{x, -Share * body.right}, {x, 0.0}, {x, Share * body.left}}};
    };
    const auto along = [&](double y) {
        return std::array<Eigen::Vector2d, 3>{{{-0.4 * body.back, y}, {0.0, y}, {0.4 * body.front, y}}};
    };
    switch (side) {
        case BodySide::Left:
            return along(left);
        case BodySide::Rear:
            return across(back);
        case BodySide::Right:
            return along(right);
        case BodySide::Front:
            break;
    }
    return across(front);
}

}  // namespace

CrawlerSettings::CrawlerSettings() {
    agent.geometry = {.trackWidth = 0.20 / 0.7, .maxSpeed = 0.6};  // turns slip by 30 %
    agent.motors.fullSpeed = 0.7;
    agent.motors.proportional = 7.0;
    agent.motors.integral = 60.0;
    agent.modes = {DriveMode::Teleoperation, DriveMode::SafeTeleoperation, DriveMode::Explore};
    agent.hasRemote = true;
    driving.drive.speed = 0.3;
    // Others stick out below what it sees of them. It sees nothing behind it, but remembers.
    driving.drive.safety.margin = 0.08;
    driving.drive.safety.creep = 0.15;
    driving.drive.safety.freshAge = 6.0;
    driving.drive.safety.oldAge = 12.0;
    driving.explorer.lookFirst = 1.0;
    driving.explorer.blindAfter = 1.5;
    driving.explorer.turnCost = 2.0;
    driving.explorer.memory.around = 0.5;
}

Result<std::unique_ptr<CrawlerAgent>> CrawlerAgent::create(RobotHardware& hardware,
                                                           const RobotDescription& robot,
                                                           const FuzzySystem& fuzzy,
                                                           const CrawlerSettings& settings) {
    const auto drive = driveFor(robot, fuzzy, settings.driving);
    if (!drive) return drive.error();
    return std::unique_ptr<CrawlerAgent>(new CrawlerAgent(hardware, robot, *drive, settings));
}

CrawlerAgent::CrawlerAgent(RobotHardware& hardware, const RobotDescription& robot, const FuzzyDrive& drive,
                           const CrawlerSettings& settings)
    : SelfDrivingAgent(hardware, robot, drive, settings.agent, settings.driving),
      m_settings(settings),
      m_evasion(settings.evasion) {}

void CrawlerAgent::sense(HardwareSample& sample) {
    SelfDrivingAgent::sense(sample);
    if (const auto* imu = sample.sample.as<ImuSample>()) feel(*imu);
    if (const auto* bumps = sample.sample.as<BumpSample>()) feel(*bumps);
    if (auto* diagnostics = sample.sample.edit<DiagnosticsSample>())
        diagnostics->statuses.push_back(warning());
}

void CrawlerAgent::feel(const BumpSample& bumps) {
    for (const Bumper& bumper : bumps.bumpers) {
        const auto named = std::find_if(Bumpers.begin(), Bumpers.end(),
                                        [&](std::string_view side) { return bumper.name.starts_with(side); });
        if (named == Bumpers.end()) continue;
        const auto side = static_cast<std::size_t>(named - Bumpers.begin());
        if (bumper.hits > m_hits[side] && isOwn(driver())) m_evasion.bumped(static_cast<BodySide>(side));
        m_hits[side] = bumper.hits;
    }
}

void CrawlerAgent::consider(VirtualScanView& view, const Pose& here, Time now) {
    constexpr int Edge = 6;  // sectors
    view.bridgeEdges(Edge);
    if (isOwn(driver())) m_felts.addTo(view, here, now);
}

DriveVelocity CrawlerAgent::think(const ModeDecision& decision, const Pose& here, Time now) {
    if (!isOwn(decision.driver)) {
        m_evasion.reset();
        return SelfDrivingAgent::think(decision, here, now);
    }
    if (m_danger == DiagnosticStatus::Level::Error) {
        reported().failed = true;
        reported().text = robot_format::RolledOverStands;
        return {};
    }
    const EvasionStep away = m_evasion.step(velocity(), here, now);
    if (away.felt) remember(away, here, now);
    if (!away.velocity && !away.failed) return SelfDrivingAgent::think(decision, here, now);
    explorer().see(view(), here, now);
    reported().failed = away.failed;
    reported().text = away.reason;
    if (away.failed) return {};
    return safeVelocity(*away.velocity, view(), safety()).velocity;
}

void CrawlerAgent::remember(const EvasionStep& felt, const Pose& here, Time now) {
    constexpr double Explains = 0.12;  ///< a visible obstacle so near a touched place explains it [m]
    const auto places = placesBeside(safety().body, *felt.felt);
    const bool inSight =
        std::any_of(view().obstacles.begin(), view().obstacles.end(), [&](const VirtualObstacle& obstacle) {
            return std::any_of(places.begin(), places.end(), [&](const Eigen::Vector2d& place) {
                return (place - obstacle.where).norm() < Explains;
            });
        });
    if (felt.touched && inSight) return;
    for (const Eigen::Vector2d& place : places) m_felts.add(place, here, now);
}

double CrawlerAgent::caution() const {
    return m_evasion.isActive() ? 1.0 : m_evasion.caution();
}

void CrawlerAgent::feel(const ImuSample& imu) {
    const Eigen::Vector3d rate = imu.angularVelocity.value_or(Eigen::Vector3d::Zero());
    if (imu.orientation) {
        const Eigen::Matrix3d level = imu.orientation->toRotationMatrix();
        m_roll = std::atan2(level(2, 1), level(2, 2));
        m_pitch = std::asin(std::clamp(-level(2, 0), -1.0, 1.0));
    } else if (m_felt) {
        const double seconds = toSeconds(imu.header.stamp - *m_felt);
        m_roll += rate.x() * seconds;
        m_pitch += rate.y() * seconds;
    }
    m_felt = imu.header.stamp;
    m_evasion.lean(lean(Eigen::Vector3d::Zero()));
    const DiagnosticStatus::Level now = danger(rate);
    if (now == m_danger) return;
    m_danger = now;
    publish(StreamRole::Diagnostics, DiagnosticsSample{header(), {warning()}});
}

/// Returns how far it leans, or will soon when turning at @p rate [rad/s], as a share of the tip-over limit.
double CrawlerAgent::lean(const Eigen::Vector3d& rate) const {
    const auto share = [this](double angle, double turning, double limit) {
        if (limit <= 0.0) return 0.0;
        return std::max(std::abs(angle), std::abs(angle + m_settings.lookAhead * turning)) / limit;
    };
    return std::max(share(m_roll, rate.x(), robot().maxRoll), share(m_pitch, rate.y(), robot().maxPitch));
}

DiagnosticStatus::Level CrawlerAgent::danger(const Eigen::Vector3d& rate) const {
    if (std::cos(m_roll) * std::cos(m_pitch) < std::cos(m_settings.lies))
        return DiagnosticStatus::Level::Error;
    // The warning ends later than it begins, so that it does not flicker.
    const double from = (m_danger == DiagnosticStatus::Level::Ok ? 1.0 : 0.85) * m_settings.warnFrom;
    return lean(rate) > from ? DiagnosticStatus::Level::Warning : DiagnosticStatus::Level::Ok;
}

DiagnosticStatus CrawlerAgent::warning() const {
    const StreamDescription* stream = robot().stream(StreamRole::Diagnostics);
    const auto inDegrees = [](double angle) { return fmt::format("{:.0f}", angle * 180 / std::numbers::pi); };
    DiagnosticStatus status;
    status.level = m_danger;
    status.name = robot_format::RollOver;
    status.message = m_danger == DiagnosticStatus::Level::Ok        ? robot_format::Upright
                     : m_danger == DiagnosticStatus::Level::Warning ? robot_format::AboutToRollOver
                                                                    : robot_format::RolledOver;
    status.hardwareId = stream != nullptr && !stream->hardwareId.empty() ? stream->hardwareId : robot().name;
    status.values = {{"roll", inDegrees(m_roll)}, {"pitch", inDegrees(m_pitch)}};
    return status;
}

}  // namespace leitstand
