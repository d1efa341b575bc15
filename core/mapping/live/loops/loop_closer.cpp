#include "core/mapping/live/loops/loop_closer.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "core/base/words.h"
#include "core/mapping/live/loops/free_space.h"
#include "core/mapping/live/map/local_map.h"
#include "core/mapping/live/scan_work.h"

namespace leitstand {
namespace {

constexpr std::uint64_t LinkBlock = 100'000;  ///< of link ids, for stations that do not hear each other

}  // namespace

LoopCloser::LoopCloser(const LoopSettings& settings, const MatchSettings& match, const FitSettings& fit)
    : m_settings(settings), m_match(match), m_verifier(settings, match, fit) {}

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
    for (std::vector<MatchedPlace>* some : {&m_pending, &m_met})
        std::erase_if(*some, [scan](const MatchedPlace& found) {
            return found.link.from == scan || found.link.to == scan;
        });
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
    // A scan that is not connected may be anywhere.
    return way ? m_settings.driftAtLeast + *way : std::numeric_limits<double>::infinity();
}

template <class Passed>
const LiveKeyScan* LoopCloser::nearestTo(const Pose& guess, const LiveMap& map, Passed passed) const {
    const LiveKeyScan* nearest = nullptr;
    double least = m_settings.reach;
    for (const LiveKeyScan& scan : map.scans) {
        if (!scan.counts() || passed(scan)) continue;
        const double distance = mapDistance(scan.pose.scanInMap, guess);
        if (distance < least) {
            least = distance;
            nearest = &scan;
        }
    }
    return nearest;
}

const LiveKeyScan* LoopCloser::olderAt(const LiveKeyScan& entered, const Pose& guess, const LiveMap& map,
                                       bool samePart) const {
    const std::map<std::uint64_t, double> near = sameAge(entered.id);
    return nearestTo(guess, map, [&](const LiveKeyScan& scan) {
        return near.contains(scan.id) || scan.id == entered.id || (samePart && scan.part != entered.part);
    });
}

std::optional<MatchedPlace> LoopCloser::look(const LiveKeyScan& entered, const Pose& guess,
                                             const LiveMap& map, bool samePart) const {
    const LiveKeyScan* const older = olderAt(entered, guess, map, samePart);
    if (older == nullptr || wasRefused(older->id, entered.id)) return std::nullopt;
    return look(entered, *older, guess, map);
}

template <class Passed>
LocalMap LoopCloser::localAbout(const LiveKeyScan& older, const LiveMap& map, Passed passed) const {
    const std::map<std::uint64_t, double> about = m_graph.within(older.id, m_settings.about);
    std::vector<LiveKeyScan> others;
    for (const LiveKeyScan& scan : map.scans) {
        if (scan.counts() && about.contains(scan.id) && !passed(scan)) others.push_back(scan);
    }
    return localMap(others, older.pose.scanInMap);
}

std::optional<MatchedPlace> LoopCloser::look(const LiveKeyScan& entered, const LiveKeyScan& older,
                                             const Pose& guess, const LiveMap& map) const {
    const std::map<std::uint64_t, double> near = sameAge(entered.id);
    const LocalMap local =
        localAbout(older, map, [&](const LiveKeyScan& scan) { return near.contains(scan.id); });
    return m_verifier.verify(entered, older, local, guess);
}

bool LoopCloser::fitsBeside(const MatchedPlace& found, const LiveKeyScan& entered, const LiveMap& map) const {
    const double expected = m_settings.askBeyond * deviation(found.link.from, found.link.to);
    const double within = std::min(m_settings.reach, std::max(expected, found.shift()));
    const auto older = std::find_if(map.scans.begin(), map.scans.end(),
                                    [&](const LiveKeyScan& scan) { return scan.id == found.link.from; });
    if (older == map.scans.end() || !PlaceVerifier::mayFitBeside(found, within)) return false;
    const std::map<std::uint64_t, double> near = sameAge(entered.id);
    const LocalMap local =
        localAbout(*older, map, [&](const LiveKeyScan& scan) { return near.contains(scan.id); });
    return m_verifier.fitsBeside(found, entered, *older, local, within);
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
    return shift > m_settings.farBeyond * deviation(found.link.from, found.link.to) ||
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
        !found.far && shift <= m_settings.askBeyond * deviation(found.link.from, found.link.to);
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
    std::optional<MatchedPlace> found = look(entered, entered.pose.scanInMap, map, true);
    if (found && Eigen::AngleAxisd(found->correction.linear()).angle() <= m_settings.nearTurn) {
        if (fitsBeside(*found, entered, map)) return {};
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
    std::optional<MatchedPlace> found = look(entered, scanInMap, map, false);
    if (!found || tooFar(*found) || wasAsked(*found, map)) return {};
    found->far = true;
    return meet(std::move(*found), verified);
}

bool LoopCloser::mayErrFar(const LiveKeyScan& scan, const LiveMap& map) const {
    const std::map<std::uint64_t, double> near = sameAge(scan.id);
    const auto earliest = std::find_if(map.scans.begin(), map.scans.end(), [&](const LiveKeyScan& one) {
        return one.counts() && one.part == scan.part && !near.contains(one.id);
    });
    return earliest != map.scans.end() &&
           m_settings.farBeyond * deviation(earliest->id, scan.id) > m_settings.reach;
}

bool LoopCloser::seeks(const LiveKeyScan& entered, const LiveMap& map) {
    if (m_settings.seekEvery <= 0.0) return false;
    std::uint64_t& sought = m_sought[entered.scan->robot];
    const double every = inParts(map) ? m_settings.seekPartsEvery : m_settings.seekEvery;
    if (sought != 0 && m_graph.within(entered.id, every).contains(sought)) return false;
    if (!inParts(map) && !mayErrFar(entered, map)) return false;
    sought = entered.id;
    return true;
}

void LoopCloser::meetAt(const LiveKeyScan& scan, const LiveMap& map) {
    std::optional<MatchedPlace> found = look(scan, scan.pose.scanInMap, map, true);
    if (!found || found->shift() > m_settings.askBeyond * deviation(found->link.from, found->link.to)) return;
    if (!fitsBeside(*found, scan, map)) m_met.push_back(std::move(*found));
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

std::vector<Link> LoopCloser::join(const std::map<std::uint64_t, Pose>& scansInMap, const LiveMap& map) {
    std::vector<Link> links;
    for (const LiveKeyScan& scan : map.scans) {
        const auto there = scansInMap.find(scan.id);
        if (there == scansInMap.end() || !scan.counts()) continue;
        std::optional<MatchedPlace> found = look(scan, there->second, map, false);
        if (found && found->link.kind == LinkKind::Session) links.push_back(std::move(found->link));
    }
    if (links.size() < m_settings.partsAgree) return {};
    // The graph stays as it was until all are found.
    for (Link& link : links) link = m_graph.add(std::move(link));
    m_pending.clear();
    return links;
}

std::vector<Link> LoopCloser::moveTo(const std::map<std::uint64_t, Pose>& scansInMap,
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
        if (const LiveKeyScan* const other = nearestTo(there->second, map, moves))
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
            std::optional<MatchedPlace> found =
                m_verifier.verify(*one.scan, *one.other, localAbout(*one.other, map, moves), one.there);
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
    m_pending.clear();
    return links;
}

std::vector<std::size_t> LoopCloser::largestAgreeing(const std::vector<MatchedPlace>& fits,
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

Result<Link> LoopCloser::propose(const LiveKeyScan& scan, Pose guess, const LiveMap& map) {
    // Heights may have drifted: the height of the nearest storey counts.
    const std::map<std::uint64_t, double> near = sameAge(scan.id);
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
    const LiveKeyScan* const older = olderAt(scan, guess, map, false);
    if (older == nullptr)
        return Error{leitstand::fill(
            translate("leitstand::Station", "scan {}: no older part of the map is within {} m of there"),
            scan.id, m_settings.reach)};
    const std::optional<MatchedPlace> found = look(scan, *older, guess, map);
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
