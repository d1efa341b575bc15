#include "robots/control/driving/heat_target.h"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

namespace leitstand {
namespace {

constexpr double DeepestVictim = 0.4;   ///< before and behind the visible middle of a victim [m]
constexpr double WallsBeside = 0.12;    ///< beside the heat, where walls go on [rad]
constexpr double BlurredHeight = 0.15;  ///< uncertainty of heights of heat [m]
constexpr double FarthestVictim = 9.0;  ///< surfaces farther away are not of a victim that was seen [m]

/// Returns the distance of @p point from the front edge of @p body; negative behind it [m].
double fromFront(const BodyBox& body, const Eigen::Vector2d& point) {
    const double beside = std::max({0.0, point.y() - body.left, -body.right - point.y()});
    return std::hypot(point.x() - body.front, beside) * (point.x() < body.front ? -1.0 : 1.0);
}

/// Returns what is low and connected to @p heat: the whole victim, not only its warm part.
std::vector<HeatTarget> wholeVictim(std::vector<HeatTarget> heat, const VirtualScanView& view,
                                    const BodyBox& body, const HeatTargetSettings& settings) {
    std::erase_if(heat, [&](const HeatTarget& one) {
        return one.top > settings.lying &&
               std::any_of(heat.begin(), heat.end(),
                           [&](const HeatTarget& other) { return other.top <= settings.lying; });
    });
    if (heat.empty() || heat.front().top > settings.lying) return heat;
    std::vector<HeatTarget> rest;
    for (const VirtualObstacle& one : view.obstacles) {
        const bool near = std::any_of(heat.begin(), heat.end(), [&](const HeatTarget& other) {
            return (other.inBase - one.where).norm() < settings.length;
        });
        if (one.top > settings.lying || one.bottom > settings.hanging || !near) continue;
        rest.push_back({one.where, fromFront(body, one.where), one.age, one.top});
    }
    for (std::size_t i = 0; i < heat.size(); ++i) {
        const Eigen::Vector2d here = heat[i].inBase;
        const auto linked = std::stable_partition(rest.begin(), rest.end(), [&](const HeatTarget& one) {
            return (one.inBase - here).norm() > settings.link;
        });
        heat.insert(heat.end(), linked, rest.end());
        rest.erase(linked, rest.end());
    }
    return heat;
}

}  // namespace

std::optional<HeatTarget> heatTarget(const HeatCue& cue, const VirtualScanView& view, const Pose& baseInOdom,
                                     const BodyBox& body, const HeatTargetSettings& settings) {
    const Eigen::Isometry2d toBase = flat(baseInOdom).inverse();
    const Eigen::Vector2d origin = toBase * Eigen::Vector2d(cue.ray.origin.head<2>());
    const Eigen::Vector2d towards = (toBase.linear() * cue.ray.direction.head<2>()).normalized();
    const double band = 0.5 * cue.width + settings.bandMargin;
    struct Seen {
        HeatTarget target;
        double off, range;  ///< off: left positive [rad]
        bool lies;          ///< low, and the heat is at its height
    };
    std::vector<Seen> seen;
    for (const VirtualObstacle& one : view.obstacles) {
        const Eigen::Vector2d away = one.where - origin;
        const double off = std::atan2(towards.x() * away.y() - towards.y() * away.x(), towards.dot(away));
        if (std::abs(off) > band + WallsBeside || away.norm() > FarthestVictim) continue;
        const double distance = fromFront(body, one.where);
        const double height = heightAt(cue, flat(baseInOdom) * one.where, baseInOdom);
        const bool lies = one.top <= settings.lying && height > one.bottom - BlurredHeight &&
                          height < one.top + BlurredHeight;
        seen.push_back({{one.where, distance, one.age, one.top}, off, away.norm(), lies});
    }
    if (seen.empty()) return std::nullopt;
    // Past the edge of a wall, the heat is on what lies behind.
    const auto inBand = [band](const Seen& one) { return std::abs(one.off) <= band; };
    const auto lying =
        std::count_if(seen.begin(), seen.end(), [&](const Seen& one) { return one.lies && inBand(one); });
    if (lying > 1) std::erase_if(seen, [](const Seen& one) { return !one.lies; });
    // Range of what the middle of the heat is on; other points in the band may be before or behind it.
    const double range = std::min_element(seen.begin(), seen.end(), [](const Seen& a, const Seen& b) {
                             return std::abs(a.off) < std::abs(b.off);
                         })->range;
    std::vector<HeatTarget> found;
    bool left = false, right = false, beyond = false;
    for (const Seen& one : seen) {
        if (std::abs(one.range - range) > DeepestVictim) continue;
        if (!inBand(one)) {
            beyond = true;
            continue;
        }
        found.push_back(one.target);
        left = left || one.off >= 0.0;
        right = right || one.off <= 0.0;
    }
    if (found.empty()) return std::nullopt;
    found = wholeVictim(std::move(found), view, body, settings);
    std::sort(found.begin(), found.end(),
              [](const HeatTarget& a, const HeatTarget& b) { return a.distance < b.distance; });
    // Takes the second nearest of one surface: noise makes a single point too near.
    const bool second = found.size() > 3 && found[1].distance < found[0].distance + 0.05;
    HeatTarget nearest = found[second ? 1 : 0];
    nearest.certain = (left && right) || !beyond;
    nearest.heat = range;
    for (const HeatTarget& one : found) {
        if (one.distance < nearest.distance + 0.15) nearest.age = std::max(nearest.age, one.age);
    }
    return nearest;
}

}  // namespace leitstand
