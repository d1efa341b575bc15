#include "core/mapping/live/loops/loop_closer.h"

#include <algorithm>
#include <cstddef>
#include <optional>
#include <utility>

namespace leitstand {

void LoopCloser::forget(std::uint64_t scan) {
    for (std::vector<MatchedPlace>* some : {&m_pending, &m_met})
        std::erase_if(*some, [scan](const MatchedPlace& found) {
            return found.link.from == scan || found.link.to == scan;
        });
}

bool LoopCloser::agree(const MatchedPlace& a, const MatchedPlace& b) const {
    const Pose difference = a.correction.inverse() * b.correction;
    const Eigen::Vector3d shift = difference * b.at - b.at;
    return (a.at - b.at).norm() >= m_settings.apart && shift.norm() <= m_settings.agreeWithin &&
           Eigen::AngleAxisd(difference.linear()).angle() <= m_settings.agreeWithinAngle;
}

bool LoopCloser::tooFar(const MatchedPlace& found) const {
    if (found.link.kind == LinkKind::Session) return false;  // the relative pose of the two parts was unknown
    const double shift = found.shift();
    return shift > m_settings.farBeyond * m_graph.deviation(found.link.from, found.link.to) ||
           Eigen::AngleAxisd(found.correction.linear()).angle() > m_settings.farTurn;
}

bool LoopCloser::wasAsked(const MatchedPlace& found, const LiveMap& map) const {
    const auto poseOf = [&](std::uint64_t id) -> std::optional<Pose> {
        for (const LiveKeyScan& scan : map.scans) {
            if (scan.id == id) return scan.pose.scanInMap;
        }
        return std::nullopt;
    };
    return std::any_of(m_graph.links().begin(), m_graph.links().end(), [&](const Link& link) {
        if (link.active || !closesLoop(link.kind)) return false;
        const auto from = poseOf(link.from), to = poseOf(link.to);
        if (!from || !to) return false;
        const Pose correction = *from * link.pose * to->inverse();
        const double apart = (correction * found.at - found.correction * found.at).norm();
        return apart < m_settings.reach && angleBetween(correction, found.correction) < degrees(15);
    });
}

std::vector<Link> LoopCloser::meet(MatchedPlace found, bool verified) {
    std::vector<const MatchedPlace*> agreeing;
    for (const MatchedPlace& other : m_pending) {
        const bool all = std::all_of(agreeing.begin(), agreeing.end(),
                                     [&](const MatchedPlace* one) { return agree(*one, other); });
        if (other.robot == found.robot && other.met == found.met && agree(other, found) &&
            (all || !found.far))
            agreeing.push_back(&other);
    }
    const bool parts = found.link.kind == LinkKind::Session;
    const std::size_t wanted = parts ? m_settings.partsAgree : found.far ? m_settings.farAgree : 2;
    // The relative pose of parts is a question, once nothing that is known contradicts it.
    if (agreeing.size() + 1 < wanted || (parts && !verified)) {
        const bool apart = std::all_of(m_pending.begin(), m_pending.end(), [&](const MatchedPlace& other) {
            return (other.at - found.at).norm() >= 0.5 * m_settings.apart;
        });
        if (apart) m_pending.push_back(std::move(found));
        return {};
    }
    std::vector<Link> links;
    for (const MatchedPlace* const one : agreeing) links.push_back(one->link);
    links.push_back(found.link);
    const double shift = found.shift();
    const bool expected =
        !found.far && shift <= m_settings.askBeyond * m_graph.deviation(found.link.from, found.link.to);
    for (Link& link : links) {
        link.active = expected;
        link = m_graph.add(std::move(link));
    }
    m_pending.clear();
    return links;
}

std::vector<Link> LoopCloser::close(const LiveKeyScan& entered, const LiveMap& map) {
    const Eigen::Vector3d here = entered.pose.scanInMap.translation();
    const std::string& robot = entered.scan->robot;
    std::erase_if(m_pending, [&](const MatchedPlace& other) {
        return other.robot == robot && (other.at - here).norm() > m_settings.pendingWithin;
    });
    std::optional<MatchedPlace> found = m_places.look(entered, entered.pose.scanInMap, map, true);
    if (found && Eigen::AngleAxisd(found->correction.linear()).angle() <= m_settings.nearTurn) {
        if (m_places.fitsBeside(*found, entered, map)) return {};
        return meet(std::move(*found), false);
    }
    const auto far = std::find_if(m_pending.rbegin(), m_pending.rend(), [&](const MatchedPlace& other) {
        return other.far && other.robot == robot;
    });
    if (far == m_pending.rend()) return {};
    return closeFar(entered, far->correction * entered.pose.scanInMap, map, false);
}

std::vector<Link> LoopCloser::closeFar(const LiveKeyScan& entered, const Pose& scanInMap, const LiveMap& map,
                                       bool verified) {
    std::optional<MatchedPlace> found = m_places.look(entered, scanInMap, map, false);
    if (!found || tooFar(*found) || wasAsked(*found, map)) return {};
    found->far = true;
    return meet(std::move(*found), verified);
}

bool LoopCloser::mayErrFar(const LiveKeyScan& scan, const LiveMap& map) const {
    const std::map<std::uint64_t, double> near = m_graph.sameAge(scan.id);
    const auto earliest = std::find_if(map.scans.begin(), map.scans.end(), [&](const LiveKeyScan& one) {
        return one.counts() && one.part == scan.part && !near.contains(one.id);
    });
    return earliest != map.scans.end() &&
           m_settings.farBeyond * m_graph.deviation(earliest->id, scan.id) > m_settings.reach;
}

bool LoopCloser::seeks(const LiveKeyScan& entered, const LiveMap& map) {
    if (m_settings.seekEvery <= 0.0) return false;
    std::uint64_t& sought = m_sought[entered.scan->robot];
    const double every = inParts(map) ? m_settings.seekPartsEvery : m_settings.seekEvery;
    if (sought != 0 && m_graph.areWithin(entered.id, sought, every)) return false;
    if (!inParts(map) && !mayErrFar(entered, map)) return false;
    sought = entered.id;
    return true;
}

void LoopCloser::meetAt(const LiveKeyScan& scan, const LiveMap& map) {
    std::optional<MatchedPlace> found = m_places.look(scan, scan.pose.scanInMap, map, true);
    if (!found || found->shift() > m_settings.askBeyond * m_graph.deviation(found->link.from, found->link.to))
        return;
    if (!m_places.fitsBeside(*found, scan, map)) m_met.push_back(std::move(*found));
}

std::vector<Link> LoopCloser::takeMet() {
    const std::vector<MatchedPlace> met = std::exchange(m_met, {});
    /// Returns whether the next place by @p step of the same robot that is well apart agrees.
    const auto agrees = [&](std::size_t i, std::ptrdiff_t step) {
        for (auto j = static_cast<std::ptrdiff_t>(i) + step; j >= 0 && j < std::ssize(met); j += step) {
            const MatchedPlace& other = met[static_cast<std::size_t>(j)];
            if (other.robot != met[i].robot || (other.at - met[i].at).norm() < m_settings.apart) continue;
            return (other.at - met[i].at).norm() <= m_settings.pendingWithin && agree(met[i], other);
        }
        return false;
    };
    std::vector<Link> links;
    for (std::size_t i = 0; i < met.size(); ++i) {
        if (agrees(i, -1) || agrees(i, 1)) links.push_back(m_graph.add(met[i].link));
    }
    return links;
}

std::vector<std::uint64_t> LoopCloser::forgetMet() {
    std::vector<std::uint64_t> scans;
    for (const MatchedPlace& one : std::exchange(m_met, {})) scans.push_back(one.link.to);
    return scans;
}

}  // namespace leitstand
