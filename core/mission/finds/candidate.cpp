#include "core/mission/finds/candidate.h"

#include <algorithm>
#include <chrono>
#include <cmath>

#include <Eigen/LU>

namespace leitstand {
namespace {

constexpr std::chrono::milliseconds Moment(450);
constexpr double Correlated = 4.0;  // more cues of one look add nothing
constexpr int Rounds = 4;           // of weighting down looks that do not fit
constexpr double Doubt = 4.0;       // squared deviations from which a look counts half
constexpr std::size_t MostCues = 24;
constexpr double ArmsLength = 0.3;  // distance of a tag from its body's middle [m]

/// Whether cues of @p kind have a place, and do not only show that something is near.
bool places(const std::string& kind) {
    return kind != "co2";
}

double sureness(const Cue& cue, double unknown) {
    return std::isfinite(cue.confidence) ? std::clamp(cue.confidence, 0.0, 1.0) : unknown;
}

struct Evidence {
    double sum = 0.0;
    int cues = 0, moments = 0;
    [[nodiscard]] double mean() const { return cues > 0 ? sum / cues : 0.0; }
};

}  // namespace

void CandidateThing::add(const PlacedCue& cue, const ScanPlaces& scans) {
    const bool code = cue.what != FindSample::Kind::Victim || cue.cue.kind == "code" || cue.cue.kind == "tag";
    const std::string text = code || cue.cue.kind == "sighting" ? cue.cue.text : std::string();
    CandidateLook& look = looks[{cue.cue.kind, cue.cue.robot, cue.scan, text}];
    const auto scan = scans.find(cue.scan);
    const Pose mapInScan = scan == scans.end() ? Pose::Identity() : scan->second.inverse();
    const Eigen::Matrix3d turn = mapInScan.linear();
    const double sure = sureness(cue.cue, 0.5), weight = 0.05 + sure;
    const double share = weight / (look.weight + weight);
    look.inScan += share * (mapInScan * cue.inMap - look.inScan);
    if (cue.from.allFinite()) {
        const Eigen::Vector3d from = mapInScan * cue.from;
        look.fromInScan = look.fromInScan.allFinite()
                              ? Eigen::Vector3d(look.fromInScan + share * (from - look.fromInScan))
                              : from;
    }
    if (look.cues == 0) look.covariance.setZero();
    look.covariance += share * (turn * cue.covariance * turn.transpose() - look.covariance);
    look.weight = std::min(look.weight + weight, 20.0);
    look.evidence += sure;
    if (look.cues == 0 || sure > look.strongest) {
        look.best = cue.cue;
        look.strongest = sure;
    }
    ++look.cues;
    if (look.moments > 0 && cue.cue.stamp < look.moment + Moment && cue.cue.stamp + Moment > look.moment)
        return;
    ++look.moments;
    look.moment = cue.cue.stamp;
}

void CandidateThing::settle(const ScanPlaces& scans, const CandidateSettings& settings) {
    struct Seen {
        Eigen::Vector3d inMap;
        Eigen::Matrix3d information;
        double weight;
        std::uint64_t scan;
    };
    std::vector<Seen> seen;
    const bool victims = what == FindSample::Kind::Victim;
    const auto isOf = [](const auto& look, const char* kind) { return std::get<0>(look.first) == kind; };
    // A tag beside a victim is not the victim. It gives the place only when nothing else does.
    const bool tagAlone =
        victims && std::none_of(looks.begin(), looks.end(), [&](const auto& look) {
            return places(std::get<0>(look.first)) && !isOf(look, "code") && !isOf(look, "tag");
        });
    const double body = !victims ? 0.02 : tagAlone ? ArmsLength : settings.body;
    for (const auto& [key, look] : looks) {
        const std::string& kind = std::get<0>(key);
        if (!places(kind) || (victims && kind == "code") || (victims && kind == "tag" && !tagAlone)) continue;
        const auto scan = scans.find(std::get<2>(key));
        const Pose pose = scan == scans.end() ? Pose::Identity() : scan->second;
        const Eigen::Matrix3d turn = pose.linear();
        Eigen::Matrix3d covariance = turn * look.covariance * turn.transpose();
        covariance /= std::min<double>(look.cues, Correlated);
        covariance += body * body * Eigen::Matrix3d::Identity();
        const double weight = std::max(0.05, look.evidence / look.cues);
        seen.push_back({pose * look.inScan, covariance.inverse(), weight, std::get<2>(key)});
    }
    confidence = confidenceOf(*this, settings);
    if (seen.empty()) return;
    std::vector<double> fits(seen.size(), 1.0);
    for (int round = 0; round < Rounds; ++round) {
        Eigen::Matrix3d information = Eigen::Matrix3d::Zero();
        Eigen::Vector3d sum = Eigen::Vector3d::Zero();
        double most = -1.0;
        for (std::size_t i = 0; i < seen.size(); ++i) {
            const Eigen::Matrix3d part = fits[i] * seen[i].weight * seen[i].information;
            information += part;
            sum += part * seen[i].inMap;
            if (part.trace() > most) {
                most = part.trace();
                scan = seen[i].scan;
            }
        }
        covariance = information.inverse();
        inMap = covariance * sum;
        for (std::size_t i = 0; i < seen.size(); ++i) {
            const Eigen::Vector3d off = seen[i].inMap - inMap;
            fits[i] = 1.0 / (1.0 + off.dot(seen[i].information * off) / Doubt);
        }
    }
}

double squaredDeviations(const Eigen::Vector3d& off, const Eigen::Matrix3d& covariance) {
    const Eigen::Matrix2d flat = covariance.topLeftCorner<2, 2>();
    const double determinant = flat.determinant();
    if (!(determinant > 0.0)) return std::numeric_limits<double>::infinity();
    return (off.x() * (flat(1, 1) * off.x() - flat(0, 1) * off.y()) +
            off.y() * (flat(0, 0) * off.y() - flat(1, 0) * off.x())) /
           determinant;
}

double confidenceOf(const CandidateThing& thing, const CandidateSettings& settings) {
    std::map<std::string, Evidence> kinds;
    for (const auto& [key, look] : thing.looks) {
        Evidence& kind = kinds[std::get<0>(key)];
        kind.sum += look.evidence;
        kind.cues += look.cues;
        kind.moments += look.moments;
    }
    const auto counted = [&](const std::string& kind) {
        const auto found = kinds.find(kind);
        if (found == kinds.end()) return 0.0;
        return found->second.mean() *
               std::min(1.0, static_cast<double>(found->second.moments) / settings.moments);
    };
    if (thing.what == FindSample::Kind::Code) return kinds.contains("code") ? 0.95 : 0.0;
    if (thing.what != FindSample::Kind::Victim) {
        // Colours in a square seldom occur by chance, so half of the moments suffice.
        const auto found = kinds.find("hazard");
        if (found == kinds.end()) return 0.0;
        const double often = std::min(1.0, 2.0 * found->second.moments / settings.moments);
        return often * (0.3 + 0.65 * found->second.mean());
    }
    const double sighting = kinds.contains("sighting") ? 0.45 * kinds.at("sighting").mean() : 0.0;
    const double warm = std::max(0.85 * counted("heat"), sighting);
    const double motion = 0.45 * std::min(1.0, 1.5 * counted("motion"));
    // CO2 near by supports only what could be a person: a lamp beside a victim stays a lamp.
    const double agrees = std::min(1.0, std::max(warm, motion) / settings.breathFrom);
    const double breath = 0.55 * agrees * counted("co2");
    double tag = kinds.contains("code") ? 0.2 : 0.0;
    if (kinds.contains("tag"))
        tag = std::max(tag, settings.tagged * std::min(1.0, static_cast<double>(kinds.at("tag").moments) /
                                                                settings.tagMoments));
    return 1.0 - (1.0 - warm) * (1.0 - motion) * (1.0 - breath) * (1.0 - tag);
}

std::string CandidateThing::text() const {
    std::map<std::string, double> votes;
    for (const auto& [key, look] : looks) {
        if (!look.best.text.empty() && std::get<0>(key) != "sighting") votes[look.best.text] += look.evidence;
    }
    const auto most = std::max_element(votes.begin(), votes.end(),
                                       [](const auto& a, const auto& b) { return a.second < b.second; });
    return most == votes.end() ? std::string() : most->first;
}

std::string CandidateThing::tag() const {
    const CandidateLook* most = nullptr;
    for (const auto& [key, look] : looks) {
        if (std::get<0>(key) == "tag" && (most == nullptr || look.evidence > most->evidence)) most = &look;
    }
    return most == nullptr ? std::string() : most->best.text;
}

std::vector<Cue> CandidateThing::cues() const {
    // The surest of each kind, robot and text.
    std::map<std::tuple<std::string, std::string, std::string>, const CandidateLook*> best;
    for (const auto& [key, look] : looks) {
        const CandidateLook*& one = best[{std::get<0>(key), std::get<1>(key), std::get<3>(key)}];
        if (one == nullptr || look.strongest > one->strongest) one = &look;
    }
    std::vector<Cue> list;
    for (const auto& [key, look] : best) {
        if (list.size() < MostCues) list.push_back(look->best);
    }
    return list;
}

double CandidateThing::deviation() const {
    return std::sqrt(std::max(0.0, covariance.trace() / 3.0));
}

}  // namespace leitstand
