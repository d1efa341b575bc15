#pragma once

#include <atomic>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>
#include <mutex>
#include <string>
#include <vector>

#include "core/base/result.h"
#include "core/event/find_sample.h"
#include "core/mission/finds/find_book.h"
#include "core/mission/state/mission_state.h"
#include "core/mission/timeline/timeline_marks.h"
#include "core/robot/robot_description.h"

namespace leitstand {

class Sample;
struct CandidateSample;
class LiveMission;

/// Writes what somebody finds in a review: notes, and finds as they should have been filed. Each entry is a
/// new event in a session of the mission; the pen opens the session with the first entry. What was recorded
/// is not changed. One thread writes and waits for the disk. Any thread may ask what was written.
class ReviewPen {
public:
    /// @p station: name of the writer, which begins with @ref ReviewStation.
    ReviewPen(std::filesystem::path mission, std::vector<RobotDescription> robots, std::string station,
              std::string version);
    ~ReviewPen();  ///< afterwards the mission is self-contained
    ReviewPen(const ReviewPen&) = delete;
    ReviewPen& operator=(const ReviewPen&) = delete;

    // Errors, in words: the mission cannot be written, for example while a station records into it.
    /// Writes a note about the moment @p at of the mission; @p robot may be empty.
    Result<void> note(Time at, const std::string& robot, const std::string& text);
    /// From now on, replaces the find with the kind and number of @p victim by @p victim. Error: the mission
    /// has no such find.
    Result<void> correct(FindSample victim);
    /// Files @p seen as a find of @p kind: a new one, or more evidence of an existing one.
    Result<void> file(FindSample::Kind kind, const FrozenEvidence& seen);
    /// Files the candidate with the id @p candidate, which the station reported and nobody filed.
    Result<void> fileCandidate(std::uint32_t candidate);
    /// Rejects the candidate with the id @p candidate.
    Result<void> dismiss(std::uint32_t candidate);
    /// Merges @p find into the find of the same kind with the number @p into.
    Result<void> merge(const FindKey& find, std::uint32_t into);
    /// Moves @p find to the floor at @p floorInMap [m].
    Result<void> move(const FindKey& find, const Eigen::Vector3d& floorInMap);
    /// Sets the state of the mission as it was read, so that undo() can also undo entries of earlier reviews.
    void know(MissionStatePtr finished);
    /// Undoes the newest entry, of any review, that is not undone yet.
    Result<void> undo();
    [[nodiscard]] bool canUndo() const;
    /// Waits until other readers can find in the mission what was written.
    Result<void> flush();

    /// Returns the state at the mission's end, including everything that was written; null: nothing was
    /// written yet.
    [[nodiscard]] MissionStatePtr state() const;
    /// Returns timeline marks for the notes that were written here and are not undone.
    [[nodiscard]] std::vector<TimelineMark> marks() const;

private:
    Result<void> open();
    /// The state(); if that is null, the state that was read; null: neither exists.
    [[nodiscard]] MissionStatePtr newest() const;
    [[nodiscard]] std::shared_ptr<LiveMission> mission() const;  ///< null: nothing was written yet
    Result<void> record(const Sample& sample, std::string_view topic);
    /// Returns the present candidate with the id @p id.
    Result<CandidateSample> candidate(std::uint32_t id);
    Result<void> recordCandidate(const CandidateSample& candidate);
    /// Waits until @p has returns true for the mission's state, which then has what was published last. The
    /// sequencer takes no longer than a moment.
    Result<void> await(const std::function<bool(const MissionState&)>& has) const;
    [[nodiscard]] Error unknown(const FindKey& find) const;

    const std::filesystem::path m_folder;
    const std::vector<RobotDescription> m_robots;
    const std::string m_station, m_version;
    mutable std::mutex m_mutex;
    std::shared_ptr<LiveMission> m_mission;   ///< under the mutex
    MissionStatePtr m_read;                   ///< under the mutex; null: not set yet
    std::atomic<std::uint64_t> m_before = 0;  ///< last sequence before this pen's events
};

}  // namespace leitstand
