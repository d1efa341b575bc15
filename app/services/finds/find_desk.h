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

/// The place of something that a picture shows.
struct PlacedFind {
    std::uint64_t scan = 0;                           ///< key scan it is attached to; 0: none
    Eigen::Vector3d inMap = Eigen::Vector3d::Zero();  ///< [m]
    double deviation = Unknown;                       ///< [m]
};

/// The functions that a FindDesk uses. All may be called on any thread.
struct FindDeskSetup {
    using Located = std::function<void(const std::optional<PlacedFind>&)>;
    std::vector<RobotDescription> robots = {};
    std::string station = {};  ///< persistent identity
    std::function<MissionStatePtr()> mission = {};
    std::function<Result<void>(const FindSample&)> record = {};
    std::function<Result<void>(const CandidateSample&)> recordCandidate = {};
    std::function<Result<void>(const UndoSample&)> undo = {};
    /// Requests the place of what @p chosen shows; answers once, on any thread. Empty answer: no place.
    std::function<void(const ChosenEvidence& chosen, Located answer)> locate = {};
    using Shown = std::function<void(const std::vector<bool>&)>;
    /// Requests which of @p pictures show the place @p inMap [m]; answers once, on any thread, with a flag
    /// for each.
    std::function<void(std::vector<Event> pictures, const Eigen::Vector3d& inMap, Shown answer)> shows = {};
    /// Pose of a robot in the map now; empty: unknown.
    std::function<std::optional<Pose>(const std::string& robot)> robotInMap = {};
    std::function<void(const std::string&)> notify = {};  ///< for the operator, in words
    std::function<Time()> now = {};                       ///< station's clock
};

/// Files what the operator finds: freezes evidence, and confirms, changes and takes back finds. Each of these
/// is an entry of the log. Any thread.
class FindDesk : public EventSink {
public:
    explicit FindDesk(FindDeskSetup setup);
    ~FindDesk() override { finish(); }

    void onEvent(const Event& event) override {
        m_recent.onEvent(event);
        m_modes.onEvent(event);
    }
    void finish();  ///< waits until everything frozen is filed

    /// Freezes what @p robot saw in the last seconds, and files it as a find of @p kind. Its place is what
    /// the picture shows at @p at. Without @p at it is, for a victim, the hot spot of a thermal picture, else
    /// the middle of the camera @p looksThrough. Without a range there, the place is 1 m ahead of the robot;
    /// nothing is filed if the robot is not in the map. Joins a find that is there already.
    void freeze(const std::string& robot, FindSample::Kind kind, const std::string& looksThrough,
                const std::optional<PicturePoint>& at = std::nullopt);
    /// Freezes the same evidence of a find at @p placeInMap [m], to which the operator pointed on the map.
    void freezeAt(const std::string& robot, FindSample::Kind kind, const Eigen::Vector3d& placeInMap);
    /// Returns the find that was filed last; empty: none yet.
    [[nodiscard]] std::optional<FindKey> newest() const;
    /// Returns newest(), if nobody has confirmed or discarded it since.
    [[nodiscard]] std::optional<FindKey> unconfirmed();
    [[nodiscard]] bool isFiling() const;  ///< whether frozen evidence is still being filed
    /// For the operator's second press: confirms unconfirmed(). While isFiling(), confirms what is being
    /// filed once it is filed. Error: there is nothing to confirm.
    Result<void> confirmNewest();
    [[nodiscard]] std::uint64_t filings() const;  ///< number of filings so far; rises when newest() is set

    /// Files @p candidate with its cues, after a search of the newest pictures of the robots that reported
    /// them. Adds evidence of the first of these robots that sees the place now.
    Result<void> fileCandidate(std::uint32_t candidate);
    /// Rejects @p candidate: it stays off the list, also when it is seen again.
    Result<void> dismiss(std::uint32_t candidate);
    Result<void> confirm(const FindKey& find);
    Result<void> discard(const FindKey& find);
    Result<void> merge(const FindKey& find, std::uint32_t into);
    Result<void> move(const FindKey& find, const Eigen::Vector3d& floorInMap);
    /// Sets signs, situation, tag, area and text of a find as the operator filled them into @p form, which
    /// names the find by kind and number. All else of the find stays as it is.
    Result<void> edit(const FindSample& form);
    /// Takes back this station's newest entry on a find, or its newest rejection of a candidate if that is
    /// newer. Error when there is neither.
    Result<void> undo();

private:
    /// Returns the mission with all that was published here, also what has not reached the mission yet. Call
    /// with m_filing held.
    [[nodiscard]] MissionStatePtr known();
    Result<void> keep(const FindSample& sample);      ///< publishes @p sample; call with m_filing held
    void submitFiling(std::function<void()> filing);  ///< runs @p filing on the worker; isFiling() until then
    [[nodiscard]] bool filedLast() const;
    void file(FrozenEvidence frozen, FindSample::Kind kind);
    void locate(ChosenEvidence chosen, FindSample::Kind kind);
    void file(const CandidateSample& candidate, const FrozenEvidence& seen);
    /// Returns the evidence in @p recent of @p robot that shows the place @p inMap [m]. Empty: the robot
    /// looks elsewhere, or sent no picture recently.
    [[nodiscard]] std::optional<FrozenEvidence> look(const RobotDescription& robot,
                                                     const RobotEvidence& recent,
                                                     const Eigen::Vector3d& inMap, Time pressed) const;
    /// Publishes @p sample, notifies the operator, and marks @p candidates as filed in it. @p joined: the
    /// find was there before. Call with m_filing held.
    Result<void> enter(const FindSample& sample, bool joined, const std::vector<CandidateSample>& candidates);
    [[nodiscard]] const RobotDescription* robot(const std::string& name) const;
    Result<void> record(const std::optional<FindSample>& sample, const FindKey& find);

    const FindDeskSetup m_setup;
    RecentEvidence m_recent;
    ModeBook m_modes;
    mutable std::mutex m_mutex;
    std::mutex m_filing;  ///< entries are made one after another
    std::optional<FindKey> m_newest;
    std::uint64_t m_filings = 0;
    int m_awaited = 0;                   ///< filings that the worker has not finished
    bool m_filedLast = false;            ///< the filing that the worker finished last had a result
    std::vector<FindSample> m_recorded;  ///< may not have reached the mission yet; under m_filing
    JobQueue m_queue;
    std::jthread m_thread;  ///< last: joined first
};

}  // namespace leitstand
