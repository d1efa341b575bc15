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
/// stays as it is. One thread writes, and waits for the disk; any thread may ask what was written.
class ReviewPen {
public:
    /// @p station: name of the writer; it begins with @ref ReviewStation.
    ReviewPen(std::filesystem::path mission, std::vector<RobotDescription> robots, std::string station,
              std::string version);
    ~ReviewPen();  ///< the mission is self-contained afterwards
    ReviewPen(const ReviewPen&) = delete;
    ReviewPen& operator=(const ReviewPen&) = delete;

    // Errors, in words: the mission cannot be written, for example while a station records into it.
    /// Writes a note about the moment @p at of the mission; @p robot may be empty.
    Result<void> note(Time at, const std::string& robot, const std::string& text);
    /// Replaces the find with the kind and number of @p victim by @p victim from now on. Error: the mission
    /// has no such find.
    Result<void> correct(FindSample victim);
    /// Files @p seen as a find of @p kind: a new one, or more evidence of one that is there.
    Result<void> file(FindSample::Kind kind, const FrozenEvidence& seen);
    /// Files the candidate with id @p candidate, which the station believed in and nobody filed.
    Result<void> fileCandidate(std::uint32_t candidate);
    /// Rejects the candidate with id @p candidate.
    Result<void> dismiss(std::uint32_t candidate);
    /// Merges @p find into the one of its kind with number @p into.
    Result<void> merge(const FindKey& find, std::uint32_t into);
    /// Moves @p find to the floor at @p floorInMap [m].
    Result<void> move(const FindKey& find, const Eigen::Vector3d& floorInMap);
    /// Sets the state of the mission as it was read: undo() can then take back entries of earlier reviews,
    /// too.
    void know(MissionStatePtr finished);
    /// Takes back the newest entry of reviews that is not taken back.
    Result<void> undo();
    [[nodiscard]] bool canUndo() const;
    /// Waits until other readers find in the mission what was written.
    Result<void> flush();

    /// Returns the state at the mission's end, with all that was written; null while nothing was.
    [[nodiscard]] MissionStatePtr state() const;
    /// Returns timeline marks of the notes that were written here and are not taken back.
    [[nodiscard]] std::vector<TimelineMark> marks() const;

private:
    Result<void> open();
    [[nodiscard]] MissionStatePtr newest() const;  ///< state(), else as it was read; null: neither
    [[nodiscard]] std::shared_ptr<LiveMission> mission() const;  ///< null while nothing was written
    Result<void> record(const Sample& sample, std::string_view topic);
    /// Returns the candidate with id @p id as it is now.
    Result<CandidateSample> candidate(std::uint32_t id);
    Result<void> recordCandidate(const CandidateSample& candidate);
    /// Waits until @p has returns true for the mission's state, which then holds what was published last. The
    /// sequencer takes no longer than a moment.
    Result<void> await(const std::function<bool(const MissionState&)>& has) const;
    [[nodiscard]] Error unknown(const FindKey& find) const;

    const std::filesystem::path m_folder;
    const std::vector<RobotDescription> m_robots;
    const std::string m_station, m_version;
    mutable std::mutex m_mutex;
    std::shared_ptr<LiveMission> m_mission;   ///< under the mutex
    MissionStatePtr m_read;                   ///< under the mutex; null: not yet
    std::atomic<std::uint64_t> m_before = 0;  ///< last sequence before this pen's events
};

}  // namespace leitstand
