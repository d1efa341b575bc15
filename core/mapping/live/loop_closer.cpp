#include "core/mapping/live/loop_closer.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>
#include <utility>

#include <Eigen/Eigenvalues>

namespace leitstand {
namespace {

const LiveKeyScan* find(const LiveMap& map, std::uint64_t id) {
    const auto found =
        std::lower_bound(map.scans.begin(), map.scans.end(), id,
                         [](const LiveKeyScan& scan, std::uint64_t wanted) { return scan.id < wanted; });
    return found != map.scans.end() && found->id == id ? &*found : nullptr;
}

Link linkBetween(const LiveKeyScan& from, const LiveKeyScan& to, LinkKind kind) {
    Link link;
    link.from = from.id;
    link.to = to.id;
    link.kind = kind;
    link.pose = from.pose.scanInMap.inverse() * to.pose.scanInMap;
    return link;
}

}  // namespace

LoopCloser::LoopCloser(const LoopSettings& settings, const MatchSettings& match, const FitSettings& fit)
    : m_settings(settings), m_match(match), m_fit(fit) {}

Information LoopCloser::informationOf(const IcpResult& icp, const Pose& toInMap) const {
    // Directions by what surfaces say of them; turns as the shift at the distance where scans have most
    // points.
    const Eigen::SelfAdjointEigenSolver<Information> solver(icp.information);
    Information scaled = Information::Zero();
    for (Eigen::Index i = 0; i < 6; ++i) {
        const double share = std::clamp(3.0 * solver.eigenvalues()[i] / m_match.openBelow, 0.0, 1.0);
        if (3.0 * solver.eigenvalues()[i] < IcpResult::UncertainBelow) continue;
        scaled += share * solver.eigenvectors().col(i) * solver.eigenvectors().col(i).transpose();
    }
    Eigen::Matrix<double, 6, 1> deviation;
    deviation.head<3>().setConstant(1.0 / m_settings.matchDeviation);
    deviation.tail<3>().setConstant(m_settings.arm / m_settings.matchDeviation);
    Information turn = Information::Zero();
    turn.topLeftCorner<3, 3>() = turn.bottomRightCorner<3, 3>() = toInMap.linear();
    const Information inMap = deviation.asDiagonal() * scaled * deviation.asDiagonal();
    return turn.transpose() * inMap * turn;
}

void LoopCloser::add(const LiveKeyScan& entered, const LiveKeyScan* predecessor, const LiveMap& map,
                     const std::vector<std::uint64_t>& matchedAgainst, const Match& match,
                     double odometryScale) {
    if (predecessor != nullptr) {
        m_graph.connect(entered.id, predecessor->id,
                        distanceBetween(entered.pose.scanInMap, predecessor->pose.scanInMap));
        if (entered.scan->hasOdometry && predecessor->scan->hasOdometry &&
            entered.odometryFrame == predecessor->odometryFrame) {
            Link link = linkBetween(*predecessor, entered, LinkKind::Odometry);
            link.pose = predecessor->scan->sensorInOdom.inverse() * entered.scan->sensorInOdom;
            link.pose.translation() *= odometryScale;
            const Eigen::Matrix<double, 6, 1> deviation = odometryDeviation(
                link.pose.translation().norm(), Eigen::AngleAxisd(link.pose.linear()).angle(), m_match);
            link.information = deviation.cwiseAbs2().cwiseInverse().asDiagonal();
            m_graph.add(std::move(link));
        }
    }
    if (match.doubts != 0) return;
    int links = 0;
    for (const std::uint64_t id : matchedAgainst) {
        const LiveKeyScan* const other = find(map, id);
        if (other == nullptr || other->id == entered.id) continue;
        m_graph.connect(entered.id, id, distanceBetween(entered.pose.scanInMap, other->pose.scanInMap));
        if (links++ >= m_settings.linksAScan) continue;
        Link link = linkBetween(*other, entered, LinkKind::Match);
        link.information = informationOf(match.icp, entered.pose.scanInMap) / m_settings.linksAScan;
        m_graph.add(std::move(link));
    }
}

void LoopCloser::forget(std::uint64_t id) {
    m_graph.forget(id);
    std::erase_if(m_pending,
                  [id](const Found& found) { return found.link.from == id || found.link.to == id; });
}

std::map<std::uint64_t, double> LoopCloser::sameAge(std::uint64_t id) const {
    return m_graph.within(id, m_settings.sameAge);
}

std::optional<LoopCloser::Found> LoopCloser::look(const LiveKeyScan& entered, const LiveMap& map) {
    const std::map<std::uint64_t, double> near = sameAge(entered.id);
    const Eigen::Vector3d place = entered.pose.scanInMap.translation();
    const LiveKeyScan* nearest = nullptr;
    double least = m_settings.reach;
    for (const LiveKeyScan& scan : map.scans) {
        if (!scan.counts() || near.contains(scan.id) || scan.id == entered.id) continue;
        const double distance = (scan.pose.scanInMap.translation() - place).norm();
        if (distance < least) {
            least = distance;
            nearest = &scan;
        }
    }
    if (nearest == nullptr) return std::nullopt;
    const std::map<std::uint64_t, double> about = m_graph.within(nearest->id, m_settings.about);
    std::vector<LiveKeyScan> others;
    for (const auto& [id, way] : about) {
        const LiveKeyScan* const scan = find(map, id);
        if (scan != nullptr && scan->counts() && !near.contains(id)) others.push_back(*scan);
    }
    const LocalMap local = localMap(others, nearest->pose.scanInMap);
    const PointCloud cloud = entered.reduced->unpacked();
    Step step;
    step.measured = true;
    step.way = m_settings.reach / std::max(m_match.drift, 0.01);  // far off, maybe
    step.turn = 1.0;
    const Match match = leitstand::match(cloud, local, entered.pose.scanInMap, step, entered.up, m_match,
                                         m_fit, m_match.wide);
    if (match.doubts != 0 || match.icp.overlap < m_settings.leastOverlap ||
        match.icp.rms > m_settings.mostResidual)
        return std::nullopt;
    Found found;
    LiveKeyScan there = entered;
    there.pose.scanInMap = match.scanInMap;
    found.link = linkBetween(*nearest, there, LinkKind::Loop);
    found.link.information = informationOf(match.icp, match.scanInMap);
    found.correction = match.scanInMap * entered.pose.scanInMap.inverse();
    found.at = place;
    return found;
}

bool LoopCloser::agree(const Found& a, const Found& b) const {
    const Pose difference = a.correction.inverse() * b.correction;
    const Eigen::Vector3d shift = difference * b.at - b.at;
    return (a.at - b.at).norm() >= m_settings.apart && shift.norm() <= m_settings.agreeWithin &&
           Eigen::AngleAxisd(difference.linear()).angle() <= m_settings.agreeWithinAngle;
}

void LoopCloser::take(const Found& found, const LiveMap& map) {
    m_graph.add(found.link);
    const LiveKeyScan *const from = find(map, found.link.from), *const to = find(map, found.link.to);
    if (from == nullptr || to == nullptr) return;
    m_graph.connect(from->id, to->id, distanceBetween(from->pose.scanInMap, to->pose.scanInMap));
    ++m_closed;
}

std::vector<ScanPose> LoopCloser::solved(const LiveMap& map) const {
    PoseGraph graph;
    for (const LiveKeyScan& scan : map.scans) graph.nodes.push_back({scan.id, scan.pose.scanInMap, false});
    graph.links = m_graph.links();
    GraphSettings settings;
    settings.robust = false;
    (void)solve(graph, settings);
    std::vector<ScanPose> moved;
    for (std::size_t i = 0; i < map.scans.size(); ++i) {
        const Pose& before = map.scans[i].pose.scanInMap;
        const Pose& after = graph.nodes[i].pose;
        if (distanceBetween(before, after) <= m_settings.noticed &&
            angleBetween(before, after) <= m_settings.noticedAngle)
            continue;
        moved.push_back(map.scans[i].pose);
        moved.back().scanInMap = after;
    }
    return moved;
}

std::vector<ScanPose> LoopCloser::close(const LiveKeyScan& entered, const LiveMap& map) {
    std::optional<Found> found = look(entered, map);
    if (!found) return {};
    std::erase_if(m_pending, [&](const Found& other) {
        return (other.at - found->at).norm() > m_settings.pendingWithin;
    });
    std::vector<Found> agreeing;
    for (const Found& other : m_pending) {
        if (agree(other, *found)) agreeing.push_back(other);
    }
    if (agreeing.empty()) {
        const bool apart = std::all_of(m_pending.begin(), m_pending.end(), [&](const Found& other) {
            return (other.at - found->at).norm() >= 0.5 * m_settings.apart;
        });
        if (apart) m_pending.push_back(std::move(*found));
        return {};
    }
    for (const Found& other : agreeing) take(other, map);
    take(*found, map);
    m_pending.clear();
    return solved(map);
}

}  // namespace leitstand
