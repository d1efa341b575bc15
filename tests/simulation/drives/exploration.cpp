#include "tests/simulation/drives/exploration.h"

#include <algorithm>
#include <limits>

namespace leitstand::simulation::test {
namespace {

constexpr double Near = 0.5;  ///< so far from a victim's box is a report of it [m]

/// Distance of @p place from the box of @p element, from above [m].
double fromBox(const Element& element, const Eigen::Vector3d& place) {
    const Eigen::Vector3d inside = element.pose.inverse() * place;
    const Eigen::Vector2d over =
        (inside.head<2>().cwiseAbs() - element.size.head<2>() / 2).cwiseMax(Eigen::Vector2d::Zero());
    return over.norm();
}

void take(Exploration& result, const DrivenWorld& driven, const Sighting& sighting) {
    const Eigen::Vector3d place = driven.inArena(sighting.position);
    for (const Element& element : driven.world->arena().elements) {
        if (!element.victim || element.victim->temperature < 28.0) continue;
        const double off = fromBox(element, place);
        if (off > Near) continue;
        const auto victim = std::find_if(result.victims.begin(), result.victims.end(),
                                         [&](const WarmVictim& one) { return one.name == element.name; });
        if (victim != result.victims.end() && victim->reportedAt < 0.0) {
            victim->reportedAt = driven.world->seconds();
            victim->off = off;
        }
        return;
    }
    ++result.falseReports;
}

}  // namespace

int Exploration::found() const {
    return static_cast<int>(std::count_if(victims.begin(), victims.end(),
                                          [](const WarmVictim& one) { return one.reportedAt >= 0.0; }));
}

Exploration explore(DrivenWorld& driven, SeenFloor& floor, double seconds,
                    const std::function<void()>& watch) {
    Exploration result;
    for (const Element& element : driven.world->arena().elements) {
        if (element.victim && !element.victim->hidden && element.victim->temperature >= 28.0)
            result.victims.push_back({element.name, -1.0, 0.0});
    }
    driven.pass(0.2);
    driven.ask("explore");
    std::size_t reported = driven.sightings.size();
    double waits = 0.0;
    const double begin = driven.world->seconds();
    while (driven.world->seconds() - begin < seconds) {
        driven.pass(0.1);
        floor.look(driven.robot);
        for (; reported < driven.sightings.size(); ++reported)
            take(result, driven, driven.sightings[reported]);
        if (watch) watch();
        const std::string reason = driven.reason();
        const bool held = driven.mode() == DriveMode::VictimApproach && reason.starts_with("stands");
        waits = held ? waits + 0.1 : 0.0;
        if (waits > 2.0) driven.ask("explore");
        if (driven.mode() == DriveMode::Explore && reason == "nothing is left to explore") {
            result.ended = reason;
            break;
        }
        if (driven.mode() != DriveMode::Explore && driven.mode() != DriveMode::VictimApproach) {
            result.ended = toString(driven.mode()) + ": " + reason;
            break;
        }
    }
    result.seconds = driven.world->seconds() - begin;
    result.seen = floor.share();
    result.bumps = driven.bumps();
    return result;
}

}  // namespace leitstand::simulation::test
