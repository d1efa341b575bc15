#include "core/mapping/live/trail.h"

namespace leitstand {
namespace {

constexpr double Jump = 1.0;                ///< of odometry or of its place in the map [m]
constexpr std::chrono::seconds Silence(3);  ///< of the odometry
constexpr double Unseen = 0.5;  ///< a robot may go so far meanwhile on a path that is still known [m]

}  // namespace

bool isGap(double away, std::chrono::nanoseconds notReceived, double apart) {
    const double beyond = away - apart;
    return beyond > Jump || (beyond > Unseen && notReceived > Silence);
}

}  // namespace leitstand
