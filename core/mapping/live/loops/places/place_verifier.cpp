#include "core/mapping/live/loops/places/place_verifier.h"

#include <algorithm>
#include <cstddef>
#include <vector>

#include "core/mapping/live/loops/links/found_links.h"
#include "core/mapping/live/loops/places/free_space.h"
#include "core/mapping/live/scan_work.h"
#include "core/mapping/walls/wall_raster.h"
#include "core/mapping/walls/walls_from_above.h"

namespace leitstand {
namespace {

constexpr double Slack = 0.2;  ///< registration may move a place that was found from above so far [m]
constexpr double Apart = 0.4;  ///< places nearer to each other are the same one [m]

/// Returns the walls of @p local around @p middle, seen from above, relative to it.
WallRaster wallsAbout(const LocalMap& local, const Eigen::Vector3d& middle) {
    PointCloud cloud;
    cloud.normals = local.cloud.normals;
    for (const Eigen::Vector3f& point : local.cloud.points)
        cloud.points.emplace_back(point - middle.cast<float>());
    WallBand all;
    all.reach *= 2.0;
    return WallRaster(thinnedWalls(wallsFromAbove(cloud, Eigen::Matrix3f::Identity(), all)));
}

}  // namespace

std::optional<MatchedPlace> PlaceVerifier::verify(const LiveKeyScan& scan, const LiveKeyScan& older,
                                                  const LocalMap& local, const Pose& guess) const {
    Step step;
    step.measured = true;
    step.way = m_loops.reach / std::max(m_match.odometry.share, 0.01);  // it may be far off
    step.turn = 1.0;
    const Match match =
        leitstand::match(scan.reduced->unpacked(), local, guess, step, scan.up, m_match, m_fit, m_match.wide);
    if (match.doubts != 0 || match.icp.overlap < m_loops.leastOverlap || match.icp.rms > m_loops.mostResidual)
        return std::nullopt;
    const Pose inOlder = older.pose.scanInMap.inverse() * match.scanInMap;
    const double filled = filledShare(*older.scan, *scan.scan, inOlder);
    if (filled > m_loops.mostFilled) return std::nullopt;
    LiveKeyScan there = scan;
    there.pose.scanInMap = match.scanInMap;
    MatchedPlace place;
    place.link = linkBetween(older, there, older.part == scan.part ? LinkKind::Loop : LinkKind::Session);
    place.link.information = informationOf(match.icp, match.scanInMap, m_loops, m_match);
    place.correction = match.scanInMap * scan.pose.scanInMap.inverse();
    place.at = scan.pose.scanInMap.translation();
    place.robot = scan.scan->robot;
    place.met = older.part;
    place.fit = match.icp.overlap - 3.0 * filled;
    return place;
}

bool PlaceVerifier::mayFitBeside(const MatchedPlace& place, double within) {
    return place.shift() + within + Slack >= WallRaster::PlacesApart;
}

bool PlaceVerifier::fitsBeside(const MatchedPlace& place, const LiveKeyScan& scan, const LiveKeyScan& older,
                               const LocalMap& local, double within) const {
    const Pose found = place.correction * scan.pose.scanInMap;
    const Eigen::Vector3d middle = found.translation();
    const Eigen::Vector2d about = (place.at - middle).head<2>();
    const Pose level = levelled(Pose::Identity(), upOf(scan), 1.0);
    const auto view =
        thinnedWalls(wallsFromAbove(scan.reduced->unpacked(), level.linear().cast<float>(), WallBand{}));
    FlatPose best = FlatPose::of(found * level.inverse());
    best.place.setZero();
    const WallRaster walls = wallsAbout(local, middle);
    constexpr std::size_t Most = 4;  // are tried: each takes as long as a scan that enters
    std::vector<RasterPlace> others = walls.beside(view, best, about, within + Slack, m_loops.alikeFromAbove);
    others.resize(std::min(others.size(), Most));
    for (const RasterPlace& other : others) {
        Pose guess = found;
        guess.translation().head<2>() += other.pose.place;
        const std::optional<MatchedPlace> there = verify(scan, older, local, guess);
        if (!there || there->fit < m_loops.alike * place.fit) continue;
        const Pose otherwise = there->correction * scan.pose.scanInMap;
        if (distanceBetween(otherwise, found) >= Apart && there->shift() <= within) return true;
    }
    return false;
}

}  // namespace leitstand
