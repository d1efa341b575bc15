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
    double cell = 0.12;       ///< edge of a cell [m]
    double sight = 3.0;       ///< floor up to this distance is treated as seen [m]
    double clearance = 0.25;  ///< distance from the robot's middle to obstacles: at least half its width [m]
    double comfort = 0.40;    ///< distance that it keeps from obstacles if there is space [m]
    /// Floor this near to the robot is treated as seen, since its scanner is blind there [m].
    double around = 0.0;
    double maxAge = 0.5;  ///< oldest age of sectors in use [s]; older ones were seen from elsewhere
};

/// Where a robot has been and what it has seen: a coarse grid in the odometry's frame. The newest view
/// replaces older ones, so that the odometry's drift does no lasting harm. Storeys lie above each other: a
/// square has one cell for each floor, distinguished by height (multi-level surface maps, Triebel, Pfaff &
/// Burgard 2006). The robot's tilt decides which floor is ahead. Places are in odom [m]; their height selects
/// the floor.
class FloorMemory {
public:
    explicit FloorMemory(const FloorMemorySettings& settings = {});

    /// Returns whether floors at two heights [m] belong to the same storey.
    [[nodiscard]] static bool isSameFloor(double one, double other);

    void see(const VirtualScanView& view, const Pose& baseInOdom);
    /// Gives up the floor within @p radius of @p place, which could not be reached. It is not tried again
    /// until doubt().
    void giveUp(const Eigen::Vector3d& place, double radius);
    /// Makes ways avoid the floor within @p radius of @p place if there is another way.
    void shun(const Eigen::Vector3d& place, double radius);
    /// Forgets all obstacles within @p radius of @p place, and elsewhere those on floor that was once seen
    /// free: drift of odometry closes ways. Floor that was given up may be tried again.
    void doubt(const Eigen::Vector3d& place, double radius);
    void clear();

    /// Cost of the first step of a way if the robot has to turn for it.
    struct Turning {
        double heading = 0.0;  ///< the robot's heading in odom [rad]
        double cost = 0.0;     ///< cost of half a turn, as a distance [m]
    };
    /// Returns the way from @p from over seen floor to the nearest border of unseen floor. Empty: none.
    [[nodiscard]] std::vector<Eigen::Vector3d> wayToUnseen(const Eigen::Vector3d& from,
                                                           const Turning& turning) const;
    [[nodiscard]] std::vector<Eigen::Vector3d> wayToUnseen(const Eigen::Vector3d& from) const {
        return wayToUnseen(from, {});
    }
    /// Returns the way to @p goal, or to within @p near [m] of it if it cannot be reached itself. It may
    /// cross unseen floor. Empty: none.
    [[nodiscard]] std::vector<Eigen::Vector3d> wayTo(const Eigen::Vector3d& from, const Eigen::Vector3d& goal,
                                                     double near = 0.5) const;
    /// Returns whether there is still unseen floor next to @p place.
    [[nodiscard]] bool isBorderNear(const Eigen::Vector3d& place) const;
    /// Returns whether the robot's middle may move straight from @p from to @p to.
    [[nodiscard]] bool isFreeBetween(const Eigen::Vector3d& from, const Eigen::Vector3d& to) const;
    [[nodiscard]] bool isSeen(const Eigen::Vector3d& place) const;
    [[nodiscard]] bool isBlocked(const Eigen::Vector3d& place) const;
    /// Number of times that the robot came there.
    [[nodiscard]] int visits(const Eigen::Vector3d& place) const;
    [[nodiscard]] double seenArea() const;  ///< area of seen floor [m2]

private:
    struct Cell {
        bool seen = false, givenUp = false, shunned = false;
        std::int8_t evidence = 0;  ///< evidence of an obstacle; blocked above 0
        std::uint16_t visits = 0;
        std::uint16_t near = 0;   ///< number of blocked cells within the clearance
        std::uint16_t close = 0;  ///< number of blocked cells within the comfort distance
        float height = 0.0F;      ///< height when it was last seen [m]
    };
    /// A square seen from above, and the index of one of its floors.
    using Key = std::int64_t;
    struct Place {
        Key key;
        const Cell* cell;  ///< null: nothing is known there
    };
    [[nodiscard]] Key squareOf(const Eigen::Vector2d& place) const;
    [[nodiscard]] Eigen::Vector2d middleOf(Key key) const;
    /// Returns the floor of @p square nearest to @p height.
    [[nodiscard]] Place find(Key square, double height) const;
    [[nodiscard]] Place find(const Eigen::Vector3d& place) const {
        return find(squareOf(place.head<2>()), place.z());
    }
    /// Returns the floor of @p square at @p height. If there is none, adds a cell for it. The cell is valid
    /// until the next call.
    [[nodiscard]] std::pair<Key, Cell*> at(Key square, double height);
    [[nodiscard]] std::vector<Key> squaresAround(const Eigen::Vector2d& place, double radius) const;
    [[nodiscard]] static double weightOf(const Cell* cell, bool tight);
    void addEvidence(Key square, double height, int evidence);
    void seeAlong(const Eigen::Vector3d& from, const Eigen::Vector3d& to,
                  const std::unordered_set<Key>& held);
    [[nodiscard]] bool isBorder(const Place& place) const;
    struct Goal {
        std::function<bool(const Place& place, double height)> reached;
        std::optional<double> unseen;  ///< ways may cross unseen floor for this distance [m]
    };
    /// Returns the cheapest way from @p from to the first cell that is a goal (Dijkstra).
    [[nodiscard]] std::vector<Eigen::Vector3d> search(const Eigen::Vector3d& from, const Goal& goal,
                                                      const Turning& turning) const;

    FloorMemorySettings m_settings;
    std::unordered_map<Key, Cell> m_cells;
    std::vector<Eigen::Vector2i> m_disc;  ///< squares within the comfort distance
    std::optional<Key> m_here;
};

}  // namespace leitstand
