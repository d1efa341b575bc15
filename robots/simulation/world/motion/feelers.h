#pragma once

#include <vector>

#include <Eigen/Core>

#include "core/base/pose.h"
#include "robots/simulation/scene/scene.h"
#include "robots/simulation/world/body.h"
#include "robots/simulation/world/motion/drive_train.h"

namespace leitstand::simulation {

/// Something solid that reaches into a robot's outline.
struct Obstacle {
    Push push;
    Eigen::Vector2d normalInArena = Eigen::Vector2d::Zero();  ///< out of the obstacle
    int element = -1;                                         ///< of the arena; -1: none
    int body = -1;                                            ///< a robot; -1: none
    bool victim = false;                                      ///< skin or clothes of a victim, not its box
};

/// Returns whether @p surface is a victim's skin or clothes. Boards on a victim and the box around it are
/// not.
[[nodiscard]] bool isOfVictim(const Arena& arena, const Surface& surface);

/// Rays that find what a robot runs against: from its middle to its outline at some heights, and upwards
/// along the outline.
class Feelers {
public:
    /// How far the rays look beyond the outline [m].
    static constexpr double Beyond = 0.1;

    explicit Feelers(const BodySpec& spec);

    /// Returns the obstacles inside the outline now, deepest first, at most 8. @p self: body that rays pass
    /// through.
    [[nodiscard]] const std::vector<Obstacle>& feel(const Scene& scene, int self, const Pose& pose);
    /// Returns the distance from the outline to the nearest thing outside it, at most Beyond [m].
    [[nodiscard]] double clearance() const { return m_clearance; }

private:
    struct Feeler {
        Eigen::Vector3d from, to;  ///< base_link [m]
        Eigen::Vector2d inward;
        std::size_t sample = 0;    ///< on the outline
        bool victimsOnly = false;  ///< where the robot climbs over all else
    };

    void cast(const Scene& scene, int self, const Pose& pose, const std::vector<Feeler>& feelers,
              double beyond);
    void feelAround(const Scene& scene, int self, const Pose& pose);
    void feelUpwards(const Scene& scene, int self, const Pose& pose);
    void add(const Pose& pose, const Feeler& feeler, const Hit& hit, double depth, bool victim);
    void keepDeepest();

    std::vector<Feeler> m_around, m_upwards;
    std::vector<bool> m_inside;  ///< samples of the outline that something solid covers
    std::vector<Ray> m_rays;
    std::vector<Hit> m_hits;
    std::vector<Obstacle> m_found;
    double m_clearance = 0.0;
};

}  // namespace leitstand::simulation
