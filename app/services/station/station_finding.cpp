// How a station searches for victims, what it searched, and how it files what is found.

#include <algorithm>
#include <chrono>
#include <cmath>
#include <utility>

#include "app/services/coverage/logged_views.h"
#include "app/services/log/sequencer.h"
#include "app/services/places/mission_map.h"
#include "app/services/station/station_state.h"
#include "core/base/words.h"
#include "core/event/station_topics.h"
#include "core/io/settings/score_file.h"
#include "core/mission/finds/find_book.h"
#include "core/mission/state/find_state.h"

namespace leitstand {
void Station::State::fileAgain(FindSample find) {
    const std::string before = nameOf(find.kind, find.number);
    // Several may be filed again before the mission has the first of them.
    std::uint32_t& last = filedAgain[find.kind];
    last = std::max(last + 1, nextNumber(*mission->state(), find.kind));
    find.number = last;
    find.stamp = std::max(stationTime(), find.stamp + std::chrono::nanoseconds(1));
    if (const auto kept = mission->record(find, station_topic::Victims); !kept)
        return notify(kept.error().text);
    notify(leitstand::fill(
        translate("leitstand::Station", "{} of another station was found first: this station's {} is {} now"),
        before, before, nameOf(find.kind, find.number)));
}

void Station::State::file() {
    FindDeskSetup setup;
    setup.robots = settings.mission.robots;
    setup.station = memory->identity().id;
    setup.mission = [this] { return mission->state(); };
    setup.record = [this](const FindSample& find) { return mission->record(find, station_topic::Victims); };
    setup.recordCandidate = [this](const CandidateSample& candidate) {
        return mission->record(candidate, station_topic::Candidates);
    };
    setup.undo = [this](const UndoSample& undo) { return mapping->takeBack(undo); };
    setup.locate = [this](const ChosenEvidence& chosen, FindDeskSetup::Located answer) {
        victims->locate(
            {*chosen.picture, chosen.pixel, chosen.width, chosen.height, chosen.halfAngle},
            [answer = std::move(answer)](const std::optional<PlacedCue>& cue) {
                if (!cue) return answer(std::nullopt);
                answer(PlacedFind{cue->scan, cue->inMap, std::sqrt(cue->covariance.trace() / 3.0)});
            });
    };
    setup.shows = [this](std::vector<Event> pictures, const Eigen::Vector3d& inMap,
                         FindDeskSetup::Shown answer) {
        victims->seen(std::move(pictures), inMap, std::move(answer));
    };
    setup.robotInMap = [this](const std::string& robot) -> std::optional<Pose> {
        const RobotsInMapPtr placed = mapping->robots();
        for (const RobotInMap& one : *placed) {
            if (one.robot == robot && one.placed) return one.baseInMap;
        }
        return std::nullopt;
    };
    setup.notify = [this](const std::string& text) { notify(text); };
    setup.now = [] { return stationTime(); };
    finds = std::make_unique<FindDesk>(std::move(setup));
}

void Station::State::search() {
    VictimWatchSetup setup;
    setup.robots = settings.mission.robots;
    setup.station = memory->identity().id;
    setup.maySearch = [this] { return grants->mayAct(MapGrant); };
    setup.poses = [this] { return posesOf(*mission->state()); };
    setup.places = [this] { return mapping->robots(); };
    setup.earlierPoses = setup.poses();
    const MissionStatePtr now = mission->state();
    for (const auto& [id, known] : *now->candidates) setup.earlier.push_back(known.candidate);
    setup.finds = [this] {
        std::vector<FindSample> finds;
        const MissionStatePtr newest = mission->state();
        for (const auto& [key, known] : *newest->finds) finds.push_back(known.victim);
        return finds;
    };
    for (const ScoreProfile& profile : scoreProfiles().profiles)
        setup.tags.byName[profile.name] = profile.victimTags;
    if (now->info) setup.profile = now->info->sample.profile;
    setup.onCandidate = [this](const CandidateSample& found) {
        if (const auto kept = mission->record(found, station_topic::Candidates); !kept)
            notify(kept.error().text);
    };
    victims = std::make_unique<VictimWatch>(std::move(setup));
}

void Station::State::cover(std::vector<KeyScanSample> earlier) {
    CoverageWatchSetup setup;
    setup.robots = settings.mission.robots;
    setup.places = [this]() -> RobotsInMapPtr { return open ? mapping->robots() : nullptr; };
    setup.poses = [this] { return posesOf(*mission->state()); };
    if (!earlier.empty()) {
        setup.earlierViews = [folder = settings.mission.folder](const std::stop_token& stop) {
            return loggedViews(folder, {.report = {}, .stop = stop}).views;
        };
    }
    setup.earlier = std::move(earlier);
    setup.notify = [this](const std::string& text) { notify(text); };
    coverage = std::make_unique<CoverageWatch>(std::move(setup));
}

}  // namespace leitstand
