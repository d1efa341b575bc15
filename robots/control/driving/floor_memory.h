#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <unordered_map>
#include <unordered_set>
#include <utility>
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
/// right, so that the odometry's drift does no lasting harm. Storeys lie above each other: at a place from
/// above there are as many cells as there are floors (multi-level surface maps, Triebel, Pfaff & Burgard
/// 2006), told apart by their height; which floor is ahead is told by how the robot stands. Places are in
/// odom, on or near the floor that is meant [m].
class FloorMemory {
public:
    explicit FloorMemory(const FloorMemorySettings& settings = {});

    /// Whether floors at two heights are of one storey [m].
    [[nodiscard]] static bool isSameFloor(double one, double other);

    void see(const VirtualScanView& view, const Pose& baseInOdom);
    /// What could not be reached is not tried again.
    void giveUp(const Eigen::Vector3d& place, double radius);
    /// Ways keep off the ground about @p place, where there is another.
    void shun(const Eigen::Vector3d& place, double radius);
    /// Obstacles about @p place, and those on floor that was seen free once, are looked for anew: the drift
    /// of odometry closes ways. What was given up is tried again.
    void doubt(const Eigen::Vector3d& place, double radius);
    void clear();

    /// What the first step of a way costs more when the robot has to turn for it.
    struct Turning {
        double heading = 0.0;  ///< of the robot, in odom [rad]
        double cost = 0.0;     ///< as so long a way, for half a turn [m]
    };
    /// The way from @p from over seen floor to the nearest border of the unseen. Empty: none.
    [[nodiscard]] std::vector<Eigen::Vector3d> wayToUnseen(const Eigen::Vector3d& from,
                                                           const Turning& turning) const;
    [[nodiscard]] std::vector<Eigen::Vector3d> wayToUnseen(const Eigen::Vector3d& from) const {
        return wayToUnseen(from, {});
    }
    /// The way to @p goal, or within @p near of it when it cannot be reached itself [m]; over unseen floor
    /// too. Empty: none.
    [[nodiscard]] std::vector<Eigen::Vector3d> wayTo(const Eigen::Vector3d& from, const Eigen::Vector3d& goal,
                                                     double near = 0.5) const;
    /// Whether the border of the unseen is still at @p place.
    [[nodiscard]] bool isBorderNear(const Eigen::Vector3d& place) const;
    /// Whether the robot's middle may go straight from @p from to @p to.
    [[nodiscard]] bool isFreeBetween(const Eigen::Vector3d& from, const Eigen::Vector3d& to) const;
    [[nodiscard]] bool isSeen(const Eigen::Vector3d& place) const;
    [[nodiscard]] bool isBlocked(const Eigen::Vector3d& place) const;
    [[nodiscard]] int visits(const Eigen::Vector3d& place) const;  ///< how often the robot came there
    [[nodiscard]] double seenArea() const;                         ///< [m2]

private:
    struct Cell {
        bool seen = false, givenUp = false, shunned = false;
        std::int8_t evidence = 0;  ///< of an obstacle: above 0 it is blocked
        std::uint16_t visits = 0;
        std::uint16_t near = 0;   ///< blocked cells within the clearance
        std::uint16_t close = 0;  ///< blocked cells within the comfort
        float height = 0.0F;      ///< as it was seen last [m]
    };
    /// A square from above, and which of the floors there.
    using Key = std::int64_t;
    struct Place {
        Key key;
        const Cell* cell;  ///< null: nothing is known of it
    };
    [[nodiscard]] Key squareOf(const Eigen::Vector2d& place) const;
    [[nodiscard]] Eigen::Vector2d middleOf(Key key) const;
    /// The floor of @p square at @p height.
    [[nodiscard]] Place find(Key square, double height) const;
    [[nodiscard]] Place find(const Eigen::Vector3d& place) const {
        return find(squareOf(place.head<2>()), place.z());
    }
    /// ... remembered from now on; the cell is valid until the next one.
    [[nodiscard]] std::pair<Key, Cell*> at(Key square, double height);
    [[nodiscard]] std::vector<Key> squaresAround(const Eigen::Vector2d& place, double radius) const;
    [[nodiscard]] static double weightOf(const Cell* cell, bool tight);
    void addEvidence(Key square, double height, int evidence);
    void seeAlong(const Eigen::Vector3d& from, const Eigen::Vector3d& to,
                  const std::unordered_set<Key>& held);
    [[nodiscard]] bool isBorder(const Place& place) const;
    struct Goal {
        std::function<bool(const Place& place, double height)> reached;
        std::optional<double> unseen;  ///< over unseen floor as well, so far away [m]
    };
    /// Dijkstra's cheapest way from @p from to the first cell that is a goal.
    [[nodiscard]] std::vector<Eigen::Vector3d> search(const Eigen::Vector3d& from, const Goal& goal,
                                                      const Turning& turning) const;

    FloorMemorySettings m_settings;
    std::unordered_map<Key, Cell> m_cells;
    std::vector<Eigen::Vector2i> m_disc;  ///< squares within the comfort
    std::optional<Key> m_here;
};

}  // namespace leitstand
