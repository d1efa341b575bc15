#include "core/mapping/live/loops/hand_links.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

#include "core/base/words.h"

namespace leitstand {

std::vector<Link> HandLinks::join(const std::map<std::uint64_t, Pose>& scansInMap, const LiveMap& map) {
    std::vector<Link> links;
    for (const LiveKeyScan& scan : map.scans) {
        const auto there = scansInMap.find(scan.id);
        if (there == scansInMap.end() || !scan.counts()) continue;
        std::optional<MatchedPlace> found = m_places.look(scan, there->second, map, false);
        if (found && found->link.kind == LinkKind::Session) links.push_back(std::move(found->link));
    }
    if (links.size() < m_settings.partsAgree) return {};
    // The graph stays as it was until all are found.
    for (Link& link : links) link = m_graph.add(std::move(link));
    return links;
}

std::vector<Link> HandLinks::moveTo(const std::map<std::uint64_t, Pose>& scansInMap,
                                    const std::set<std::uint64_t>& left, const LiveMap& map) {
    const auto moves = [&](const LiveKeyScan& scan) {
        return scansInMap.contains(scan.id) || left.contains(scan.id);
    };
    struct Candidate {
        const LiveKeyScan* scan;
        const LiveKeyScan* other;
        Pose there;
    };
    std::vector<Candidate> candidates;
    for (const LiveKeyScan& scan : map.scans) {
        const auto there = scansInMap.find(scan.id);
        if (there == scansInMap.end() || !scan.counts()) continue;
        if (const LiveKeyScan* const other = m_places.nearestTo(there->second, map, moves))
            candidates.push_back({&scan, other, there->second});
    }
    // A match takes as long as a scan that enters, and delays these. Every other one first, then those
    // between.
    const std::size_t tries = std::min(candidates.size(), 2 * m_settings.mostByHand);
    std::vector<MatchedPlace> fits;
    std::vector<Pose> off;  // by how much each is off from where it was left, to put before poses in the map
    for (const std::size_t begin : {std::size_t{0}, std::size_t{1}}) {
        for (std::size_t i = begin; i < tries && fits.size() < m_settings.mostByHand; i += 2) {
            const Candidate& one = candidates[i * candidates.size() / tries];
            std::optional<MatchedPlace> found = m_places.look(*one.scan, *one.other, one.there, map, moves);
            if (!found) continue;
            off.push_back(found->correction * (one.there * one.scan->pose.scanInMap.inverse()).inverse());
            fits.push_back(std::move(*found));
        }
    }
    const std::vector<std::size_t> agreeing = largestAgreeing(fits, off);
    if (agreeing.size() < std::min(m_settings.partsAgree, candidates.size())) return {};
    std::vector<Link> links;
    for (const std::size_t index : agreeing) {
        Link link = std::move(fits[index].link);
        link.kind = LinkKind::Operator;
        links.push_back(m_graph.add(std::move(link)));
    }
    return links;
}

std::vector<std::size_t> HandLinks::largestAgreeing(const std::vector<MatchedPlace>& fits,
                                                    const std::vector<Pose>& off) const {
    std::vector<std::size_t> most;
    for (std::size_t i = 0; i < fits.size(); ++i) {
        std::vector<std::size_t> agreeing;
        for (std::size_t j = 0; j < fits.size(); ++j) {
            const Eigen::Vector3d at = fits[j].correction * fits[j].at;
            const Pose difference = off[i].inverse() * off[j];
            // A part that was dragged bends along its length.
            const double within =
                m_settings.agreeWithin + m_settings.drift * (fits[i].at - fits[j].at).norm();
            if ((off[i] * at - off[j] * at).norm() <= within &&
                Eigen::AngleAxisd(difference.linear()).angle() <= m_settings.agreeWithinAngle)
                agreeing.push_back(j);
        }
        if (agreeing.size() > most.size()) most = std::move(agreeing);
    }
    return most;
}

Result<Link> HandLinks::propose(const LiveKeyScan& scan, Pose guess, const LiveMap& map) {
    // Heights may have drifted: the height of the nearest storey counts.
    const std::map<std::uint64_t, double> near = m_graph.sameAge(scan.id);
    const double height = guess.translation().z();
    double least = std::numeric_limits<double>::infinity();
    for (const LiveKeyScan& other : map.scans) {
        const Eigen::Vector3d there = other.pose.scanInMap.translation();
        const bool about = (there - guess.translation()).head<2>().norm() < m_settings.reach;
        if (!other.counts() || near.contains(other.id) || !about || std::abs(there.z() - height) >= least)
            continue;
        least = std::abs(there.z() - height);
        guess.translation().z() = there.z();
    }
    const LiveKeyScan* const older = m_places.olderAt(scan, guess, map, false);
    if (older == nullptr)
        return Error{leitstand::fill(
            translate("leitstand::Station", "scan {}: no older part of the map is within {} m of there"),
            scan.id, m_settings.reach)};
    const std::optional<MatchedPlace> found = m_places.look(scan, *older, guess, map);
    if (!found)
        return Error{leitstand::fill(
            translate("leitstand::Station",
                      "scan {} does not fit there: draw it nearer to where it was, or it is another place"),
            scan.id)};
    Link link = found->link;
    link.active = false;
    return m_graph.add(std::move(link));
}

}  // namespace leitstand
