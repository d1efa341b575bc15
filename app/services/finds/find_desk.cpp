#include "app/services/finds/find_desk.h"

#include <algorithm>
#include <future>
#include <map>
#include <utility>

#include <fmt/format.h>

#include "core/base/words.h"
#include "core/event/status_samples.h"
#include "core/mission/finds/dismissal.h"
#include "core/mission/state/decision.h"
#include "core/mission/state/decisions.h"
#include "core/mission/state/find_state.h"
#include "core/mission/state/undo_format.h"

namespace leitstand {
namespace {

constexpr std::chrono::seconds LongestSearch{2};  // for the place of a find
constexpr double Nearby = 1.0;           // a find without a range is placed this far ahead of the robot [m]
constexpr double NearbyDeviation = 1.0;  // [m]

}  // namespace

FindDesk::FindDesk(FindDeskSetup setup)
    : m_setup(std::move(setup)), m_thread([this](const std::stop_token& stop) { m_queue.work(stop); }) {}

void FindDesk::finish() {
    std::promise<void> done;
    m_queue.submit([&done](const std::stop_token&) { done.set_value(); }, /*cancellable=*/false);
    done.get_future().wait();
}

const RobotDescription* FindDesk::robot(const std::string& name) const {
    for (const RobotDescription& robot : m_setup.robots) {
        if (robot.name == name) return &robot;
    }
    return nullptr;
}

void FindDesk::freeze(const std::string& name, FindSample::Kind kind, const std::string& looksThrough,
                      const std::optional<PicturePoint>& at) {
    const RobotDescription* const found = robot(name);
    if (found == nullptr) return;
    const Time pressed = m_setup.now();
    // What robots send while the worker is busy has nothing to do with what the operator saw.
    submitFiling([this, found, kind, looksThrough, at, pressed,
                  recent = m_recent.of(name, pressed, at ? at->sequence : 0)] {
        ChosenEvidence chosen = chooseEvidence(*found, recent, kind, looksThrough, at);
        chosen.frozen.found = pressed;
        locate(std::move(chosen), kind);
    });
}

void FindDesk::freezeAt(const std::string& name, FindSample::Kind kind, const Eigen::Vector3d& placeInMap) {
    const RobotDescription* const found = robot(name);
    if (found == nullptr) return;
    const Time pressed = m_setup.now();
    submitFiling([this, found, kind, placeInMap, pressed, recent = m_recent.of(name, pressed)] {
        ChosenEvidence chosen = chooseEvidence(*found, recent, kind, {}, std::nullopt);
        chosen.frozen.found = pressed;
        chosen.frozen.deviation = PointedDeviation;
        const MissionStatePtr state = m_setup.mission();
        hang(chosen.frozen, *state, scanBeside(*state, found->name, placeInMap), placeInMap);
        file(std::move(chosen.frozen), kind);
    });
}

void FindDesk::submitFiling(std::function<void()> filing) {
    {
        const std::scoped_lock lock(m_mutex);
        ++m_awaited;
    }
    m_queue.submit(
        [this, filing = std::move(filing)](const std::stop_token&) {
            const std::uint64_t before = filings();
            filing();
            const std::scoped_lock lock(m_mutex);
            m_filedLast = m_filings != before;
            --m_awaited;
        },
        /*cancellable=*/false);
}

void FindDesk::locate(ChosenEvidence chosen, FindSample::Kind kind) {
    std::optional<PlacedFind> placed;
    if (chosen.picture) {
        // The callee may end before it answers.
        const auto promise = std::make_shared<std::promise<std::optional<PlacedFind>>>();
        auto answer = promise->get_future();
        m_setup.locate(chosen,
                       [promise](const std::optional<PlacedFind>& place) { promise->set_value(place); });
        if (answer.wait_for(LongestSearch) == std::future_status::ready) placed = answer.get();
    }
    const MissionStatePtr state = m_setup.mission();
    FrozenEvidence& frozen = chosen.frozen;
    if (placed) {
        frozen.deviation = placed->deviation;
        hang(frozen, *state, placed->scan, placed->inMap);
        file(std::move(frozen), kind);
        return;
    }
    const auto baseInMap = m_setup.robotInMap(frozen.robot);
    if (!baseInMap) {
        m_setup.notify(fill(translate("leitstand::Station", "{} is not in the map yet: nothing was filed"),
                            robot(frozen.robot)->title));
        return;
    }
    // A rough place is better than none: the operator moves it.
    frozen.deviation = NearbyDeviation;
    const Eigen::Vector3d ahead = *baseInMap * Eigen::Vector3d(Nearby, 0.0, 0.0);
    hang(frozen, *state, scanBeside(*state, frozen.robot, ahead), ahead);
    file(std::move(frozen), kind);
    m_setup.notify(
        translate("leitstand::Station", "no range there: filed ahead of the robot; move it on the map"));
}

MissionStatePtr FindDesk::known() {
    MissionStatePtr now = m_setup.mission();
    const auto arrived = [&](const FindSample& recorded) {
        return std::any_of(now->decisions->rbegin(), now->decisions->rend(), [&](const Decision& decision) {
            const auto* one = std::get_if<FindSample>(&decision.content);
            return one != nullptr && one->station == recorded.station && one->kind == recorded.kind &&
                   one->number == recorded.number && one->stamp == recorded.stamp;
        });
    };
    std::erase_if(m_recorded, arrived);
    if (m_recorded.empty()) return now;
    auto ahead = std::make_shared<MissionState>(*now);
    for (const FindSample& one : m_recorded) decide(*ahead, {++ahead->sequence, one.stamp, false, one});
    return ahead;
}

Result<void> FindDesk::keep(const FindSample& sample) {
    auto recorded = m_setup.record(sample);
    if (recorded) m_recorded.push_back(sample);
    return recorded;
}

void FindDesk::file(FrozenEvidence frozen, FindSample::Kind kind) {
    const std::scoped_lock filing(m_filing);
    const MissionStatePtr state = known();
    const auto robot = state->robots.find(frozen.robot);
    if (robot != state->robots.end() && robot->second->mode)
        frozen.autonomous = robot->second->mode->sample.autonomous;
    // Its mode when the operator pressed, not when the place was computed.
    frozen.autonomous = m_modes.autonomousAt(frozen.robot, frozen.found).value_or(frozen.autonomous);
    // Candidates of the station that are there are the same thing.
    const auto candidates = candidatesNear(*state, kind, frozen.positionInMap);
    for (const CandidateSample& one : candidates) addCues(frozen, one);
    const FindSample sample = filed(*state, kind, frozen, m_setup.station, m_setup.now());
    const bool joined = state->finds->contains({sample.kind, sample.number});
    if (const auto recorded = enter(sample, joined, candidates); !recorded)
        m_setup.notify(recorded.error().text);
}

void FindDesk::file(const CandidateSample& candidate, const FrozenEvidence& seen) {
    const std::scoped_lock filing(m_filing);
    const MissionStatePtr state = known();
    const FindSample sample = filedFrom(*state, candidate, m_setup.station, m_setup.now(), seen);
    const bool joined = state->finds->contains({sample.kind, sample.number});
    if (const auto recorded = enter(sample, joined, {candidate}); !recorded)
        m_setup.notify(recorded.error().text);
}

Result<void> FindDesk::enter(const FindSample& sample, bool joined,
                             const std::vector<CandidateSample>& candidates) {
    if (auto recorded = keep(sample); !recorded) return recorded;
    const FindKey key{sample.kind, sample.number};
    {
        const std::scoped_lock lock(m_mutex);
        m_newest = key;
        ++m_filings;
    }
    const bool confirmed = sample.status == FindSample::Status::Confirmed;
    m_setup.notify(
        fill(confirmed ? translate("leitstand::Station", "{} has new evidence; it is confirmed already")
             : joined  ? translate("leitstand::Station", "{} has new evidence: press again to confirm")
                       : translate("leitstand::Station", "{} filed: press again to confirm"),
             nameOf(key.first, key.second)));
    for (const CandidateSample& one : candidates) {
        auto recorded = m_setup.recordCandidate(filedAs(one, sample.number, m_setup.station, m_setup.now()));
        if (!recorded) return recorded;
    }
    return {};
}

std::uint64_t FindDesk::filings() const {
    const std::scoped_lock lock(m_mutex);
    return m_filings;
}

std::optional<FindKey> FindDesk::newest() const {
    const std::scoped_lock lock(m_mutex);
    return m_newest;
}

Result<void> FindDesk::record(const std::optional<FindSample>& sample, const FindKey& find) {
    if (!sample)
        return Error{fill(translate("leitstand::Station", "{}: the mission has no such find to change so"),
                          nameOf(find.first, find.second))};
    return keep(*sample);
}

std::optional<FrozenEvidence> FindDesk::look(const RobotDescription& robot, const RobotEvidence& recent,
                                             const Eigen::Vector3d& inMap, Time pressed) const {
    const FrozenEvidence frozen =
        chooseEvidence(robot, recent, FindSample::Kind::Victim, {}, std::nullopt).frozen;
    const auto pictures = picturesOf(frozen, recent, pressed - RecentEvidence::Pictures);
    if (pictures.empty()) return std::nullopt;
    const auto promise = std::make_shared<std::promise<std::vector<bool>>>();
    auto answer = promise->get_future();
    m_setup.shows(pictures, inMap, [promise](const std::vector<bool>& shown) { promise->set_value(shown); });
    if (answer.wait_for(LongestSearch) != std::future_status::ready) return std::nullopt;
    const std::vector<bool> shown = answer.get();
    std::vector<Event> kept;
    for (std::size_t i = 0; i < std::min(shown.size(), pictures.size()); ++i) {
        if (shown[i]) kept.push_back(pictures[i]);
    }
    if (kept.empty()) return std::nullopt;
    FrozenEvidence seen = withPictures(frozen, kept);
    seen.found = pressed;
    return seen;
}

Result<void> FindDesk::fileCandidate(std::uint32_t id) {
    const MissionStatePtr state = m_setup.mission();
    const auto entry = state->candidates->find(id);
    if (entry == state->candidates->end())
        return Error{translate("leitstand::Station", "the mission has no such candidate")};
    const CandidateSample candidate = entry->second.candidate;
    const Time pressed = m_setup.now();
    std::map<const RobotDescription*, RobotEvidence> recent;
    for (const Cue& cue : candidate.cues) {
        if (const auto* const one = robot(cue.robot))
            recent.try_emplace(one, m_recent.of(cue.robot, pressed));
    }
    submitFiling(
        [this, candidate, inMap = positionInMap(*state, candidate), pressed, recent = std::move(recent)] {
            FrozenEvidence seen;
            seen.found = pressed;
            for (const auto& [robot, evidence] : recent) {
                const auto looked = look(*robot, evidence, inMap, pressed);
                if (!looked) continue;
                seen = *looked;
                break;
            }
            file(candidate, seen);
        });
    return {};
}

Result<void> FindDesk::dismiss(std::uint32_t candidate) {
    const std::scoped_lock filing(m_filing);
    const MissionStatePtr state = m_setup.mission();
    const auto entry = state->candidates->find(candidate);
    if (entry == state->candidates->end())
        return Error{translate("leitstand::Station", "the mission has no such candidate")};
    return m_setup.recordCandidate(judged(entry->second.candidate, true, m_setup.station, m_setup.now()));
}

Result<void> FindDesk::confirm(const FindKey& find) {
    const std::scoped_lock filing(m_filing);
    return record(withStatus(*known(), find, FindSample::Status::Confirmed, m_setup.station, m_setup.now()),
                  find);
}

std::optional<FindKey> FindDesk::unconfirmed() {
    const std::scoped_lock filing(m_filing);
    const auto key = newest();
    const MissionStatePtr state = known();
    const auto entry = key ? state->finds->find(*key) : state->finds->end();
    const bool open =
        entry != state->finds->end() && entry->second.victim.status == FindSample::Status::Hypothesis;
    return open ? key : std::nullopt;
}

bool FindDesk::isFiling() const {
    const std::scoped_lock lock(m_mutex);
    return m_awaited > 0;
}

bool FindDesk::filedLast() const {
    const std::scoped_lock lock(m_mutex);
    return m_filedLast;
}

Result<void> FindDesk::confirmNewest() {
    if (isFiling()) {
        m_queue.submit(
            [this](const std::stop_token&) {
                // When the last filing had no result, which was reported, nothing older is confirmed in its
                // place.
                const auto key = filedLast() ? unconfirmed() : std::nullopt;
                if (!key) return;
                if (const auto done = confirm(*key); !done) m_setup.notify(done.error().text);
            },
            /*cancellable=*/false);
        return {};
    }
    const auto key = unconfirmed();
    if (!key)
        return Error{translate("leitstand::Station",
                               "Nothing is filed that could be confirmed: F files what the robot sees")};
    return confirm(*key);
}

Result<void> FindDesk::discard(const FindKey& find) {
    const std::scoped_lock filing(m_filing);
    return record(withStatus(*known(), find, FindSample::Status::Discarded, m_setup.station, m_setup.now()),
                  find);
}

Result<void> FindDesk::merge(const FindKey& find, std::uint32_t into) {
    const std::scoped_lock filing(m_filing);
    return record(mergedInto(*known(), find, into, m_setup.station, m_setup.now()), find);
}

Result<void> FindDesk::move(const FindKey& find, const Eigen::Vector3d& floorInMap) {
    const std::scoped_lock filing(m_filing);
    return record(movedTo(*known(), find, floorInMap, m_setup.station, m_setup.now()), find);
}

Result<void> FindDesk::edit(const FindSample& form) {
    const std::scoped_lock filing(m_filing);
    return record(filledIn(*known(), form, m_setup.station, m_setup.now()), {form.kind, form.number});
}

Result<void> FindDesk::undo() {
    const MissionStatePtr state = m_setup.mission();
    const auto& all = *state->decisions;
    const auto decision = std::find_if(all.rbegin(), all.rend(), [this](const Decision& one) {
        const auto* sample = std::get_if<FindSample>(&one.content);
        return sample != nullptr && !one.undone && sample->station == m_setup.station;
    });
    const std::uint64_t newest = decision == all.rend() ? 0 : decision->sequence;
    if (const CandidateSample* candidate = newestDismissal(*state, m_setup.station, newest))
        return m_setup.recordCandidate(judged(*candidate, false, m_setup.station, m_setup.now()));
    if (decision != all.rend()) {
        const auto& sample = std::get<FindSample>(decision->content);
        return m_setup.undo(
            {m_setup.now(), m_setup.station, decision->sequence,
             undoText({.kind = UndoneThing::Kind::Find, .find = nameOf(sample.kind, sample.number)})});
    }
    return Error{translate("leitstand::Station", "there is nothing on finds to take back")};
}

}  // namespace leitstand
