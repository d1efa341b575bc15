#pragma once

#include <optional>
#include <random>
#include <string>
#include <vector>

#include "core/perception/surroundings/virtual_scan.h"
#include "robots/control/driving/fuzzy_drive.h"

namespace leitstand::test {

/// A wall seen from above, or a round thing (a == b).
struct Obstacle {
    Eigen::Vector2d a, b;
    double radius = 0.02;  ///< half the thickness [m]
    double height = 1.2;   ///< [m]
};

/// Flat ground with obstacles, and a robot with a turning scanner on it that moves as it is told, nearly.
class TestGround {
public:
    explicit TestGround(std::vector<Obstacle> obstacles, unsigned seed = 1);

    void place(double x, double y, double yaw);
    /// Moves on by 50 ms with @p command, with slip; the scanner measures.
    void step(const DriveVelocity& command);

    [[nodiscard]] Time now() const;
    [[nodiscard]] double seconds() const { return 0.05 * static_cast<double>(m_steps); }
    [[nodiscard]] const Pose& baseInOdom() const { return m_odom.back(); }
    [[nodiscard]] const Pose& baseInGround() const { return m_true; }
    [[nodiscard]] VirtualScanView view() const { return m_scan.view(baseInOdom(), now()); }
    [[nodiscard]] std::optional<Time> newest() const { return m_scan.newest(); }
    [[nodiscard]] int touches() const { return m_touches; }
    /// Distance of the nearest surface from @p place [m].
    [[nodiscard]] double distance(const Eigen::Vector2d& place) const;
    /// Along a ray until the first obstacle, at most 30 m, and its number.
    [[nodiscard]] std::pair<double, int> cast(const Eigen::Vector2d& from, double direction) const;
    /// From the front edge of the robot to obstacle @p number [m].
    [[nodiscard]] double fromFront(int number) const;
    [[nodiscard]] static BodyBox body() { return {0.225, 0.225, 0.165, 0.165}; }

    std::vector<Obstacle> obstacles;
    bool scannerRuns = true;
    std::vector<Eigen::Vector3d> rays;  ///< of the last step: x, y of the end, in the ground

private:
    void scan();
    [[nodiscard]] bool touches(const Pose& pose) const;

    Pose m_true = Pose::Identity();
    std::vector<Pose> m_odom = {Pose::Identity()};  ///< one a step
    Eigen::Vector2d m_speed = Eigen::Vector2d::Zero();
    VirtualScan m_scan;
    std::mt19937 m_random;
    std::int64_t m_steps = 0;
    int m_touches = 0;
    bool m_touching = false;
};

/// Walls drawn with "+", "-" and "|" around cells of @p cell metres; the first line is the northernmost.
[[nodiscard]] std::vector<Obstacle> maze(const std::vector<std::string>& lines, double cell);

/// The rules that are shipped.
[[nodiscard]] FuzzyDrive shippedDrive();

}  // namespace leitstand::test
