#include "app/services/review/review_pen.h"

#include <utility>
#include <variant>

#include "app/services/log/live_mission.h"
#include "app/services/log/sequencer.h"
#include "app/services/recorded/review_log.h"
#include "app/services/review/playing/newest_writing.h"
#include "app/services/review/playing/until_written.h"
#include "core/base/words.h"
#include "core/event/station_samples.h"
#include "core/event/station_topics.h"
#include "core/mission/finds/dismissal.h"
#include "core/mission/state/decision.h"
#include "core/mission/state/find_state.h"
#include "core/mission/state/scan_state.h"
#include "core/mission/state/undo_format.h"

namespace leitstand {
namespace {

std::string textOf(const Decision& decision) {
    using Kind = UndoneThing::Kind;
    if (const auto* victim = std::get_if<FindSample>(&decision.content))
        return undoText({.kind = Kind::ReviewedFind, .find = nameOf(victim->kind, victim->number)});
    return undoText({.kind = Kind::ReviewNote});
}

}  // namespace

ReviewPen::ReviewPen(std::filesystem::path mission, std::vector<RobotDescription> robots, std::string station,
                     std::string version)
    : m_folder(std::move(mission)),
      m_robots(std::move(robots)),
      m_station(std::move(station)),
      m_version(std::move(version)) {}

ReviewPen::~ReviewPen() = default;

Result<void> ReviewPen::open() {
    if (mission()) return {};
    if (isOfOthers(m_folder)) {
        return Error{
            leitstand::fill(translate("leitstand::Station",
                                      "{}: no station of ours recorded it, so that it stays as it is; "
                                      "nothing can be written into it"),
                            m_folder.string())};
    }
    LiveMissionSettings settings;
    settings.folder = m_folder;
    settings.robots = m_robots;
    settings.station = m_station;
    settings.title = ReviewTitle;
    settings.version = m_version;
    auto opened = LiveMission::open(settings);
    if (!opened) return opened.error();
    std::shared_ptr<LiveMission> made = std::move(opened).value();
    m_before = made->state()->sequence;
    const std::lock_guard lock(m_mutex);
    m_mission = std::move(made);
    return {};
}

std::shared_ptr<LiveMission> ReviewPen::mission() const {
    const std::lock_guard lock(m_mutex);
    return m_mission;
}

Result<void> ReviewPen::record(const Sample& sample, std::string_view topic) {
    if (auto opened = open(); !opened) return opened;
    const std::size_t before = mission()->state()->decisions->size();
    if (auto recorded = mission()->record(sample, topic); !recorded) return recorded;
    return await([before](const MissionState& state) { return state.decisions->size() != before; });
}

Result<void> ReviewPen::recordCandidate(const CandidateSample& candidate) {
    if (auto opened = open(); !opened) return opened;
    if (auto recorded = mission()->record(candidate, station_topic::Candidates); !recorded) return recorded;
    return await([&candidate](const MissionState& state) {
        const auto known = state.candidates->find(candidate.id);
        return known != state.candidates->end() && known->second.candidate.stamp == candidate.stamp &&
               known->second.candidate.dismissed == candidate.dismissed &&
               known->second.candidate.victim == candidate.victim;
    });
}

Result<void> ReviewPen::await(const std::function<bool(const MissionState&)>& has) const {
    const auto written = mission();
    return untilWritten([&] { return has(*written->state()); },
                        [&]() -> std::string { return written->status().problem; });
}

Result<void> ReviewPen::note(Time at, const std::string& robot, const std::string& text) {
    if (text.empty()) return Error{translate("leitstand::Station", "a note without words is none")};
    return record(NoteSample{.stamp = at, .station = m_station, .robot = robot, .text = text},
                  station_topic::Notes);
}

Result<void> ReviewPen::correct(FindSample victim) {
    if (auto opened = open(); !opened) return opened;
    const FindKey find{victim.kind, victim.number};
    if (!mission()->state()->finds->contains(find)) return unknown(find);
    victim.stamp = stationTime();
    victim.station = m_station;
    return record(victim, station_topic::Victims);
}

Result<void> ReviewPen::file(FindSample::Kind kind, const FrozenEvidence& seen) {
    if (auto opened = open(); !opened) return opened;
    const MissionStatePtr state = mission()->state();
    FrozenEvidence now = seen;
    // The scan that it is attached to may have moved since the reviewed moment.
    if (const auto scan = state->keyScans->find(seen.scan); scan != state->keyScans->end())
        now.positionInMap = scan->second.pose.scanInMap * seen.positionInScan;
    return record(filed(*state, kind, now, m_station, stationTime()), station_topic::Victims);
}

Result<void> ReviewPen::fileCandidate(std::uint32_t id) {
    const auto known = candidate(id);
    if (!known) return known.error();
    const MissionStatePtr state = mission()->state();
    FrozenEvidence then;
    then.found = state->candidates->at(id).firstReport.stamp;
    const FindSample find = filedFrom(*state, *known, m_station, stationTime(), then);
    if (auto recorded = record(find, station_topic::Victims); !recorded) return recorded;
    // It was dismissed when the mission ended: that stays so, and a review cannot take it back.
    if (known->dismissed) return {};
    return recordCandidate(filedAs(*known, find.number, m_station, stationTime()));
}

Result<void> ReviewPen::dismiss(std::uint32_t id) {
    const auto known = candidate(id);
    if (!known) return known.error();
    // The first dismissal stays: an undo of a second one would bring back what the mission does not have.
    if (known->dismissed) return {};
    return recordCandidate(judged(*known, true, m_station, stationTime()));
}

Result<CandidateSample> ReviewPen::candidate(std::uint32_t id) {
    if (auto opened = open(); !opened) return opened.error();
    const MissionStatePtr state = mission()->state();
    if (const auto known = state->candidates->find(id); known != state->candidates->end())
        return known->second.candidate;
    return Error{translate("leitstand::Station", "the mission has no such candidate")};
}

Result<void> ReviewPen::merge(const FindKey& find, std::uint32_t into) {
    if (auto opened = open(); !opened) return opened;
    const auto merged = mergedInto(*mission()->state(), find, into, m_station, stationTime());
    return merged ? record(*merged, station_topic::Victims) : unknown(find);
}

Result<void> ReviewPen::move(const FindKey& find, const Eigen::Vector3d& floorInMap) {
    if (auto opened = open(); !opened) return opened;
    const auto moved = movedTo(*mission()->state(), find, floorInMap, m_station, stationTime());
    return moved ? record(*moved, station_topic::Victims) : unknown(find);
}

Error ReviewPen::unknown(const FindKey& find) const {
    return Error{leitstand::fill(translate("leitstand::Station", "{}: the mission has no {}"),
                                 m_folder.string(), nameOf(find.first, find.second))};
}

void ReviewPen::know(MissionStatePtr finished) {
    const std::lock_guard lock(m_mutex);
    m_read = std::move(finished);
}

MissionStatePtr ReviewPen::newest() const {
    const auto written = mission();
    if (written) return written->state();
    const std::lock_guard lock(m_mutex);
    return m_read;
}

bool ReviewPen::canUndo() const {
    const MissionStatePtr now = newest();
    return now && newestWriting(*now);
}

Result<void> ReviewPen::undo() {
    if (canUndo()) {
        if (auto opened = open(); !opened) return opened;
    }
    const MissionStatePtr now = newest();
    const ReviewWriting last = now ? newestWriting(*now) : ReviewWriting{};
    if (last.dismissal != nullptr)
        return recordCandidate(judged(*last.dismissal, false, m_station, stationTime()));
    if (last.decision == nullptr)
        return Error{
            translate("leitstand::Station", "nothing was written in reviews that could be taken back")};
    return record(UndoSample{.stamp = stationTime(),
                             .station = m_station,
                             .event = last.decision->sequence,
                             .text = textOf(*last.decision)},
                  station_topic::Undo);
}

Result<void> ReviewPen::flush() {
    const auto written = mission();
    return written ? written->flush() : Result<void>();
}

MissionStatePtr ReviewPen::state() const {
    const auto written = mission();
    return written ? written->state() : nullptr;
}

std::vector<TimelineMark> ReviewPen::marks() const {
    TimelineCollector collector;
    const MissionStatePtr now = state();
    if (!now) return {};
    for (const Decision& decision : *now->decisions) {
        const auto* const note = std::get_if<NoteSample>(&decision.content);
        if (decision.sequence <= m_before || decision.undone || note == nullptr) continue;
        Event event;
        event.sequence = decision.sequence;
        event.received = decision.received;
        event.sample = *note;
        collector.add(event);
    }
    return collector.marks();
}

}  // namespace leitstand
