#include "tests/robots/control/test_ground.h"

#include <cmath>
#include <numbers>
#include <stdexcept>

#include "core/event/cloud_sample.h"
#include "robots/control/fuzzy/fuzzy_file.h"
#include "tests/support/places.h"

namespace leitstand::test {
namespace {

constexpr double Step = 0.05, Turn = 2.3;
constexpr int RawScans = 180;
const Pose Scanner = poseFrom({0.1, 0.0, 0.5}, 0.0, 0.0, 0.0);

VirtualScanSettings scanSettings() {
    VirtualScanSettings settings;
    settings.body = TestGround::body();
    return settings;
}

double distanceToObstacle(const Obstacle& one, const Eigen::Vector2d& place) {
    const Eigen::Vector2d along = one.b - one.a;
    const double length = along.squaredNorm();
    const double share = length > 0.0 ? std::clamp((place - one.a).dot(along) / length, 0.0, 1.0) : 0.0;
    return (place - one.a - share * along).norm() - one.radius;
}

Eigen::Vector2d flat(const Eigen::Vector3d& point) {
    return point.head<2>();
}

}  // namespace

TestGround::TestGround(std::vector<Obstacle> things, unsigned seed)
    : obstacles(std::move(things)), m_scan(scanSettings()), m_random(seed) {}

void TestGround::place(double x, double y, double yaw) {
    m_true = poseFrom({x, y, 0.0}, 0.0, 0.0, yaw);
}

Time TestGround::now() const {
    return Time(std::chrono::seconds(1000) + std::chrono::milliseconds(50 * m_steps));
}

double TestGround::distance(const Eigen::Vector2d& place) const {
    double nearest = 1e9;
    for (const Obstacle& one : obstacles) nearest = std::min(nearest, distanceToObstacle(one, place));
    return nearest;
}

std::pair<double, int> TestGround::cast(const Eigen::Vector2d& from, double direction) const {
    const Eigen::Vector2d towards(std::cos(direction), std::sin(direction));
    for (double range = 0.0; range < 30.0;) {  // by steps as long as what is surely free
        double nearest = 1e9;
        int number = -1;
        for (std::size_t i = 0; i < obstacles.size(); ++i) {
            const double away = distanceToObstacle(obstacles[i], from + range * towards);
            if (away >= nearest) continue;
            nearest = away;
            number = static_cast<int>(i);
        }
        if (nearest < 0.002) return {range, number};
        range += nearest;
    }
    return {30.0, -1};
}

double TestGround::fromFront(int number) const {
    double nearest = 1e9;
    for (int i = 0; i <= 20; ++i) {
        const double y = body().left * (0.1 * i - 1.0);
        const Eigen::Vector2d edge = flat(m_true * Eigen::Vector3d(body().front, y, 0.0));
        nearest = std::min(nearest, distanceToObstacle(obstacles[static_cast<std::size_t>(number)], edge));
    }
    return nearest;
}

bool TestGround::touches(const Pose& pose) const {
    for (int i = 0; i < 40; ++i) {  // places around the outline
        const double share = 0.1 * (i % 10), front = body().front, left = body().left;
        Eigen::Vector2d edge;
        if (i < 10)
            edge = {front, left * (2.0 * share - 1.0)};
        else if (i < 20)
            edge = {-front, left * (2.0 * share - 1.0)};
        else if (i < 30)
            edge = {front * (2.0 * share - 1.0), left};
        else
            edge = {front * (2.0 * share - 1.0), -left};
        if (distance(flat(pose * Eigen::Vector3d(edge.x(), edge.y(), 0.0))) < 0.0) return true;
    }
    return false;
}

void TestGround::step(const DriveVelocity& command) {
    std::normal_distribution<double> slip(0.03, 0.02), drift(0.0, 0.003);
    const Eigen::Vector2d most(1.5 * Step, 5.0 * Step);
    const Eigen::Vector2d wanted(command.forward, command.turn);
    m_speed += (wanted - m_speed).cwiseMax(-most).cwiseMin(most);
    const auto moved = [](const Pose& pose, double forward, double turn) {
        return Pose(pose * poseFrom({forward * std::cos(0.5 * turn), forward * std::sin(0.5 * turn), 0.0},
                                    0.0, 0.0, turn));
    };
    const Pose next = moved(m_true, m_speed.x() * (1.0 - slip(m_random)) * Step, m_speed.y() * 0.95 * Step);
    const bool touching = touches(next);
    if (touching && !m_touching) ++m_touches;
    m_touching = touching;
    const Pose motion = touching ? Pose::Identity() : Pose(m_true.inverse() * next);
    if (!touching) m_true = next;
    // The gyro tells the turn nearly right, the wheels do not see the slip.
    const double yaw = std::atan2(motion(1, 0), motion(0, 0));
    m_odom.push_back(moved(m_odom.back(), motion.translation().x() * 1.03, yaw * (1.0 + drift(m_random))));
    ++m_steps;
    if (scannerRuns) scan();
}

void TestGround::scan() {
    std::normal_distribution<double> noise(0.0, 0.012);
    rays.clear();
    CloudSample cloud;
    cloud.header.stamp = now();
    const double turned = seconds() / Turn * RawScans;
    for (int k = static_cast<int>(std::ceil(turned - Step / Turn * RawScans)); k < turned; ++k) {
        const double heading = k * 2.0 * std::numbers::pi / RawScans;
        const Pose scanner = m_true * Scanner;
        const double yaw = std::atan2(scanner(1, 0), scanner(0, 0)) + heading;
        const auto [range, number] = cast(flat(scanner.translation()), yaw);
        const Eigen::Vector2d end =
            flat(scanner.translation()) + range * Eigen::Vector2d(std::cos(yaw), std::sin(yaw));
        rays.emplace_back(end.x(), end.y(), range);
        const double top = number >= 0 ? obstacles[static_cast<std::size_t>(number)].height : 0.0;
        for (int up = -70; up <= 44; up += 2) {
            const double slope = std::tan(degrees(up));
            const double floor = up < 0 ? -Scanner.translation().z() / slope : 1e9;
            double away = std::min(range, floor);
            if (away == range && Scanner.translation().z() + range * slope > top) away = floor;
            away = away > 25.0 ? std::nan("") : away + noise(m_random) * std::cos(degrees(up));
            cloud.points.push_back(
                Eigen::Vector3d(away * std::cos(heading), away * std::sin(heading), away * slope)
                    .cast<float>());
        }
        ++cloud.rows;
    }
    if (cloud.rows == 0) return;
    cloud.columns = static_cast<int>(cloud.points.size()) / cloud.rows;
    m_scan.add(cloud, Scanner, [this](Time) { return std::optional<Pose>(baseInOdom()); });
}

std::vector<Obstacle> maze(const std::vector<std::string>& lines, double cell) {
    std::vector<Obstacle> walls;
    const auto rows = static_cast<int>(lines.size());
    for (int row = 0; row < rows; ++row) {
        const std::string& line = lines[static_cast<std::size_t>(row)];
        for (int column = 0; column < static_cast<int>(line.size()); ++column) {
            const double x = 0.5 * cell * column, y = 0.5 * cell * (rows - 1 - row);
            if (line[static_cast<std::size_t>(column)] == '-')
                walls.push_back({{x - 0.5 * cell, y}, {x + 0.5 * cell, y}});
            if (line[static_cast<std::size_t>(column)] == '|')
                walls.push_back({{x, y - 0.5 * cell}, {x, y + 0.5 * cell}});
        }
    }
    return walls;
}

FuzzyDrive shippedDrive() {
    auto system = readFuzzySystem(sourceFolder() + "/resources/control/fuzzy_drive.yaml");
    if (!system) throw std::runtime_error(system.error().text);
    FuzzyDriveSettings settings;
    settings.safety.body = TestGround::body();
    auto drive = FuzzyDrive::create(*system, settings);
    if (!drive) throw std::runtime_error(drive.error().text);
    return *drive;
}

}  // namespace leitstand::test
