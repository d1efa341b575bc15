#include "core/mapping/live/loops/loop_closer.h"

#include <algorithm>
#include <limits>
#include <utility>

#include "core/mapping/live/loops/free_space.h"
#include "core/mapping/live/map/local_map.h"
#include "core/mapping/live/scan_work.h"

namespace leitstand {
namespace {

constexpr std::uint64_t LinkBlock = 100'000;  ///< of links that stations number without hearing each other

}  // namespace

LoopCloser::LoopCloser(const LoopSettings& settings, const MatchSettings& match, const FitSettings& fit)
    : m_settings(settings), m_match(match), m_fit(fit) {}

std::vector<Link> LoopCloser::add(const Entry& entry) {
    std::vector<Link> links = linksOf(entry, m_settings, m_match);
    for (Link& link : links) link = m_graph.add(std::move(link));
    return links;
}

std::vector<Link> LoopCloser::replace(const Entry& entry) {
    std::vector<Link> changed;
    for (const Link& link : m_graph.links()) {
        const bool old = link.kind == LinkKind::Match || link.kind == LinkKind::Odometry;
        if (old && link.active && (link.from == entry.scan.id || link.to == entry.scan.id)) {
            changed.push_back(link);
            changed.back().active = false;
        }
    }
    for (const Link& link : changed) m_graph.setActive(link.id, false);
    std::vector<Link> made = add(entry);
    changed.insert(changed.end(), made.begin(), made.end());
    return changed;
}

void LoopCloser::restore(std::span<const Link> links) {
    for (const Link& link : links) m_graph.add(link);
}

bool LoopCloser::follow(std::span<const Link> loops) {
    bool changed = false;
    for (const Link& link : loops) {
        const auto known = std::find_if(m_graph.links().begin(), m_graph.links().end(),
                                        [&](const Link& one) { return one.id == link.id; });
        const bool was = known != m_graph.links().end() && known->active;
        changed = changed || was != link.active;
        m_graph.add(link);
    }
    return changed;
}

std::vector<Link> LoopCloser::contradict(std::span<const std::uint64_t> links) {
    for (const std::uint64_t id : links) m_graph.setActive(id, false);
    std::vector<Link> contradicted;
    for (const Link& link : m_graph.links()) {
        if (std::find(links.begin(), links.end(), link.id) != links.end()) contradicted.push_back(link);
    }
    return contradicted;
}

void LoopCloser::forget(std::uint64_t scan) {
    m_graph.forget(scan);
    std::erase_if(m_pending,
                  [scan](const Found& found) { return found.link.from == scan || found.link.to == scan; });
}

void LoopCloser::beginBlock() {
    m_graph.beginBlock(LinkBlock);
}

std::map<std::uint64_t, double> LoopCloser::sameAge(std::uint64_t id) const {
    return m_graph.within(id, m_settings.sameAge);
}

bool LoopCloser::wasRefused(std::uint64_t from, std::uint64_t to) const {
    return std::any_of(m_graph.links().begin(), m_graph.links().end(), [&](const Link& link) {
        if (link.active || !closesLoop(link.kind)) return false;
        const auto aboutFrom = m_graph.within(link.from, m_settings.about);
        const auto aboutTo = m_graph.within(link.to, m_settings.about);
        return (aboutFrom.contains(from) && aboutTo.contains(to)) ||
               (aboutFrom.contains(to) && aboutTo.contains(from));
    });
}

double LoopCloser::deviation(std::uint64_t from, std::uint64_t to) const {
    const auto way = m_graph.cheapest(from, to, [this](const Link& link) {
        const double share = link.kind == LinkKind::Odometry ? m_settings.openDrift : m_settings.drift;
        return share * link.pose.translation().norm();
    });
    // What does not hang together may be anywhere.
    return way ? m_settings.driftAtLeast + *way : std::numeric_limits<double>::infinity();
}

std::optional<LoopCloser::Found> LoopCloser::look(const LiveKeyScan& entered, const LiveMap& map) const {
    const std::map<std::uint64_t, double> near = sameAge(entered.id);
    const LiveKeyScan* nearest = nullptr;
    double least = m_settings.reach;
    for (const LiveKeyScan& scan : map.scans) {
        if (!scan.counts() || near.contains(scan.id) || scan.id == entered.id) continue;
        const double distance = mapDistance(scan.pose.scanInMap, entered.pose.scanInMap);
        if (distance < least) {
            least = distance;
            nearest = &scan;
        }
    }
    if (nearest == nullptr || wasRefused(nearest->id, entered.id)) return std::nullopt;
    const std::map<std::uint64_t, double> about = m_graph.within(nearest->id, m_settings.about);
    std::vector<LiveKeyScan> others;
    for (const LiveKeyScan& scan : map.scans) {
        if (scan.counts() && about.contains(scan.id) && !near.contains(scan.id)) others.push_back(scan);
    }
    const LocalMap local = localMap(others, nearest->pose.scanInMap);
    Step step;
    step.measured = true;
    step.way = m_settings.reach / std::max(m_match.odometry.share, 0.01);  // far off, maybe
    step.turn = 1.0;
    const Match match = leitstand::match(entered.reduced->unpacked(), local, entered.pose.scanInMap, step,
                                         entered.up, m_match, m_fit, m_match.wide);
    if (match.doubts != 0 || match.icp.overlap < m_settings.leastOverlap ||
        match.icp.rms > m_settings.mostResidual)
        return std::nullopt;
    const Pose inNearest = nearest->pose.scanInMap.inverse() * match.scanInMap;
    if (filledShare(*nearest->scan, *entered.scan, inNearest) > m_settings.mostFilled) return std::nullopt;
    Found found;
    LiveKeyScan there = entered;
    there.pose.scanInMap = match.scanInMap;
    found.link = linkBetween(*nearest, there, LinkKind::Loop);
    found.link.information = informationOf(match.icp, match.scanInMap, m_settings, m_match);
    found.correction = match.scanInMap * entered.pose.scanInMap.inverse();
    found.at = entered.pose.scanInMap.translation();
    return found;
}

bool LoopCloser::agree(const Found& a, const Found& b) const {
    const Pose difference = a.correction.inverse() * b.correction;
    const Eigen::Vector3d shift = difference * b.at - b.at;
    return (a.at - b.at).norm() >= m_settings.apart && shift.norm() <= m_settings.agreeWithin &&
           Eigen::AngleAxisd(difference.linear()).angle() <= m_settings.agreeWithinAngle;
}

std::vector<Link> LoopCloser::close(const LiveKeyScan& entered, const LiveMap& map) {
    std::optional<Found> found = look(entered, map);
    if (!found) return {};
    std::erase_if(m_pending, [&](const Found& other) {
        return (other.at - found->at).norm() > m_settings.pendingWithin;
    });
    std::vector<Link> links;
    for (const Found& other : m_pending) {
        if (agree(other, *found)) links.push_back(other.link);
    }
    if (links.empty()) {
        const bool apart = std::all_of(m_pending.begin(), m_pending.end(), [&](const Found& other) {
            return (other.at - found->at).norm() >= 0.5 * m_settings.apart;
        });
        if (apart) m_pending.push_back(std::move(*found));
        return {};
    }
    links.push_back(found->link);
    const double shift = (found->correction * found->at - found->at).norm();
    const bool expected = shift <= m_settings.askBeyond * deviation(found->link.from, found->link.to);
    for (Link& link : links) {
        link.active = expected;
        link = m_graph.add(std::move(link));
    }
    m_pending.clear();
    return links;
}

}  // namespace leitstand
