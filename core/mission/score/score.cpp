#include "core/mission/score/score.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/event/find_sample.h"
#include "core/event/map_samples.h"
#include "core/event/scan_pose.h"
#include "core/event/station_samples.h"
#include "core/mission/finds/find_book.h"
#include "core/mission/state/find_state.h"
#include "core/mission/state/scan_state.h"
#include "core/mission/state/session_state.h"

namespace leitstand {
namespace {

bool stated(const VictimSign& sign) {
    return sign.state != VictimSign::State::Unknown;
}

bool stated(const FindSample& victim, ScoreItem item) {
    switch (item) {
        case ScoreItem::Map:
        case ScoreItem::Location:
            return victim.positionInMap.allFinite();
        case ScoreItem::Form:
            return stated(victim.form);
        case ScoreItem::Motion:
            return stated(victim.motion);
        case ScoreItem::Heat:
            return stated(victim.heat);
        case ScoreItem::Sound:
            return stated(victim.sound);
        case ScoreItem::Co2:
            return stated(victim.co2);
        case ScoreItem::Situation:
            return !victim.situation.empty();
        case ScoreItem::Tag:
            return !victim.tag.empty();
    }
    return false;
}

double factorOf(const ScoreProfile& profile, Autonomy autonomy) {
    if (autonomy == Autonomy::Full) return profile.autonomous;
    return autonomy == Autonomy::Semi ? profile.semiAutonomous : 1.0;
}

double divisorOf(OperatorRule rule, std::uint32_t operators) {
    const double count = std::max<std::uint32_t>(operators, 1);
    if (rule == OperatorRule::Count) return count;
    return rule == OperatorRule::SquaredOfMore ? (1.0 + count) * (1.0 + count) : 1.0;
}

/// Returns the number of operators from the mission's data, otherwise from the newest session.
std::uint32_t operatorsOf(const MissionState& state) {
    if (state.info) return state.info->sample.operators;
    return state.sessions->empty() ? 1 : state.sessions->back().session.operators;
}

double worth(const ScoreProfile& profile, FindSample::Kind kind) {
    if (kind == FindSample::Kind::Hazard) return profile.hazard;
    return kind == FindSample::Kind::Code ? profile.code : profile.object;
}

ScoredFind scored(const ScoreProfile& profile, const MissionState& state, const FindSample& sample) {
    ScoredFind find;
    find.find = {sample.kind, sample.number};
    find.name = nameOf(sample.kind, sample.number);
    find.confirmed = sample.status == FindSample::Status::Confirmed;
    if (sample.kind == FindSample::Kind::Victim) {
        for (const auto& [item, points] : profile.points) {
            find.items.push_back({item, stated(sample, item) ? points : 0.0, points});
            find.points += find.items.back().points;
        }
    } else {
        find.points = worth(profile, sample.kind);
    }
    const std::string& area = sample.area.empty() && state.info ? state.info->sample.area : sample.area;
    const auto weight = profile.areas.find(area);
    if (weight != profile.areas.end()) find.weight = weight->second;
    if (weight == profile.areas.end()) find.unweighed = area;
    find.autonomy = autonomyOf(sample);
    find.factor = factorOf(profile, find.autonomy);
    find.total = find.confirmed ? find.points * find.weight * find.factor : 0.0;
    return find;
}

/// Returns the middles of confirmed victims in the map [m].
std::vector<Eigen::Vector3d> victimPlaces(const MissionState& state) {
    std::vector<Eigen::Vector3d> places;
    for (const auto& [key, victim] : *state.finds) {
        if (key.first == FindSample::Kind::Victim && victim.victim.status == FindSample::Status::Confirmed)
            places.push_back(positionInMap(state, victim.victim));
    }
    return places;
}

void countBumps(const MissionState& state, const Footprints& footprints, ScoreResult& result) {
    const auto victims = victimPlaces(state);
    for (const auto& [name, robot] : state.robots) {
        const auto known = footprints.find(name);
        const std::vector<Eigen::Vector2d> footprint =
            known == footprints.end() ? std::vector<Eigen::Vector2d>() : known->second;
        for (const Contact& contact : robot->contacts) {
            const auto odometry = victims.empty() ? std::nullopt : odomInMap(state, name, contact.received);
            const bool victim =
                contact.baseInOdom && odometry &&
                std::any_of(victims.begin(), victims.end(), [&](const Eigen::Vector3d& one) {
                    return touches(*odometry * *contact.baseInOdom, footprint, contact.bumper, one);
                });
            (victim ? result.victimBumps : result.areaBumps) += contact.hits;
        }
    }
}

std::vector<ScoreAdvice> advised(const ScoreResult& result) {
    std::vector<ScoreAdvice> all;
    for (const ScoredFind& find : result.finds) {
        const double share = find.weight * find.factor / result.divisor;
        if (!find.confirmed && find.points > 0.0) {
            all.push_back({find.find, find.name, std::nullopt, find.points * share});
        }
        for (const ScoredItem& item : find.items) {
            if (!find.confirmed || item.points >= item.possible) continue;
            all.push_back({find.find, find.name, item.item, (item.possible - item.points) * share});
        }
    }
    std::stable_sort(all.begin(), all.end(),
                     [](const ScoreAdvice& a, const ScoreAdvice& b) { return a.gain > b.gain; });
    return all;
}

}  // namespace

Autonomy autonomyOf(const FindSample& find) {
    if (!find.autonomous) return Autonomy::Teleoperated;
    const bool sighted = std::any_of(find.evidence.begin(), find.evidence.end(),
                                     [](const VictimEvidence& one) { return one.kind == "sighting"; });
    return sighted ? Autonomy::Full : Autonomy::Semi;
}

std::optional<Pose> odomInMap(const MissionState& state, const std::string& robot, Time moment) {
    std::optional<Pose> place;
    for (const auto& [id, scan] : *state.keyScans) {
        if (scan.entry.robot != robot || !scan.entry.sensorInOdom || scan.pose.trust == ScanTrust::SetAside)
            continue;
        if (place && scan.entry.stamp > moment) break;
        place = scan.pose.scanInMap * scan.entry.sensorInOdom->inverse();
    }
    if (place) return place;
    const auto known = state.robots.find(robot);
    if (known == state.robots.end() || !known->second->place) return std::nullopt;
    return known->second->place->sample.odomInMap;
}

ScoreResult score(const ScoreProfile& profile, const MissionState& state, const Footprints& footprints) {
    ScoreResult result;
    result.operators = operatorsOf(state);
    result.divisor = divisorOf(profile.operators, result.operators);
    for (const auto& [key, victim] : *state.finds) {
        if (victim.victim.status == FindSample::Status::Discarded) continue;
        result.finds.push_back(scored(profile, state, wholeFind(state, key).value_or(victim.victim)));
        result.sum += result.finds.back().total;
    }
    for (const ScoredFind& find : result.finds) {
        if (!find.unweighed.empty()) result.unweighed.insert(find.unweighed);
    }
    countBumps(state, footprints, result);
    result.penalty = static_cast<double>(result.areaBumps) * profile.areaBump +
                     static_cast<double>(result.victimBumps) * profile.victimBump;
    result.score = (result.sum - result.penalty) / result.divisor;
    result.advice = advised(result);
    return result;
}

}  // namespace leitstand
