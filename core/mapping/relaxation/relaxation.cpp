#include "core/mapping/relaxation/relaxation.h"

#include <algorithm>
#include <cmath>
#include <set>
#include <utility>

#include "core/base/parallel.h"
#include "core/event/scan_pose.h"
#include "core/mapping/graph/graph_solver.h"
#include "core/mapping/graph/scan_graph.h"
#include "core/mapping/live/loops/links/found_links.h"
#include "core/mapping/live/map/local_map.h"
#include "core/mapping/live/scan_work.h"

namespace leitstand {
namespace {

/// The result of matching a scan with its surroundings.
struct Matched {
    std::vector<Link> links;
    double rms = 0.0;  ///< of its pairs [m]
};

/// Ensures that one of the first @p linked of @p against, nearest first, is older than @p id, if any is.
/// Scans that are each linked with an older one are connected. The nearest four of several scans at one place
/// may be each other.
void beginWithOlder(std::vector<LiveKeyScan>& against, std::uint64_t id, std::size_t linked) {
    if (linked == 0 || against.size() <= linked) return;
    const auto older = std::find_if(against.begin(), against.end(),
                                    [id](const LiveKeyScan& other) { return other.id < id; });
    const auto last = against.begin() + static_cast<std::ptrdiff_t>(linked - 1);
    if (older != against.end() && older > last) std::iter_swap(older, last);
}

/// Returns whether one of @p links connects its scan with an older one.
bool holdsOnOlder(const std::vector<Link>& links) {
    return std::any_of(links.begin(), links.end(), [](const Link& link) { return link.from < link.to; });
}

class Relaxer {
public:
    Relaxer(const LiveMap& map, std::span<const Link> links, const LiveSettings& settings,
            const RelaxationSettings& how)
        : m_links(links.begin(), links.end()), m_settings(settings), m_how(how) {
        for (const LiveKeyScan& scan : map.scans) {
            if (scan.pose.trust != ScanTrust::SetAside) m_scans.push_back(scan);
        }
        ScanGraph graph;
        for (const Link& link : m_links) graph.add(link);
        m_near.resize(m_scans.size());
        for (std::size_t i = 0; i < m_scans.size(); ++i) {
            if (m_scans[i].counts()) m_near[i] = near(graph, m_scans[i]);
        }
    }

    [[nodiscard]] Relaxation run(const Progress& progress) {
        Relaxation result;
        std::vector<Pose> began;
        for (const LiveKeyScan& scan : m_scans) began.push_back(scan.pose.scanInMap);
        while (result.rounds < m_how.rounds && !result.settled) {
            const std::vector<Matched> matched = matchAll(result.rounds, progress);
            Relaxation next = result;
            take(matched, next);
            const std::vector<LiveKeyScan> before = m_scans;
            next.settled = moveAll(next, progress) <= m_how.settled;
            if (progress.cancelled()) {
                m_scans = before;
                break;
            }
            ++next.rounds;
            result = std::move(next);
        }
        for (std::size_t i = 0; i < m_scans.size(); ++i) {
            const Pose& now = m_scans[i].pose.scanInMap;
            result.largest = std::max(result.largest, distanceBetween(began[i], now));
            result.nodes.push_back({m_scans[i].id, now, false});
        }
        return result;
    }

private:
    /// Returns the scans that are connected with @p scan. One that only lies beside it may be another place.
    [[nodiscard]] std::vector<std::size_t> near(const ScanGraph& graph, const LiveKeyScan& scan) const {
        std::vector<std::size_t> found;
        const auto within = graph.within(scan.id, m_settings.loops.sameAge);
        for (std::size_t i = 0; i < m_scans.size(); ++i) {
            const LiveKeyScan& other = m_scans[i];
            if (other.id != scan.id && other.counts() && within.contains(other.id)) found.push_back(i);
        }
        return found;
    }

    [[nodiscard]] Matched matchOne(std::size_t index) const {
        Matched matched;
        std::vector<LiveKeyScan> others;
        for (const std::size_t other : m_near[index]) others.push_back(m_scans[other]);
        const LiveKeyScan& scan = m_scans[index];
        const LocalMap local = localMap(others, scan.pose.scanInMap, m_settings.local);
        Step step;
        step.measured = step.trusted = true;  // what surfaces leave open stays as it is
        const Match found = match(scan.reduced->unpacked(), local, scan.pose.scanInMap, step, scan.up,
                                  m_settings.match, m_settings.fit, m_how.schedule);
        if (found.doubts != 0) return matched;
        LiveKeyScan there = scan;
        there.pose.scanInMap = found.scanInMap;
        std::vector<LiveKeyScan> against;
        for (const std::uint64_t id : local.scans) {
            against.push_back(*std::find_if(others.begin(), others.end(),
                                            [id](const LiveKeyScan& other) { return other.id == id; }));
        }
        beginWithOlder(against, scan.id, static_cast<std::size_t>(m_settings.loops.linksAScan));
        matched.links = linksOf({there, nullptr, against, found}, m_settings.loops, m_settings.match);
        matched.rms = found.icp.rms;
        return matched;
    }

    [[nodiscard]] std::vector<Matched> matchAll(int round, const Progress& progress) const {
        std::vector<Matched> matched(m_scans.size());
        constexpr std::size_t AtOnce = 64;  // between two checks for cancellation
        for (std::size_t first = 0; first < m_scans.size() && !progress.cancelled(); first += AtOnce) {
            const std::size_t count = std::min(AtOnce, m_scans.size() - first);
            parallelFor(count, 1, m_how.threads, [&](std::size_t from, std::size_t to) {
                for (std::size_t i = first + from; i < first + to; ++i) {
                    if (!m_near[i].empty()) matched[i] = matchOne(i);
                }
            });
            const double share = double(first + count) / double(m_scans.size());
            progress.done((round + share) / m_how.rounds);
        }
        return matched;
    }

    void take(const std::vector<Matched>& matched, Relaxation& result) const {
        result.matches.clear();
        result.replaced.clear();
        result.matched = 0;
        double sum = 0.0;
        std::set<std::uint64_t> held;  // by their new matches alone
        for (std::size_t i = 0; i < matched.size(); ++i) {
            const Matched& one = matched[i];
            if (one.links.empty()) continue;
            ++result.matched;
            sum += one.rms * one.rms;
            if (holdsOnOlder(one.links)) held.insert(m_scans[i].id);
            result.matches.insert(result.matches.end(), one.links.begin(), one.links.end());
        }
        for (const Link& link : m_links) {
            if (link.active && link.kind == LinkKind::Match && held.contains(link.to))
                result.replaced.push_back(link.id);
        }
        result.rmsAfter = result.matched > 0 ? std::sqrt(sum / double(result.matched)) : 0.0;
        if (result.rounds == 0) result.rmsBefore = result.rmsAfter;
    }

    /// Moves all scans to where the newest matches fit best. Returns the farthest shift [m].
    double moveAll(Relaxation& result, const Progress& progress) {
        PoseGraph graph;
        const std::set<std::uint64_t> replaced(result.replaced.begin(), result.replaced.end());
        for (const LiveKeyScan& scan : m_scans) graph.nodes.push_back({scan.id, scan.pose.scanInMap, false});
        for (const Link& link : m_links) {
            // For a scan that fits, its new matches hold more than those by which it entered.
            if (link.active && !replaced.contains(link.id)) graph.links.push_back(link);
        }
        const std::size_t known = graph.links.size();
        graph.links.insert(graph.links.end(), result.matches.begin(), result.matches.end());
        GraphSettings settings;
        settings.robust = true;
        const GraphResult solved = solve(graph, settings, progress);
        constexpr double Outweighed = 0.5;
        result.contradicted.clear();
        for (std::size_t i = 0; i < known; ++i) {
            if (solved.weights[i] < Outweighed) result.contradicted.push_back(graph.links[i].id);
        }
        double farthest = 0.0;
        for (std::size_t i = 0; i < m_scans.size(); ++i) {
            Pose& pose = m_scans[i].pose.scanInMap;
            farthest = std::max(farthest, distanceBetween(pose, graph.nodes[i].pose));
            pose = graph.nodes[i].pose;
        }
        return farthest;
    }

    std::vector<LiveKeyScan> m_scans;  ///< that are not set aside, at their newest poses
    std::vector<std::vector<std::size_t>> m_near;
    const std::vector<Link> m_links;
    const LiveSettings& m_settings;
    const RelaxationSettings& m_how;
};

}  // namespace

Relaxation relax(const LiveMap& map, std::span<const Link> links, const LiveSettings& settings,
                 const RelaxationSettings& how, const Progress& progress) {
    return Relaxer(map, links, settings, how).run(progress);
}

}  // namespace leitstand
