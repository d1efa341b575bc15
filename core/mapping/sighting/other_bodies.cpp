#include "core/mapping/sighting/other_bodies.h"

#include <algorithm>
#include <chrono>

namespace leitstand {
namespace {

constexpr std::chrono::milliseconds Step(100);
constexpr double Moved = 0.05, Turned = degrees(8);  ///< smaller ones are covered by the margin [m], [rad]
constexpr double Doubted = 0.2,
                 MoreDoubted = 0.2;  ///< margin of an uncertain pose, and more without any certainty [m]
constexpr int MostSteps = 100;       ///< a scan takes some seconds

}  // namespace

void addBodies(std::vector<PlacedBody>& bodies, const RobotTracker& robot, const RobotBody& body, Time start,
               Time end) {
    const RobotInMap& now = robot.now();
    if (!now.placed) return;
    const double doubt = 1.0 - std::clamp(now.certainty, 0.0, 1.0);
    const double margin = now.certain ? PlacedBody::Certain : Doubted + MoreDoubted * doubt;
    bool any = false;
    for (int i = 0; i <= MostSteps; ++i) {
        const Time stamp = std::min(end, start + i * Step);
        if (const auto there = robot.baseInMap(stamp)) {
            const bool stands = any && distanceBetween(bodies.back().baseInMap, *there) < Moved &&
                                angleBetween(bodies.back().baseInMap, *there) < Turned;
            if (!stands) bodies.push_back({body, *there, margin});
            any = true;
        }
        if (stamp >= end) return;
    }
}

}  // namespace leitstand
