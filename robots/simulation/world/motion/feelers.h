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
    Eigen::Vector2d normalInArena = Eigen::Vector2d::Zero();  ///< direction out of the obstacle
    int element = -1;                                         ///< element of the arena; -1: none
    int body = -1;                                            ///< number of the robot; -1: none
    bool victim = false;  ///< whether it is skin or clothes of a victim; the box around a victim is not
};

/// Returns whether @p surface is a victim's skin or clothes. Boards on a victim and the box around it are
/// not.
[[nodiscard]] bool isOfVictim(const Arena& arena, const Surface& surface);

/// Rays that find what a robot runs into: from its middle to its outline at some heights, and upwards along
/// the outline.
class Feelers {
public:
    /// How far the rays look beyond the outline [m].
    static constexpr double Beyond = 0.1;

    explicit Feelers(const BodySpec& spec);

    /// Returns the obstacles that are now inside the outline, the deepest first, at most 8. @p self: body
    /// that rays pass through.
    [[nodiscard]] const std::vector<Obstacle>& feel(const Scene& scene, int self, const Pose& pose);
    /// Returns the distance from the outline to the nearest thing outside it, at most Beyond [m].
    [[nodiscard]] double clearance() const { return m_clearance; }

private:
    struct Feeler {
        Eigen::Vector3d from, to;  ///< in base_link [m]
        Eigen::Vector2d inward;
        std::size_t sample = 0;  ///< index of its sample on the outline
        /// Whether only victims count, because the robot climbs over everything else.
        bool victimsOnly = false;
    };

    void cast(const Scene& scene, int self, const Pose& pose, const std::vector<Feeler>& feelers,
              double beyond);
    void feelAround(const Scene& scene, int self, const Pose& pose);
    void feelUpwards(const Scene& scene, int self, const Pose& pose);
    void add(const Pose& pose, const Feeler& feeler, const Hit& hit, double depth, bool victim);
    void keepDeepest();

    std::vector<Feeler> m_around, m_upwards;
    std::vector<bool> m_inside;  ///< for each sample of the outline: whether something solid covers it
    std::vector<Ray> m_rays;
    std::vector<Hit> m_hits;
    std::vector<Obstacle> m_found;
    double m_clearance = 0.0;
};

}  // namespace leitstand::simulation
