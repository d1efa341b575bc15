#pragma once

#include <cstdint>
#include <optional>
#include <unordered_map>
#include <vector>

#include <Eigen/Core>

#include "core/base/pose.h"
#include "core/perception/virtual_scan_view.h"

namespace leitstand {

struct FloorMemorySettings {
    double cell = 0.15;       ///< [m]
    double sight = 3.5;       ///< floor is remembered as seen up to there [m]
    double clearance = 0.30;  ///< from obstacles, for the robot's middle [m]
    double maxAge = 3.0;      ///< of sectors that tell something [s]
};

/// Where a robot has been and what it has seen: a coarse grid in the odometry's frame. The newest view is
/// right, so that the odometry's drift does no lasting harm.
class FloorMemory {
public:
    explicit FloorMemory(const FloorMemorySettings& settings = {});

    void see(const VirtualScanView& view, const Pose& baseInOdom);
    /// A place to keep away from for good: where the robot got stuck; in odom [m].
    void avoid(const Eigen::Vector2d& place, double radius);
    /// What could not be reached is not tried again.
    void giveUp(const Eigen::Vector2d& place, double radius);
    void clear();

    /// The way from @p from over seen floor to the nearest border of the unseen; in odom [m]. Empty: none.
    [[nodiscard]] std::vector<Eigen::Vector2d> wayToUnseen(const Eigen::Vector2d& from) const;
    /// The way to @p goal; over unseen floor too. Empty: none.
    [[nodiscard]] std::vector<Eigen::Vector2d> wayTo(const Eigen::Vector2d& from,
                                                     const Eigen::Vector2d& goal) const;
    [[nodiscard]] bool isSeen(const Eigen::Vector2d& place) const;
    [[nodiscard]] bool isBlocked(const Eigen::Vector2d& place) const;
    [[nodiscard]] int visits(const Eigen::Vector2d& place) const;  ///< how often the robot came there
    [[nodiscard]] double seenArea() const;                         ///< [m2]

private:
    struct Cell {
        bool seen = false, blocked = false, avoided = false, givenUp = false;
        std::uint16_t visits = 0;
        std::uint16_t near = 0;  ///< blocked cells within the clearance
    };
    using Key = std::int64_t;
    [[nodiscard]] Key keyOf(const Eigen::Vector2d& place) const;
    [[nodiscard]] Eigen::Vector2d middleOf(Key key) const;
    [[nodiscard]] const Cell* find(Key key) const;
    void setBlocked(Key key, bool blocked);
    template <class Goal, class Passable>
    [[nodiscard]] std::vector<Eigen::Vector2d> search(const Eigen::Vector2d& from, const Goal& goal,
                                                      const Passable& passable) const;

    FloorMemorySettings m_settings;
    std::unordered_map<Key, Cell> m_cells;
    std::vector<Eigen::Vector2i> m_disc;  ///< cells within the clearance
    std::optional<Key> m_here;
};

}  // namespace leitstand
