#include "core/mapping/live/registration/scanner_track.h"

#include <algorithm>

#include "core/event/scan_pose.h"
#include "core/mapping/live/scan_doubts.h"

namespace leitstand {
namespace {

constexpr double CompareFrom = 0.8,
                 CompareTo = 2.5;         ///< between scans that are compared by their ranges [m]
constexpr int MostAgain = 3;              ///< consecutive comparisons with one scan
constexpr std::size_t WellCompared = 32;  ///< comparisons; from then on ...
constexpr std::size_t ComparedNext = 8;   ///< ... one key scan of so many is compared

}  // namespace

void ScannerTrack::restart(std::uint64_t lastLeftOut) {
    m_rangeBias = {};
    m_lean = {};
    m_mount = {};
    m_since = lastLeftOut;
    m_comparisons = 0;
}

Eigen::Vector3d ScannerTrack::upOf(const LiveScan& live) const {
    return live.levelByUnit ? m_lean.corrected(live.up, live.sensorInBase) : live.up;
}

void ScannerTrack::addLean(const LiveScan& live, const Match& match, const Pose* before, double way) {
    const bool goesOn = before != nullptr && angleBetween(m_leanAt, *before) < 1e-6 && way > 0.0;
    if (!goesOn) m_lean.mapMoved();
    m_lean.add(match.icp.pose, live.sensorInBase, live.up, way);
    m_leanAt = match.scanInMap;
}

void ScannerTrack::enteredMap(const LiveScan& live, const Match& match) {
    m_lean.entered(match.icp.pose, match.scanInMap, live.up);
}

void ScannerTrack::addMount(const LiveScan& live, const Pose& scanInMap, const Pose& before, bool fits) {
    // Scans that moved took the robot with them.
    if (!fits || !m_mountAt.isApprox(before, 1e-9)) m_mount.breakOff();
    if (fits)
        m_mount.add({scanInMap, live.scan->sensorInOdom, live.sensorInBase, live.velocity, live.yawRate});
    m_mountAt = scanInMap;
}

void ScannerTrack::compare(const LiveKeyScan& entered, const PointCloud& cloud, const LiveMap& map) {
    if (has(entered.pose.doubts, ScanDoubt::Guessed)) return;
    // Each takes some milliseconds: once the bias is known well enough, it is checked now and then.
    const std::size_t before = m_comparisons++;
    if (before >= WellCompared && before % ComparedNext != 0) return;
    const auto compares = [&](const LiveKeyScan& other) {
        // How an earlier run of the station prepared its scans is not known.
        if (!other.counts() || other.odometryFrame < 0 || other.id <= m_since ||
            other.scan->robot != entered.scan->robot || has(other.pose.doubts, ScanDoubt::Guessed))
            return false;
        const double distance = distanceBetween(other.pose.scanInMap, entered.pose.scanInMap);
        return distance >= CompareFrom && distance <= CompareTo;
    };
    const auto other = std::find_if(map.scans.rbegin(), map.scans.rend(), compares);
    if (other == map.scans.rend()) return;
    m_comparedAgain = m_compared == other->id ? m_comparedAgain + 1 : 0;
    m_compared = other->id;
    if (m_comparedAgain >= MostAgain) return;  // a single bent scan must not decide alone
    m_rangeBias.add(cloud, other->reduced->unpacked(),
                    other->pose.scanInMap.inverse() * entered.pose.scanInMap);
}

ScannerCalibration ScannerTrack::calibration() const {
    return {m_rangeBias.estimate(), m_lean.lean(), m_lean.deviation(), m_mount.estimate()};
}

}  // namespace leitstand
