#pragma once

#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <thread>
#include <vector>

#include "app/services/finds/freezing.h"
#include "app/services/finds/mode_book.h"
#include "app/services/finds/recent_evidence.h"
#include "app/services/job_queue.h"
#include "app/services/log/event_sink.h"
#include "core/base/result.h"
#include "core/event/candidate_sample.h"
#include "core/event/find_sample.h"
#include "core/mission/finds/find_book.h"
#include "core/robot/robot_description.h"

namespace leitstand {

struct UndoSample;

/// The place of a thing in a picture.
struct PlacedFind {
    std::uint64_t scan = 0;                           ///< key scan to which it is attached; 0: none
    Eigen::Vector3d inMap = Eigen::Vector3d::Zero();  ///< position in the map [m]
    double deviation = Unknown;                       ///< standard deviation [m]
};

/// The functions that a FindDesk uses. All of them may be called on any thread.
struct FindDeskSetup {
    using Located = std::function<void(const std::optional<PlacedFind>&)>;
    std::vector<RobotDescription> robots = {};
    std::string station = {};  ///< persistent identity
    std::function<MissionStatePtr()> mission = {};
    std::function<Result<void>(const FindSample&)> record = {};
    std::function<Result<void>(const CandidateSample&)> recordCandidate = {};
    std::function<Result<void>(const UndoSample&)> undo = {};
    /// Requests the place of what @p chosen shows. Calls `answer` once, on any thread; with nothing: no
    /// place.
    std::function<void(const ChosenEvidence& chosen, Located answer)> locate = {};
    using Shown = std::function<void(const std::vector<bool>&)>;
    /// Requests which of the pictures show the place @p inMap [m]. Calls `answer` once, on any thread, with a
    /// flag for each picture.
    std::function<void(std::vector<Event> pictures, const Eigen::Vector3d& inMap, Shown answer)> shows = {};
    /// Pose of a robot in the map now; empty: unknown.
    std::function<std::optional<Pose>(const std::string& robot)> robotInMap = {};
    std::function<void(const std::string&)> notify = {};  ///< called with a text for the operator
    std::function<Time()> now = {};                       ///< station's clock
};

/// Files what the operator finds: records evidence, and confirms, changes and undoes finds. Each of these is
/// an entry in the log. Any thread.
class FindDesk : public EventSink {
public:
    explicit FindDesk(FindDeskSetup setup);
    ~FindDesk() override { finish(); }

    void onEvent(const Event& event) override {
        m_recent.onEvent(event);
        m_modes.onEvent(event);
    }
    void finish();  ///< waits until everything that was frozen is filed

    /// Freezes what @p robot saw in the last seconds, and files it as a find of @p kind. Its place is what
    /// the picture shows at @p at. Without @p at, it is the hot spot of a thermal picture for a victim,
    /// otherwise the middle of the picture of the camera @p looksThrough. If no range is known there, the
    /// place is 1 m ahead of the robot. If the robot is not in the map, nothing is filed. If there is already
    /// a find at the place, the evidence is added to it.
    void freeze(const std::string& robot, FindSample::Kind kind, const std::string& looksThrough,
                const std::optional<PicturePoint>& at = std::nullopt);
    /// Freezes the same evidence for a find at @p placeInMap [m], at which the operator pointed on the map.
    void freezeAt(const std::string& robot, FindSample::Kind kind, const Eigen::Vector3d& placeInMap);
    /// Returns the find that was filed last; empty: none yet.
    [[nodiscard]] std::optional<FindKey> newest() const;
    /// Returns newest(), if nobody has confirmed or discarded it since.
    [[nodiscard]] std::optional<FindKey> unconfirmed();
    [[nodiscard]] bool isFiling() const;  ///< whether frozen evidence is still being filed
    /// For the operator's second press: confirms unconfirmed(). While isFiling(), confirms the find that is
    /// being filed as soon as it is filed. Error: there is nothing to confirm.
    Result<void> confirmNewest();
    /// Number of filings so far; increases when newest() is set.
    [[nodiscard]] std::uint64_t filings() const;

    /// Files @p candidate with its cues, after searching the newest pictures of the robots that reported
    /// them. Adds evidence from the first of these robots that sees the place now.
    Result<void> fileCandidate(std::uint32_t candidate);
    /// Rejects @p candidate: it stays off the list, even if it is seen again.
    Result<void> dismiss(std::uint32_t candidate);
    Result<void> confirm(const FindKey& find);
    Result<void> discard(const FindKey& find);
    Result<void> merge(const FindKey& find, std::uint32_t into);
    Result<void> move(const FindKey& find, const Eigen::Vector3d& floorInMap);
    /// Sets signs, situation, tag, area and text of a find to what the operator entered in @p form, which has
    /// the find's kind and number. Everything else about the find is kept.
    Result<void> edit(const FindSample& form);
    /// Undoes this station's newest entry about a find, or its newest rejection of a candidate if that is
    /// newer. Error when there is neither.
    Result<void> undo();

private:
    /// Returns the mission including everything that was published here, even if the mission does not have it
    /// yet. m_filing must be held.
    [[nodiscard]] MissionStatePtr known();
    Result<void> keep(const FindSample& sample);  ///< publishes @p sample; m_filing must be held
    /// Runs @p filing on the worker; isFiling() is true until then.
    void submitFiling(std::function<void()> filing);
    [[nodiscard]] bool filedLast() const;
    void file(FrozenEvidence frozen, FindSample::Kind kind);
    void locate(ChosenEvidence chosen, FindSample::Kind kind);
    void file(const CandidateSample& candidate, const FrozenEvidence& seen);
    /// Returns the evidence from @p robot in @p recent that shows the place @p inMap [m]. Empty: the robot
    /// looks elsewhere, or sent no picture recently.
    [[nodiscard]] std::optional<FrozenEvidence> look(const RobotDescription& robot,
                                                     const RobotEvidence& recent,
                                                     const Eigen::Vector3d& inMap, Time pressed) const;
    /// Publishes @p sample, notifies the operator, and marks @p candidates as filed in it. @p joined: whether
    /// the find existed before. m_filing must be held.
    Result<void> enter(const FindSample& sample, bool joined, const std::vector<CandidateSample>& candidates);
    [[nodiscard]] const RobotDescription* robot(const std::string& name) const;
    Result<void> record(const std::optional<FindSample>& sample, const FindKey& find);

    const FindDeskSetup m_setup;
    RecentEvidence m_recent;
    ModeBook m_modes;
    mutable std::mutex m_mutex;
    std::mutex m_filing;  ///< makes sure that entries are made one after another
    std::optional<FindKey> m_newest;
    std::uint64_t m_filings = 0;
    int m_awaited = 0;                   ///< number of filings that the worker has not finished
    bool m_filedLast = false;            ///< whether the last filing of the worker had a result
    std::vector<FindSample> m_recorded;  ///< entries that the mission may not have yet; under m_filing
    JobQueue m_queue;
    std::jthread m_thread;  ///< the last member, so that it is joined first
};

}  // namespace leitstand
