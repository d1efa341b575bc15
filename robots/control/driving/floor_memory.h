#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <unordered_map>
#include <unordered_set>
#include <vector>

#include <Eigen/Core>

#include "core/base/pose.h"
#include "core/perception/surroundings/virtual_scan_view.h"

namespace leitstand {

struct FloorMemorySettings {
    double cell = 0.12;       ///< [m]
    double sight = 3.0;       ///< floor is remembered as seen up to there [m]
    double clearance = 0.25;  ///< from obstacles, that the robot's middle needs: half its width at least [m]
    double comfort = 0.40;    ///< from obstacles, that it keeps where there is space [m]
    double around = 0.0;      ///< floor so near the robot counts as seen, where its scanner is blind [m]
    double maxAge = 0.5;      ///< of sectors that are entered: they were seen from about here [s]
};

/// Where a robot has been and what it has seen: a coarse grid in the odometry's frame. The newest view is
/// right, so that the odometry's drift does no lasting harm.
class FloorMemory {
public:
    explicit FloorMemory(const FloorMemorySettings& settings = {});

    void see(const VirtualScanView& view, const Pose& baseInOdom);
    /// What could not be reached is not tried again; in odom [m].
    void giveUp(const Eigen::Vector2d& place, double radius);
    /// Ways keep off the ground about @p place, where there is another; in odom [m].
    void shun(const Eigen::Vector2d& place, double radius);
    /// Obstacles about @p place, and those on floor that was seen free once, are looked for anew: the drift
    /// of odometry closes ways. What was given up is tried again.
    void doubt(const Eigen::Vector2d& place, double radius);
    void clear();

    /// What the first step of a way costs more when the robot has to turn for it.
    struct Turning {
        double heading = 0.0;  ///< of the robot, in odom [rad]
        double cost = 0.0;     ///< as so long a way, for half a turn [m]
    };
    /// The way from @p from over seen floor to the nearest border of the unseen; in odom [m]. Empty: none.
    [[nodiscard]] std::vector<Eigen::Vector2d> wayToUnseen(const Eigen::Vector2d& from,
                                                           const Turning& turning) const;
    [[nodiscard]] std::vector<Eigen::Vector2d> wayToUnseen(const Eigen::Vector2d& from) const {
        return wayToUnseen(from, {});
    }
    /// The way to @p goal, or within @p near of it when it cannot be reached itself [m]; over unseen floor
    /// too. Empty: none.
    [[nodiscard]] std::vector<Eigen::Vector2d> wayTo(const Eigen::Vector2d& from, const Eigen::Vector2d& goal,
                                                     double near = 0.5) const;
    /// Whether the border of the unseen is still at @p place.
    [[nodiscard]] bool isBorderNear(const Eigen::Vector2d& place) const;
    /// Whether the robot's middle may go straight from @p from to @p to.
    [[nodiscard]] bool isFreeBetween(const Eigen::Vector2d& from, const Eigen::Vector2d& to) const;
    [[nodiscard]] bool isSeen(const Eigen::Vector2d& place) const;
    [[nodiscard]] bool isBlocked(const Eigen::Vector2d& place) const;
    [[nodiscard]] int visits(const Eigen::Vector2d& place) const;  ///< how often the robot came there
    [[nodiscard]] double seenArea() const;                         ///< [m2]

private:
    struct Cell {
        bool seen = false, givenUp = false, shunned = false;
        std::int8_t evidence = 0;  ///< of an obstacle: above 0 it is blocked
        std::uint16_t visits = 0;
        std::uint16_t near = 0;   ///< blocked cells within the clearance
        std::uint16_t close = 0;  ///< blocked cells within the comfort
    };
    using Key = std::int64_t;
    [[nodiscard]] Key keyOf(const Eigen::Vector2d& place) const;
    [[nodiscard]] Eigen::Vector2d middleOf(Key key) const;
    [[nodiscard]] const Cell* find(Key key) const;
    [[nodiscard]] std::vector<Key> around(const Eigen::Vector2d& place, double radius) const;
    [[nodiscard]] static double weightOf(const Cell* cell, bool tight);
    void addEvidence(Key key, int evidence);
    void seeAlong(const Eigen::Vector2d& from, const Eigen::Vector2d& to,
                  const std::unordered_set<Key>& held);
    [[nodiscard]] bool isBorder(Key key) const;
    /// Dijkstra's cheapest way from @p from to the first cell that is a @p goal; over the unseen as well,
    /// when @p unseen says how far away [m].
    [[nodiscard]] std::vector<Eigen::Vector2d> search(const Eigen::Vector2d& from,
                                                      const std::function<bool(Key)>& goal,
                                                      std::optional<double> unseen,
                                                      const Turning& turning) const;

    FloorMemorySettings m_settings;
    std::unordered_map<Key, Cell> m_cells;
    std::vector<Eigen::Vector2i> m_disc;  ///< cells within the comfort
    std::optional<Key> m_here;
};

}  // namespace leitstand
